#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace trace {

/// e to the power of v, within 4e-13 of it; plain sums and products, so that loops of it go into vector lanes and every
/// instruction set gives the same bits. Beyond +-700 as there; NaN stays.
inline double media_exp(double v)
{
    constexpr double kPerTwo = 1.4426950408889634, kHigh = 0.693147180369123816490, kLow = 1.90821492927058770002e-10,
                     kRounds = 0x1.8p52;  // added: the number is rounded, and stands in the lowest bits
    const double x = v < -700.0 ? -700.0 : v > 700.0 ? 700.0 : v;
    const double shifted = x * kPerTwo + kRounds, k = shifted - kRounds;
    const double r = (x - k * kHigh) - k * kLow;
    // Terms in pairs, pairs in pairs: half as many steps wait for each other as in Horner's order.
    const double r2 = r * r, r4 = r2 * r2;
    const double low = (1.0 + r) + (0.5 + 1.0 / 6.0 * r) * r2,
                 middle = (1.0 / 24.0 + 1.0 / 120.0 * r) + (1.0 / 720.0 + 1.0 / 5040.0 * r) * r2,
                 high = (1.0 / 40320.0 + 1.0 / 362880.0 * r) + 1.0 / 3628800.0 * r2;
    const double sum = (low + middle * r4) + high * (r4 * r4);
    const auto scale = std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) + 1023u) << 52);
    return sum * scale;
}

inline glm::vec3 media_exp(const glm::vec3& v)
{
    if (v == glm::vec3(0)) return glm::vec3(1);
    std::array<double, 4> x{v.x, v.y, v.z, 0.0};  // side by side: lanes take no longer than one of them
    for (double& of : x) of = media_exp(of);
    return {static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2])};
}

}  // namespace trace
