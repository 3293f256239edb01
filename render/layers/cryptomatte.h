#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Cryptomatte (Friedman and Jones, "Fully automatic ID mattes with support for motion blur and transparency", 2015;
/// specification 1.2): which names a pixel shows, and how much of it each.
namespace layers {

/// MurmurHash3 of 32 bits (Appleby) with seed 0, as the specification asks for.
std::uint32_t murmur3(std::string_view text);

/// A name as the value of a channel: the bits of its hash, the exponent changed where they are no ordinary number.
float id_of(std::string_view name);

inline constexpr std::size_t kRanks = 6;  ///< names a pixel keeps, those of the largest shares
inline constexpr std::size_t kCryptomatteChannels = 2 * kRanks;

/// Names and shares of one pixel, largest first, in kCryptomatteChannels values. ids: of all samples, each as much of
/// the pixel; 0 is nothing.
void rank(std::span<const float> ids, float* out);

/// Names of the channels: "CryptoObject00.R" and so on.
std::vector<std::string> cryptomatte_channels();

/// What a file's header says: kind of hash, and each name with its hash.
std::vector<std::pair<std::string, std::string>> cryptomatte_attributes(const std::vector<std::string>& names);

}  // namespace layers
