#pragma once

#include "render/kernel/subsurface/scattering.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace trace {

/// A row that waits for light from below.
struct SubsurfaceSite {
    std::size_t lane, row;
    std::uint32_t interior;
    glm::dvec3 point, normal, viewer;  ///< unit; the normal faces the viewer
    Scattering matter;
    std::uint64_t seed;
    glm::dvec3 base;  ///< rays are sent from there
    glm::dvec3 diffuse{0}, single{0}, unscattered{0};
    int met = 0;        ///< rays that met something
    double passed = 0;  ///< what of light that comes up passes the surface to the viewer

    double cosine() const { return glm::dot(normal, viewer); }
};

/// The viewer's ray below the surface.
struct WayBelow {
    glm::dvec3 direction, end, normal;
    double length;    ///< mm
    bool open, same;  ///< it goes in; it ends at the same object
};

/// Directions of a row's rays by octant, of which beams can be made.
class OctantOrder {
public:
    static constexpr std::size_t kOctants = 8;

    /// Takes so many of the directions, which go round, from a place that the seed gives.
    void sort(const std::vector<glm::dvec3>& directions, std::uint64_t seed, std::size_t samples)
    {
        const std::size_t cycle = directions.size(), first = seed % cycle;
        octant_.resize(samples);
        order_.resize(samples);
        begin_.fill(0);
        for (std::size_t i = 0, n = first; i < samples; ++i, n = n + 1 < cycle ? n + 1 : 0) {
            const glm::dvec3& d = directions[n];
            octant_[i] = static_cast<std::uint8_t>((d.x < 0.0 ? 1 : 0) | (d.y < 0.0 ? 2 : 0) | (d.z < 0.0 ? 4 : 0));
            ++begin_[octant_[i] + 1u];
        }
        for (std::size_t octant = 0; octant < kOctants; ++octant) begin_[octant + 1] += begin_[octant];
        auto next = begin_;
        for (std::size_t i = 0, n = first; i < samples; ++i, n = n + 1 < cycle ? n + 1 : 0)
            order_[next[octant_[i]]++] = static_cast<std::uint32_t>(n);
    }
    /// Numbers of the directions that lie there.
    std::span<const std::uint32_t> of(std::size_t octant) const
    {
        return {order_.data() + begin_[octant], order_.data() + begin_[octant + 1]};
    }

private:
    std::vector<std::uint32_t> order_;
    std::vector<std::uint8_t> octant_;  ///< by sample
    std::array<std::size_t, kOctants + 1> begin_;
};

/// What light below surfaces keeps per thread; grows to what the scene needs and stays.
struct SubsurfaceScratch {
    std::vector<SubsurfaceSite> sites;
    std::vector<WayBelow> ways;  ///< by site
    OctantOrder order;
};

}  // namespace trace
