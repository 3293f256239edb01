#pragma once

#include "numbers/functions/functions.h"

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <numbers>

/// Directions around an axis, from two numbers in [0, 1).
namespace trace::path {

inline constexpr double kPi = std::numbers::pi;

/// Two unit vectors across a unit one (Duff et al., "Building an orthonormal basis, revisited", JCGT 6, 2017).
struct Across {
    glm::dvec3 a, b;

    explicit Across(const glm::dvec3& n)
    {
        const double sign = std::copysign(1.0, n.z), s = -1.0 / (sign + n.z), t = n.x * n.y * s;
        a = {1.0 + sign * n.x * n.x * s, sign * t, -sign * n.x};
        b = {t, sign + n.y * n.y * s, -n.y};
    }
};

/// At a cosine from the axis, unit.
inline glm::dvec3 around(const glm::dvec3& axis, double cosine, double turn)
{
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine)), angle = 2.0 * kPi * turn;
    const Across across(axis);
    return glm::normalize(sine * numbers::cos(angle) * across.a + sine * numbers::sin(angle) * across.b +
                          cosine * axis);
}

/// With a density of (e + 1) / (2 pi) cos^e around a unit axis.
inline glm::dvec3 power_direction(const glm::dvec3& axis, double e, const std::array<double, 2>& u)
{
    return around(axis, numbers::pow(1.0 - u[0], 1.0 / (e + 1.0)), u[1]);
}

}  // namespace trace::path
