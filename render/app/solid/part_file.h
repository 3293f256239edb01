#pragma once

#include "render/scene/object.h"

#include <array>
#include <string>

/// What files of parts have in common.
namespace app {

/// The sRGB colour of an object's plain pigment, with the scene's numbers taken as light: the first that is found.
bool color_of(const scene::Object& object, std::array<double, 3>& out);

/// In quotes, as JSON has it.
std::string json_text(const std::string& text);

}  // namespace app
