#pragma once

#include "render/kernel/radiosity/samples/pass_tile.h"
#include "render/scene/base/povray.h"

#include <vector>

namespace trace::radiosity {

/// The rays of one pass over the picture.
struct Pass {
    int number = 0;
    double step = 1;  ///< pixels between rays
    bool pretrace = true;
    double shift = 0;  ///< of its rays, pixels to the right and down: in POV-Ray 3.8 half a pixel back (spec 7d, 8)
};

/// The pretrace passes that the settings ask for (spec 6, 4.7), and a last one over all pixels by the rules of the
/// picture itself.
std::vector<Pass> passes(double pretrace_start, double pretrace_end, int width, int height, scene::PovRay povray);

/// The parts of a picture that POV-Ray looks at by themselves, whatever the block size is here.
struct Parts {
    static constexpr int kSide = 32;  ///< pixels
    int width, height;

    int columns() const { return (width + kSide - 1) / kSide; }
    int count() const { return columns() * ((height + kSide - 1) / kSide); }
};

/// Rays of a pass in one part, jittered as POV-Ray does.
std::vector<glm::dvec2> rays_of(const Pass& pass, const Parts& parts, int part);

}  // namespace trace::radiosity
