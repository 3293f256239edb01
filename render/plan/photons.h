#pragma once

#include "csg/base/types.h"
#include "render/scene/effects.h"

#include <limits>
#include <string>
#include <vector>

/// What a scene asks of photons, ready for the pass that shoots them (spec 6, 3.1 and 3.2).
namespace plan {

/// A way that light may go: what an object says of it and what a light does.
enum class Consent : std::uint8_t { Unset, On, Off };
inline Consent consent(const std::optional<bool>& written)
{
    return !written ? Consent::Unset : *written ? Consent::On : Consent::Off;
}
/// One side asks for it and the other does not forbid it.
inline bool agree(Consent a, Consent b)
{
    return (a == Consent::On && b != Consent::Off) || (b == Consent::On && a != Consent::Off);
}

/// How photons find a surface; one entry for each combination in use.
struct PhotonSurface {
    static constexpr std::uint32_t kNoTarget = 0xffffffffu;
    std::uint32_t target = kNoTarget;  ///< index into PhotonPlan::targets
    Consent reflection = Consent::Unset, refraction = Consent::Unset;
    bool pass_through = false;
    bool collect = true;  ///< photons stay there, and are seen
    friend bool operator==(const PhotonSurface&, const PhotonSurface&) = default;
};

/// An object that lights shoot at: photons are sent toward the sphere around its box.
struct PhotonTarget {
    glm::dvec3 center{0};
    double radius = 0, density = 1;
    Consent reflection = Consent::Unset, refraction = Consent::Unset;
    bool collect = true, global_lights = true;
};

/// The photon part of a light, by its place in CompiledScene::lights.
struct PhotonLight {
    Consent reflection = Consent::Unset, refraction = Consent::Unset;
    bool area = false;      ///< sent from all of its area
    bool parallel = false;  ///< as written: a cylinder is not of itself
    bool shoots = false;    ///< it stands in no group and casts shadows
};

struct PhotonPlan {
    scene::PhotonSettings settings;
    int max_trace_level = 5;
    double adc_bailout = 1.0 / 255.0;
    std::vector<PhotonSurface> surfaces{{}};  ///< by Surface::photons
    std::vector<PhotonTarget> targets;        ///< in order of declaration
    std::vector<PhotonLight> lights;
    scene::Place place;  ///< of the settings in the text, for messages
};

}  // namespace plan
