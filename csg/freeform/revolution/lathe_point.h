#pragma once

#include "csg/base/numbers.h"
#include "numbers/lane_arithmetic.h"

namespace csg {

/// A point of an arc as a ray sees it.
struct LathePoint {
    double w;                      ///< parameter
    double radius, height, above;  ///< above the ray's foot
    double slope_radius, slope_above;
    double beyond;  ///< AxisRay::beyond
    bool out() const { return beyond > 0.0; }
};

/// Least and largest of a product of two numbers known at both ends, each monotone between them.
template <class T>
struct SlopeRangeOf {
    T least, most;  ///< of its amount
    lanes::Truth<T> negative;
};
template <class T>
inline SlopeRangeOf<T> slope_range(const T& a0, const T& a1, const T& b0, const T& b1)
{
    const T zero(0.0), a_size0 = lanes::size_of(a0), a_size1 = lanes::size_of(a1), b_size0 = lanes::size_of(b0),
                       b_size1 = lanes::size_of(b1);
    const auto least = [&](const T& v0, const T& v1, const T& size0, const T& size1) {
        return lanes::choose(lanes::differ(v0 < zero, v1 < zero), zero, lanes::smaller(size0, size1));
    };
    return {least(a0, a1, a_size0, a_size1) * least(b0, b1, b_size0, b_size1),
            lanes::larger(a_size0, a_size1) * lanes::larger(b_size0, b_size1),
            lanes::differ(a0 + a1 < zero, b0 + b1 < zero)};
}
/// Whether their difference cannot be 0.
template <class T>
inline lanes::Truth<T> apart(const SlopeRangeOf<T>& a, const SlopeRangeOf<T>& b)
{
    return lanes::differ(a.negative, b.negative) || a.least > b.most || b.least > a.most;
}
using SlopeRange = SlopeRangeOf<double>;

}  // namespace csg
