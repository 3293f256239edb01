#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace numbers {

/// Mixing steps of splitmix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
inline std::uint64_t stirred(std::uint64_t v)
{
    v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9u;
    v = (v ^ (v >> 27)) * 0x94d049bb133111ebu;
    return v ^ (v >> 31);
}

/// For random_of: where a ray starts and its direction. Their last digits don't count: how a ray was found, alone or
/// with others in lanes, changes them.
inline std::uint64_t random_seed(const glm::dvec3& origin, const glm::dvec3& direction)
{
    constexpr double kSteps = 0x1p17;  // of a component of the direction, and of the largest of the origin
    const double size = std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z), 0x1p-60});
    const double scale = std::ldexp(kSteps, -std::ilogb(size));
    std::uint64_t h = 0;
    for (int k = 0; k < 3; ++k)
        for (const double v : {origin[k] * scale, direction[k] * kSteps})
            h = stirred((h + 0x9e3779b97f4a7c15u) ^
                        static_cast<std::uint64_t>(static_cast<std::int64_t>(std::rint(v))));
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

}  // namespace numbers
