#pragma once

#include "render/solid/files/write.h"

namespace solid {

/// glTF 2.0 in one binary file: a node, a mesh and a material for each part, by its name, with normals and, where the
/// pigment is no plain colour, a colour for each vertex. glTF is right-handed with y up: z is turned. Its unit is the
/// metre and ours the millimetre: a node about all has a scale of 0.001, numbers below it are the scene's.
std::string glb_bytes(const std::vector<FilePart>& parts);

}  // namespace solid
