#pragma once

#include <cstdint>

namespace scene {

/// Where a thing stands in the text: file is an index into scene::Description::files.
struct SourceRef {
    std::uint32_t file = 0;
    std::uint32_t line = 0;    ///< from 1; 0: made by the program, stands nowhere
    std::uint32_t column = 0;  ///< from 1, in bytes
};

}  // namespace scene
