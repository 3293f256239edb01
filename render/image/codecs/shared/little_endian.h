#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Numbers of several bytes, the lowest first.
namespace image {

/// The number of up to four bytes at a place; nothing where the file ends before.
inline std::optional<std::uint32_t> number_at(const std::vector<std::uint8_t>& bytes, std::size_t at,
                                              std::size_t length)
{
    if (length > bytes.size() || at > bytes.size() - length) return std::nullopt;
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < length; ++i) out |= std::uint32_t{bytes[at + i]} << (8 * i);
    return out;
}

/// Two and four bytes at the end of a text.
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
