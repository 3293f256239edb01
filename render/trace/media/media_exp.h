#pragma once

#include <glm/glm.hpp>

#include <algorithm>
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
    double sum = 1.0 / 3628800.0;
    for (const double term :
         {1.0 / 362880.0, 1.0 / 40320.0, 1.0 / 5040.0, 1.0 / 720.0, 1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0})
        sum = sum * r + term;
    const auto scale = std::bit_cast<double>((std::bit_cast<std::uint64_t>(shifted) + 1023u) << 52);
    return sum * scale;
}

inline glm::vec3 media_exp(const glm::vec3& v)
{
    if (v == glm::vec3(0)) return glm::vec3(1);
    const auto x = static_cast<float>(media_exp(static_cast<double>(v.x)));
    if (v.x == v.y && v.x == v.z) return glm::vec3(x);
    return {x, static_cast<float>(media_exp(static_cast<double>(v.y))),
            static_cast<float>(media_exp(static_cast<double>(v.z)))};
}

}  // namespace trace
