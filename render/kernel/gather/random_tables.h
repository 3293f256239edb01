#pragma once

#include <array>
#include <cstdint>
#include <vector>

/// POV-Ray's own random numbers, without which its pictures of photons cannot be met pixel for pixel (spec 6, 1.3).
namespace trace {

/// A table of numbers in [0, 1) and a place in it. Drawing moves on first, so the first number of the table comes last.
class JitterStream {
public:
    double draw()
    {
        at_ = (at_ + 1) % kLength;
        return table()[at_];
    }
    /// Moves on by so many numbers.
    void skip(std::uint64_t draws) { at_ = static_cast<std::uint32_t>((at_ + draws) % kLength); }

private:
    static constexpr std::uint32_t kLength = 32768;
    static const std::vector<double>& table();
    std::uint32_t at_ = 0;
};

/// The C library's generator as it is without a seed: additive feedback over 31 words.
class LibraryRandom {
public:
    LibraryRandom();
    /// In [0, 2^31).
    std::uint32_t draw();

private:
    static constexpr std::size_t kWords = 31, kTap = 3;
    std::array<std::uint32_t, kWords> words_;
    std::size_t at_ = kTap;
};

}  // namespace trace
