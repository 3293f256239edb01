#pragma once

#include "render/explain/ray_tree.h"
#include "render/picture/render.h"

namespace explain {

/// A pixel of a picture, explained by the ray through its middle.
struct Pixel {
    int x = 0, y = 0, width = 0, height = 0;
    std::unique_ptr<RayNode> tree;      ///< null: the camera has no ray there
    glm::vec3 rendered{0};              ///< what the tracer has for it without antialiasing
    std::vector<std::string> left_out;  ///< of the tree's sums
};

/// \param scene compiled from the description; its options say which picture \param options threads and isa
Pixel explain_pixel(const scene::Description& description, plan::CompiledScene& scene,
                    const trace::RenderOptions& options, int x, int y);

/// The whole explanation as text, places as path:line:column. \param shown the pixel's levels in the file
std::string pixel_text(const Pixel& pixel, const scene::Description& description, const glm::ivec3& shown);

}  // namespace explain
