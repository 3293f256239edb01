#pragma once

#include "render/image/pixels/image.h"
#include "render/plan/compiled_scene.h"
#include "render/picture/render.h"

#include <vector>

namespace study {

/// What each pixel cost, row by row.
struct Heat {
    int width = 0, height = 0;
    std::vector<float> ns;    ///< processor time of the pixel's ray and of all that follow from it
    std::vector<float> rays;  ///< of all kinds
};

/// One ray of the camera in the middle of each pixel, on one thread. The time of a tile of 8x8 rays, which are traced
/// together, is shared among its pixels by what each takes alone. Nothing where it was cancelled.
Heat measure_heat(const plan::CompiledScene& scene, const trace::RenderOptions& render);

/// Both quantities beside each other in false colours, each with its scale below.
image::Raster heat_picture(const Heat& heat);

/// The values themselves: red is nanoseconds, green is rays.
image::Image heat_values(const Heat& heat);

}  // namespace study
