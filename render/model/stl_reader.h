#pragma once

#include "render/model/base/model.h"

#include <string_view>

namespace model {

/// Whether bytes are a binary STL file: 80 of anything, the number of triangles, and as many bytes as those take.
bool is_binary_stl(std::string_view bytes);

/// An STL file, text or binary: triangles alone, in the scene's space (STL is right-handed with z up: y and z change
/// places). Equal points are one vertex. Normals and what a file says of colours are passed over. Throws ModelError.
Model stl_of(std::string_view bytes);

}  // namespace model
