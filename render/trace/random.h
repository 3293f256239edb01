#pragma once

#include <glm/glm.hpp>

#include <bit>
#include <cstdint>

namespace trace {

/// A number in [0, 1) that depends on the point and the purpose alone: the same picture for any order of work.
/// (POV-Ray draws from a stream per thread and differs from itself; spec 3, section 17.)
inline double random_at(const glm::dvec3& p, std::uint32_t purpose)
{
    // Mixing steps of splitmix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
    const auto stir = [](std::uint64_t v) {
        v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9u;
        v = (v ^ (v >> 27)) * 0x94d049bb133111ebu;
        return v ^ (v >> 31);
    };
    std::uint64_t h = stir(std::bit_cast<std::uint64_t>(p.x) + 0x9e3779b97f4a7c15u * (purpose + 1u));
    h = stir(h ^ std::bit_cast<std::uint64_t>(p.y));
    h = stir(h + std::bit_cast<std::uint64_t>(p.z));
    return static_cast<double>(static_cast<std::int64_t>(h >> 11)) * 0x1p-53;  // signed numbers are converted in lanes
}

}  // namespace trace
