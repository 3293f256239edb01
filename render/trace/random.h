#pragma once

#include <glm/glm.hpp>

#include <bit>
#include <cstdint>

namespace trace {

/// Mixing steps of splitmix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
inline std::uint64_t stirred(std::uint64_t v)
{
    v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9u;
    v = (v ^ (v >> 27)) * 0x94d049bb133111ebu;
    return v ^ (v >> 31);
}

/// For random_of: two vectors, as the origin and direction of a ray.
inline std::uint64_t random_seed(const glm::dvec3& a, const glm::dvec3& b)
{
    std::uint64_t h = 0x9e3779b97f4a7c15u;
    for (const double v : {a.x, a.y, a.z, b.x, b.y, b.z})
        h = stirred((h + 0x9e3779b97f4a7c15u) ^ std::bit_cast<std::uint64_t>(v));
    return h;
}

/// A number in [0, 1) that depends on these alone.
inline double random_of(std::uint64_t seed, std::uint32_t i, std::uint32_t n)
{
    const std::uint64_t h = stirred(seed + 0x9e3779b97f4a7c15u * ((std::uint64_t{i} << 32 | n) + 1u));
    return static_cast<double>(static_cast<std::int64_t>(h >> 11)) * 0x1p-53;
}

/// A number in [0, 1) that depends on the point and the purpose alone: the same picture for any order of work.
/// (POV-Ray draws from a stream per thread and differs from itself; spec 3, section 17.)
inline double random_at(const glm::dvec3& p, std::uint32_t purpose)
{
    std::uint64_t h = stirred(std::bit_cast<std::uint64_t>(p.x) + 0x9e3779b97f4a7c15u * (purpose + 1u));
    h = stirred(h ^ std::bit_cast<std::uint64_t>(p.y));
    h = stirred(h + std::bit_cast<std::uint64_t>(p.z));
    return static_cast<double>(static_cast<std::int64_t>(h >> 11)) * 0x1p-53;  // signed numbers are converted in lanes
}

}  // namespace trace
