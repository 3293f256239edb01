#pragma once

#include "render/texture/noise/noise.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>

/// The tables behind the noise functions (spec 4, section 2). The compiler fills them: a run that needs none loads
/// none.
namespace texture {

struct NoiseTables {
    static constexpr std::size_t kHashSize = 4096;
    static constexpr std::size_t kLatticeNumbers = 267;
    static constexpr std::size_t kLatticeRows = kLatticeNumbers - 3;
    static constexpr std::size_t kGradients = 2048;
    static constexpr std::size_t kRandoms = 4100;  ///< cell hashes are below 4096, plus three components

    std::array<std::uint16_t, kHashSize + 1> hash;  ///< a permutation; then its first number again
    std::array<std::uint8_t, kHashSize> row;        ///< hash & 255: where a lattice point's row starts
    alignas(64) std::array<std::array<double, 4>, kLatticeRows> lattice;  ///< the i-th: four numbers from the i-th on
    /// The rows of all three components side by side, a cache line each.
    alignas(64) std::array<std::array<float, 16>, 256> singles;
    std::array<std::uint16_t, kHashSize> single_row;  ///< where a lattice point's line starts, in numbers
    std::array<glm::dvec3, kGradients> gradient;
    std::array<int, kGradients + 1> permutation;
    std::array<double, kRandoms> random;  ///< in [0, 1)
};

extern const NoiseTables kNoiseTables;

/// One step of the linear congruential generator behind the tables; 15 bits of its state.
constexpr int draw15(std::uint32_t& state)
{
    state = next_lcg(state);
    return static_cast<int>((state >> 16) & 0x7FFFu);
}

}  // namespace texture
