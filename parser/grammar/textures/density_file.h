#pragma once

#include "render/scene/textures/volume.h"

#include <memory>
#include <string_view>

namespace parser {

/// A df3 file: three sizes of 16 bits, then samples of 8, 16 or 32 bits as the file's length tells, high bytes first
/// (spec 4, 5.7). Null where the length fits none.
std::shared_ptr<const scene::Volume> decode_density_file(std::string_view bytes);

}  // namespace parser
