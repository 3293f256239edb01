#pragma once

#include <cmath>

namespace numbers {

/// A function and its derivative at one place.
struct ValueAndSlope {
    double value, slope;
};

/// When a step is taken as the last: it is no longer than `absolute` plus `relative` of the parameter.
struct StepEnd {
    double absolute = 0.0, relative = 0.0;
};

/// The change of sign between lo and hi, looked for from t on: Newton, kept inside the bracket by bisection (Press et
/// al., Numerical Recipes, 9.4). It ends with a step that is short enough, with one that is none, and after `most`.
/// \tparam halving of polynomials: from afar Newton gains but a part 1 / degree a step, so bisection wherever a step is
/// not half the last. A step too short to move t ends the search, as some root lies within `degree` such steps;
/// bisection would come back to it from the far end of the bracket, a digit a step.
/// \param at ValueAndSlope of a place
template <bool halving = false, class At>
inline double safeguarded_newton(const At& at, double lo, double hi, bool negative_at_lo, double t, StepEnd end,
                                 int most = 100)
{
    [[maybe_unused]] double before = hi - lo;
    for (int i = 0; i < most; ++i) {
        const ValueAndSlope here = at(t);
        if (here.value == 0.0) return t;
        ((here.value < 0.0) == negative_at_lo ? lo : hi) = t;
        double next = t - here.value / here.slope;
        if constexpr (halving)
            if (next == t) return t;
        bool inside = next > lo && next < hi;
        if constexpr (halving) inside = inside && !(std::abs(next - t) > 0.5 * before);
        if (!inside) next = 0.5 * (lo + hi);
        const double step = std::abs(next - t);
        if (step <= end.absolute + end.relative * std::abs(t) || next == lo || next == hi) return next;
        if constexpr (halving) before = step;
        t = next;
    }
    return t;
}

}  // namespace numbers
