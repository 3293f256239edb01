#pragma once

#include "render/texture/texture_set.h"

namespace trace {

/// Some pattern of any texture depends on the normal as layers have bent it: `slope` and `aoi`.
bool any_looks(const texture::TextureSet& set);

/// Some pattern that the texture uses does, but for those that come before all layers (of a texture map, its own).
bool looks_at_bent(const texture::TextureSet& set, std::uint32_t texture);

}  // namespace trace
