#pragma once

#include <glm/glm.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

/// Vectors that are of unit length but for their last bits.
namespace numbers {

/// How many units in the last place the square of their length is off 1, at most; others are told by a root.
inline constexpr std::int64_t kUnitsOff = 8;

/// The inverse roots of the squares from that far below 1 to that far above.
inline const std::array<double, 2 * kUnitsOff + 1> kInverseRoots = [] {
    std::array<double, 2 * kUnitsOff + 1> roots{};
    for (std::size_t i = 0; i < roots.size(); ++i) {
        const std::int64_t bits = std::bit_cast<std::int64_t>(1.0) + static_cast<std::int64_t>(i) - kUnitsOff;
        roots[i] = 1.0 / std::sqrt(std::bit_cast<double>(bits));
    }
    return roots;
}();

/// glm::normalize() to the last bit, of a vector that most likely is a result of it: a table has what a root and a
/// quotient, for which all that follows would wait, would tell.
[[gnu::always_inline]] inline glm::dvec3 unit_again(const glm::dvec3& v)
{
    const double x = v.x, y = v.y, z = v.z, square = x * x + y * y + z * z;
    const std::int64_t off = std::bit_cast<std::int64_t>(square) - std::bit_cast<std::int64_t>(1.0);
    double inverse;
    if (off >= -kUnitsOff && off <= kUnitsOff) [[likely]] {
        inverse = kInverseRoots[static_cast<std::size_t>(off + kUnitsOff)];
    } else {
        asm volatile("");  // else a compiler may work the root out in any case
        inverse = glm::inversesqrt(square);
    }
    return {x * inverse, y * inverse, z * inverse};
}

}  // namespace numbers
