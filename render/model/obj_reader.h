#pragma once

#include "render/model/base/model.h"

#include <string_view>

namespace model {

/// A Wavefront OBJ file: v, vt, vn, f with polygons of any outline and indices from either end, usemtl. Lines that it
/// continues and either line end are read; names of groups, smoothing, libraries, lines, points and curves are passed
/// over. Throws ModelError.
Model obj_of(std::string_view text);

}  // namespace model
