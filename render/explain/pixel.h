#pragma once

#include "render/kernel/record/record.h"
#include "render/picture/render.h"
#include "render/scene/description.h"

#include <string>
#include <vector>

/// Why a pixel has its colour. Colours are linear light as it is added up, before the picture's gamma.
namespace explain {

/// A pixel of a picture without antialiasing.
struct Pixel {
    int x = 0, y = 0;
    trace::Record record;              ///< what the kernel did for it
    std::vector<scene::Color> colors;  ///< by slot of the record: sums of what it tells
    glm::vec3 sum{0};                  ///< the pixel's, of those
    glm::vec3 rendered{0};             ///< what the kernel made of it
};

/// \param scene its options say which picture; antialiasing is switched off
/// \param options threads, isa, cancel, and what the passes have found; where that is null they are run
Pixel explain_pixel(plan::CompiledScene& scene, const trace::RenderOptions& options, int x, int y);

/// Light of a layer, of the shares that are told: before the layers above it dim it.
glm::vec3 light_of(const trace::RecordedRow& row);

/// The whole explanation as text, places as path:line:column.
/// \param description  that the scene was compiled from
/// \param shown  the pixel's levels in the file
std::string pixel_text(const Pixel& pixel, const scene::Description& description, const plan::CompiledScene& scene,
                       const glm::ivec3& shown);

}  // namespace explain
