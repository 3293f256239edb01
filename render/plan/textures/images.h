#pragma once

#include "render/scene/description.h"
#include "render/scene/textures/image_map.h"
#include "render/texture/image.h"

namespace plan {

/// An image_map, image_pattern, bump_map or material_map as written: levels decoded into the scene's working space, or
/// as stored where the text asks for nothing and the picture is not one of colours (spec 4, 12.3 to 12.5).
/// \param colors  an image_map
texture::Image compile_image(const scene::Description& scene, const scene::ImageMap& written, bool colors);

}  // namespace plan
