#pragma once

#include "function/program.h"

#include <algorithm>
#include <limits>

namespace function {

/// All numbers from low to high: what a function may be somewhere in a box. Never empty. Operations widen by more than
/// their rounding, so that no value of the exact or the rounded function lies outside; where a function has no value
/// (sqrt of a negative number) that part is left out.
struct Interval {
    double low = 0.0, high = 0.0;

    Interval() = default;
    Interval(double v) : low(v), high(v) {}  // implicit: constants of formulas
    Interval(double l, double h) : low(l), high(h) {}
    static Interval everything()
    {
        return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    }

    bool point() const { return low == high; }
    bool contains(double v) const { return low <= v && v <= high; }
    Interval hull(const Interval& b) const { return {std::min(low, b.low), std::max(high, b.high)}; }
};

Interval operator+(const Interval& a, const Interval& b);
Interval operator-(const Interval& a, const Interval& b);
Interval operator*(const Interval& a, const Interval& b);
Interval operator/(const Interval& a, const Interval& b);
Interval squared(const Interval& a);
Interval sqrt(const Interval& a);
Interval field_limit(const Interval& a);

/// The function's first component over a box of its arguments. Some internal functions and splines answer `everything`.
Interval evaluate_interval(const Function& function, const Interval* arguments, const Host& host);
/// The same over eight boxes: low[i][lane], high[i][lane]. Hardly wider than evaluate_interval().
void evaluate_intervals(const Function& function, const double (*low)[8], const double (*high)[8], const Host& host,
                        double* out_low, double* out_high);

/// Whether the interval shrinks with the box: false where a part of the function is answered by its whole range (noise,
/// patterns, pigments, splines, some internal functions).
bool narrows(const Function& function);

}  // namespace function
