#pragma once

#include "numbers/functions/functions.h"
#include "render/texture/texture_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

/// Rough mirrors: docs/extensions.md.
namespace trace {

/// Directions around a mirrored one, as dense as a power of the cosine to it.
class RoughLobe {
public:
    RoughLobe(const texture::FinishExtension& rough, const glm::dvec3& mirrored, const glm::dvec3& normal)
        : exponent_(static_cast<double>(rough.gloss_exponent)), w_(mirrored), normal_(normal),
          u_(glm::normalize(glm::cross(w_, std::abs(w_.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)))),
          v_(glm::cross(w_, u_))
    {}

    /// \param at both in [0, 1)
    glm::dvec3 direction(const std::array<double, 2>& at) const
    {
        constexpr double kTurn = 2.0 * std::numbers::pi;
        const auto [a, b] = at;
        const double cosine = numbers::pow(1.0 - a, 1.0 / (exponent_ + 1.0)),
                     sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
        glm::dvec3 d = cosine * w_ + sine * (numbers::cos(kTurn * b) * u_ + numbers::sin(kTurn * b) * v_);
        const double away = glm::dot(d, normal_);
        if (away < 0.0) d -= 2.0 * away * normal_;  // folded back out, as a bent normal's mirrored ray is
        return glm::normalize(d);
    }

private:
    double exponent_;
    glm::dvec3 w_, normal_, u_, v_;
};

}  // namespace trace
