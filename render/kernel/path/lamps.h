#pragma once

#include "render/light/illuminate.h"
#include "render/kernel/path/surface.h"

/// Next-event estimation towards the scene's light_sources.
namespace trace::path {

/// The lamp drawn for a hit, and what it would add there without shadows.
struct LampSample {
    const light::Light* light = nullptr;  ///< null: none shines here
    light::Illumination lit;
    glm::vec3 weight{0};  ///< factor of the light that arrives: BSDF * cosine * pi / probability of the lamp
};

/// Draws one lamp with a probability proportional to what its centre would add without shadows, and a point on it.
/// \param chances  scratch
LampSample sample_lamp(const Context& context, const HitPlace& hit, const Bsdf& bsdf, std::vector<double>& chances,
                       Draws& draws);

}  // namespace trace::path
