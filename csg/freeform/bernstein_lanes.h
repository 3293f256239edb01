#pragma once

#include "csg/base/lanes.h"
#include "csg/roots/lane_newton.h"

#include <array>

/// Polynomials by their Bernstein ordinates, one in each lane. Compiled once per instruction set.
namespace csg::lanes {

/// detail::only_change() of the quartics asked for, to the last bit: alone, each would wait for its quotients.
inline Double only_changes(const std::array<Double, 5>& b, std::uint32_t asked)
{
    constexpr double kClose = 1e-15;
    constexpr int kMostSteps = 300;
    const Double zero(0.0), one(1.0), three(3.0), four(4.0), six(6.0);
    const Double chord = b[0] / (b[0] - b[4]);
    const Double c[5] = {b[0], four * (b[1] - b[0]), six * (b[2] - Double(2.0) * b[1] + b[0]),
                         four * (b[3] - three * b[2] + three * b[1] - b[0]),
                         b[4] - four * b[3] + six * b[2] - four * b[1] + b[0]};
    NewtonOf<true> newton{zero, one, xsimd::select((chord > zero) & (chord < one), chord, Double(0.5)), b[0] <= zero,
                          one};
    for (int i = 0; i < kMostSteps && asked != 0; ++i) {
        Double value = c[4], slope(0.0);
        for (std::size_t k = 4; k-- > 0;) {
            slope = slope * newton.t + value;
            value = value * newton.t + c[k];
        }
        newton.step({value, slope}, Double(kClose) * xsimd::abs(newton.t), asked);
    }
    return newton.t;
}

}  // namespace csg::lanes
