#pragma once

#include "render/model/base/model.h"

#include <string_view>

namespace model {

/// Tells the materials of a Wavefront MTL file's names what they look like: Kd, d or Tr, Ke, map_Kd. The first file
/// that names a material counts. Throws ModelError.
void dress(Model& model, std::string_view text);

}  // namespace model
