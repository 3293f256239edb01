#pragma once

#include "render/scene/description.h"

#include <functional>
#include <string>
#include <vector>

namespace layers {

/// Texts of files by name; nothing where one can't be read.
using TextOf = std::function<std::string(const std::string& file)>;

/// A name for each object of the scene, in order: that of the `#declare` or `object { NAME }` which its text begins
/// with, else its keyword with file and line, as "sphere scene.pov:12". The second and later of a name get ".2", ".3".
std::vector<std::string> object_names(const scene::Description& scene, const TextOf& text_of);

}  // namespace layers
