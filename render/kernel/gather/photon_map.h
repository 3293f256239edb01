#pragma once

#include "render/scene/effects.h"
#include "render/kernel/gather/near_photons.h"
#include "render/kernel/gather/photon.h"
#include "render/kernel/gather/photon_boxes.h"
#include "render/kernel/gather/photon_places.h"
#include "render/kernel/gather/photon_reach.h"
#include "render/kernel/gather/random_tables.h"

#include <vector>

/// Photons at rest, in a tree that finds those around a point (spec 6, 3.7).
namespace trace {

/// What light takes from a photon.
struct PhotonRay {
    glm::vec3 flux, back;  ///< back: unit, to where it came from
};

class PhotonMap {
public:
    /// Builds the tree of photons in any order.
    void build(std::vector<Photon> photons);
    /// Takes photons in the order of a photon file, which is that of the tree.
    void take(std::vector<Photon> photons);

    bool empty() const { return photons_.empty(); }
    std::size_t size() const { return photons_.size(); }
    const std::vector<Photon>& photons() const { return photons_; }
    const PhotonRay& ray(std::uint32_t photon) const { return rays_[photon]; }

    /// The gather_most nearest within a radius. normal: of the surface, flattens the sphere; null: media.
    void find(const glm::dvec3& point, double radius, const glm::dvec3* normal, NearPhotons& out) const;

    /// Sets radius(): the one that the scene asks for, else POV-Ray's estimate (spec 6, 3.7), times the scene's factor.
    void find_radius(const scene::PhotonSettings& settings, bool media, LibraryRandom& random);
    double radius() const { return radius_; }

    int gather_least = 20, gather_most = 100;
    double expand_increase = 0.2, expand_least = 35.0;

    /// The photons that gather() may find for points in the box from `low` to `high`.
    PhotonReach reach(const glm::dvec3& low, const glm::dvec3& high) const
    {
        return {boxes_, low, high, kWider * radius_};
    }
    /// As find() with the map's radius, or three times that where too few are near. reach: that of points of which this
    /// is one.
    void gather(const glm::dvec3& point, const glm::dvec3* normal, const PhotonReach& reach, NearPhotons& scratch,
                NearPhotons& out) const;

private:
    static constexpr double kWider = 3.0;

    void find(const glm::dvec3& point, double radius, const glm::dvec3* normal, const PhotonReach& reach,
              NearPhotons& out) const;
    void find_among(const NearPhotons& wide, const glm::dvec3& point, const glm::dvec3* normal, NearPhotons& out) const;
    double estimated_radius(bool media, LibraryRandom& random) const;

    std::vector<Photon> photons_;
    std::vector<PhotonRay> rays_;  ///< by photon
    PhotonPlaces places_;
    PhotonBoxes boxes_;
    double radius_ = 0;
};

}  // namespace trace
