#pragma once

#include "render/model/base/model.h"

#include <string_view>

namespace model {

/// Whether bytes begin as those of a binary glTF file do.
bool is_glb(std::string_view bytes);

/// A binary glTF 2.0 file (Khronos glTF 2.0 specification), in the scene's space (glTF is right-handed with y up: z is
/// negated; a metre is a unit): the triangles, strips and fans that the nodes of its scene show, where these put them,
/// with NORMAL, TEXCOORD_0, COLOR_0 and what their materials say of base colour, opacity and emission. Throws
/// ModelError.
Model glb_of(std::string_view bytes);

}  // namespace model
