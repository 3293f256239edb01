#pragma once

#include "numbers/lanes.h"
#include "csg/freeform/shared/bernstein.h"
#include "numbers/lane_newton.h"

#include <array>

/// Polynomials by their Bernstein ordinates, one in each lane.
namespace csg::lanes {

/// detail::only_change() of the quartics asked for, to the last bit: alone, each would wait for its quotients.
inline Double only_changes(const std::array<Double, 5>& b, std::uint32_t asked)
{
    const Double zero(0.0), one(1.0);
    const Double chord = b[0] / (b[0] - b[4]);
    const std::array<Double, 5> c = detail::quartic_powers(b);
    NewtonOf<true> newton{zero, one, xsimd::select((chord > zero) & (chord < one), chord, Double(0.5)), b[0] <= zero,
                          one};
    for (int i = 0; i < detail::kMostLooks && asked != 0; ++i) {
        Double value = c[4], slope(0.0);
        for (std::size_t k = 4; k-- > 0;) {
            slope = slope * newton.t + value;
            value = value * newton.t + c[k];
        }
        newton.step({value, slope}, Double(detail::kClosePlace) * xsimd::abs(newton.t), asked);
    }
    return newton.t;
}

}  // namespace csg::lanes
