#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// What each reader of foreign bytes defines for the two drivers, libfuzzer.cpp and replay.cpp. Whatever the bytes, the
/// reader answers or refuses with an exception of its own; anything else is a fault.
namespace fuzz {

using Bytes = std::vector<std::uint8_t>;

/// Reads one input.
void one(const Bytes& bytes);

/// Whole inputs from which changes start.
std::vector<Bytes> seeds();

inline Bytes bytes_of(std::string_view text) { return {text.begin(), text.end()}; }
inline std::string text_of(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

/// Bytes without a pattern, for a target whose bytes are choices.
inline Bytes noise(std::uint32_t seed, std::size_t count)
{
    std::uint32_t state = seed * 2654435761u;
    Bytes out;
    for (std::size_t i = 0; i < count; ++i)
        out.push_back(static_cast<std::uint8_t>((state = state * 1664525u + 1013904223u) >> 24));
    return out;
}

/// The sign of a NaN that arithmetic made is left open (IEEE 754, section 6.3): which operand it comes from is up to
/// the order of operands in the machine's instruction.
inline std::string without_sign_of_nan(std::string text)
{
    for (std::size_t at = 0; (at = text.find("-nan", at)) != std::string::npos;) text.erase(at, 1);
    return text;
}

/// Ends the program with this text: what was read contradicts itself.
[[noreturn]] void fail(const std::string& text);

inline void require(bool truth, const char* text)
{
    if (!truth) fail(text);
}

}  // namespace fuzz
