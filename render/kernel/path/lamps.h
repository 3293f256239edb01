#pragma once

#include "render/light/illuminate.h"
#include "render/kernel/path/surface.h"

/// Next-event estimation towards the scene's light_sources.
namespace trace::path {

/// A lamp that is asked from a hit.
struct LampSample {
    const light::Light* light = nullptr;  ///< null: none shines here
    light::Illumination lit;
    glm::vec3 weight{0};  ///< what light of the lamp's colour that arrives adds: BSDF times cosine, pi, over the chance
};

/// One lamp, drawn by what it would add without shadows, as seen from its middle, and a place of it.
LampSample sample_lamp(const Context& context, const HitPlace& hit, const Bsdf& bsdf, std::vector<double>& chances,
                       Draws& draws);

}  // namespace trace::path
