#pragma once

#include <cstdint>

namespace scene {

/// Where a thing stands in the text: `file` is an index into scene::Description::files. Objects have one each, messages
/// are few: so it is the byte, and line and column are looked up when they are told (scene::LineTable).
struct SourceRef {
    static constexpr std::uint32_t kNowhere = 0xffffffffu;
    std::uint32_t file = 0;
    std::uint32_t offset = kNowhere;  ///< in bytes from 0; kNowhere: made by the program

    bool somewhere() const { return offset != kNowhere; }
};

}  // namespace scene
