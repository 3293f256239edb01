#pragma once

#include <cstdint>
#include <string>

namespace image {

/// Numbers of two and four bytes at the end of a text, the lowest byte first.
inline void add_two(std::string& text, unsigned value)
{
    text += static_cast<char>(value & 0xff);
    text += static_cast<char>(value >> 8 & 0xff);
}

inline void add_four(std::string& text, std::uint32_t value)
{
    add_two(text, value & 0xffff);
    add_two(text, value >> 16);
}

}  // namespace image
