#pragma once

#include "render/model/base/model.h"

#include <string_view>

namespace model {

/// Whether bytes begin as those of a PLY file do.
bool is_ply(std::string_view bytes);

/// A PLY file, text or binary of either byte order, in the scene's space (taken for right-handed with z up: y and z
/// change places): x y z, nx ny nz, red green blue, s t (also u v, texture_u texture_v) of vertices, vertex_indices and
/// red green blue of faces, which may be polygons, and tristrips. Other elements and properties are passed over. Throws
/// ModelError.
Model ply_of(std::string_view bytes);

}  // namespace model
