#pragma once

#include "render/plan/compiled_scene.h"
#include "render/kernel/interior/interior_fade.h"
#include "render/kernel/tile/nearly_zero.h"
#include "render/kernel/tile/ray_state.h"

/// Where a ray crosses the surface of something that has an interior (spec 3, 8.2).
namespace trace {

/// How the interface turns a ray: incoming over outgoing; and what the ray is inside of afterwards.
struct Crossing {
    enum class Way : std::uint8_t {
        In,
        Out,         ///< of what was entered last
        OutOfOuter,  ///< of what was entered before that: unbent
    };
    double ratio = 1, dispersion = 1;
    int samples = 0;  ///< of the spectrum, where there is dispersion
    Way way = Way::In;

    bool disperses() const { return std::abs(dispersion - 1.0) >= kNearlyZero; }
    bool bends() const { return std::abs(ratio - 1.0) >= kNearlyZero || disperses(); }
};

[[gnu::always_inline]] inline Crossing crossing_of(const std::vector<plan::Interior>& interiors,
                                                   const InteriorList& list, std::uint32_t own)
{
    using Way = Crossing::Way;
    const auto ior = [&](std::uint32_t i) { return static_cast<double>(interiors[i].ior); };
    const auto dispersion = [&](std::uint32_t i) { return static_cast<double>(interiors[i].dispersion); };
    const int samples = interiors[own].dispersion_samples;
    if (list.empty()) return {1.0 / ior(own), 1.0 / dispersion(own), samples, Way::In};
    const std::uint32_t last = list.last();
    if (last == own) {
        if (list.size() == 1) return {ior(own), dispersion(own), samples, Way::Out};
        const std::uint32_t outer = list[list.size() - 2];
        return {ior(own) / ior(outer), dispersion(own) / dispersion(outer),
                std::max(samples, interiors[outer].dispersion_samples), Way::Out};
    }
    if (list.holds(own)) return {1, 1, 0, Way::OutOfOuter};
    return {ior(last) / ior(own), dispersion(last) / dispersion(own), samples, Way::In};
}

/// `out`: what the ray is inside of afterwards.
[[gnu::always_inline]] inline void cross(const std::vector<plan::Interior>& interiors, const InteriorList& list,
                                         std::uint32_t own, Crossing::Way way, InteriorList& out)
{
    out = list;
    if (way == Crossing::Way::In) return out.append(own);
    if (!interiors[own].hollow) out.uncloud();
    // remove_first would take an earlier entry of the body entered last.
    if (way == Crossing::Way::Out) out.remove_last();
    else out.remove_first(own);
}

/// What is left of light behind the surface, and on its way there inside of what the surface closes.
[[gnu::always_inline]] inline glm::vec3 fade_behind(const plan::Interior& interior, const InteriorList& list,
                                                    std::uint32_t own, double way)
{
    glm::vec3 fade(interior.transmission);
    if (list.holds(own)) fade *= interior_fade(interior, way, false);
    return fade;
}

/// Relative index for a fresnel reflection (spec 3, 7.9).
[[gnu::always_inline]] inline double fresnel_index(const std::vector<plan::Interior>& interiors,
                                                   const InteriorList& list, std::uint32_t own)
{
    if (own == plan::kNone) return 1.0;
    const auto inner = static_cast<double>(interiors[own].ior);
    if (list.empty()) return inner;
    const auto outer = static_cast<double>(interiors[list.last()].ior);
    if (!list.holds(own)) return inner / outer;
    return list.size() == 1 ? 1.0 / inner : outer / inner;
}

}  // namespace trace
