#pragma once

#include "render/scene/textures/texture.h"

namespace plan {

/// Whether the texture, or a part of it, lives on surface coordinates (uv_mapping).
bool uses_uv(const scene::TexturePtr& texture);

}  // namespace plan
