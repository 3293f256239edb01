#pragma once

#include "render/scene/base/color.h"

#include <glm/vec3.hpp>

namespace trace {

/// What a stretch of air makes of the colour that comes through it: colour * share + glow. Fog, rainbow and media all
/// are of this form and know nothing of that colour, so they are found when a ray has met its surface, whatever is
/// still to be traced behind it (spec 6, 1.6).
struct Air {
    glm::vec3 share{1}, glow{0};
    float clear = 1;  ///< share of the background's transparency (alpha output) that is left

    /// This stretch seen through a nearer one.
    void behind(const Air& nearer)
    {
        share *= nearer.share;
        clear *= nearer.clear;
        glow = glow * nearer.share + nearer.glow;
    }
    scene::Color operator()(const scene::Color& seen) const
    {
        scene::Color out = scene::Color::of(glow + seen.rgb() * share);
        out.transmit = seen.transmit * clear;
        return out;
    }
};

}  // namespace trace
