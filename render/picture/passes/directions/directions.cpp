#include "render/picture/passes/directions/directions.h"
#include "numbers/functions/functions.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace trace::radiosity {
namespace {

constexpr std::array<std::array<std::uint8_t, 3>, 1599> kLegacy{{
#include "render/picture/passes/directions/legacy_directions.inc"
}};

/// The digits of n mirrored at the point.
double radical_inverse(int base, int n)
{
    double sum = 0.0, place = 1.0;
    for (; n > 0; n /= base) {
        place /= base;
        sum += place * (n % base);
    }
    return sum;
}

}  // namespace

std::vector<glm::dvec3> directions(int pool)
{
    std::vector<glm::dvec3> out;
    const auto count = static_cast<std::size_t>(pool);
    out.reserve(count);
    if (count <= kLegacy.size()) {
        for (std::size_t i = 0; i < count; ++i)
            out.push_back(glm::normalize(glm::dvec3(2.0 * kLegacy[i][0] / 255.0 - 1.0, kLegacy[i][1] / 255.0,
                                                    2.0 * kLegacy[i][2] / 255.0 - 1.0)));
        return out;
    }
    for (int n = 1; n <= pool; ++n) {
        const double r2 = radical_inverse(2, n), r = std::sqrt(r2), t = 2.0 * std::numbers::pi * radical_inverse(3, n);
        out.emplace_back(r * numbers::cos(t), std::sqrt(1.0 - r2), r * numbers::sin(t));
    }
    return out;
}

}  // namespace trace::radiosity
