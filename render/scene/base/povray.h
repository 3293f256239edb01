#pragma once

#include <cstdint>

namespace scene {

/// The program whose rules a picture follows where they differ: that of the language's version, or what was asked for.
enum class PovRay : std::uint8_t { V37, V38 };

}  // namespace scene
