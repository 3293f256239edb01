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

/// Ends the program with this text: what was read contradicts itself.
[[noreturn]] void fail(const std::string& text);

inline void require(bool truth, const char* text)
{
    if (!truth) fail(text);
}

}  // namespace fuzz
