#pragma once

#include <array>
#include <cstdint>

/// A two-dimensional Sobol sequence, scrambled as Owen has it by a hash: Burley, "Practical hash-based Owen scrambling"
/// (JCGT 9, 2020), with the constants of Vegdahl's hash. Every number follows from the seed and its index alone.
namespace trace {

constexpr std::uint32_t reversed_bits(std::uint32_t v)
{
    v = (v >> 16) | (v << 16);
    v = ((v & 0x00ff00ffu) << 8) | ((v & 0xff00ff00u) >> 8);
    v = ((v & 0x0f0f0f0fu) << 4) | ((v & 0xf0f0f0f0u) >> 4);
    v = ((v & 0x33333333u) << 2) | ((v & 0xccccccccu) >> 2);
    return ((v & 0x55555555u) << 1) | ((v & 0xaaaaaaaau) >> 1);
}

/// Each bit is flipped or not by what the higher bits are: a nested uniform scramble.
constexpr std::uint32_t owen_scrambled(std::uint32_t v, std::uint32_t seed)
{
    v = reversed_bits(v);
    v ^= v * 0x3d20adeau;
    v += seed;
    v *= (seed >> 16) | 1u;
    v ^= v * 0x05526c56u;
    v ^= v * 0x53a22864u;
    return reversed_bits(v);
}

/// The second direction's generator matrix is Pascal's triangle modulo 2.
constexpr std::uint32_t sobol_second(std::uint32_t index)
{
    std::uint32_t out = 0;
    for (std::uint32_t v = 1u << 31; index != 0; index >>= 1, v ^= v >> 1)
        if (index & 1u) out ^= v;
    return out;
}

/// Point `index` of the sequence of a seed, each coordinate in [0, 1). Any first 2^k of them are stratified.
constexpr std::array<double, 2> sobol_point(std::uint32_t seed, std::uint32_t index)
{
    const std::uint32_t shuffled = owen_scrambled(index, seed ^ 0x9e3779b9u);
    const std::uint32_t x = owen_scrambled(reversed_bits(shuffled), seed * 0x85ebca6bu + 1u),
                        y = owen_scrambled(sobol_second(shuffled), seed * 0xc2b2ae35u + 2u);
    return {x * 0x1p-32, y * 0x1p-32};
}

}  // namespace trace
