#include "function/spline.h"

#include <algorithm>
#include <cstddef>

namespace function {

using Values = Spline::Values;

void Spline::add(double t, const Values& value, std::uint32_t count)
{
    components_ = std::max(components_, count);
    derivatives_.clear();
    const auto at = std::lower_bound(knots_.begin(), knots_.end(), t, [](const Knot& k, double v) { return k.t < v; });
    if (at != knots_.end() && at->t == t) {
        if (at + 1 != knots_.end() || knots_.size() == 1) at->value = value;
        return;
    }
    knots_.insert(at, {t, value});
}

namespace {

/// The rest is 0.
template <class F>
Values each(std::size_t components, F&& f)
{
    Values out{};
    for (std::size_t k = 0; k < components; ++k) out[k] = f(k);
    return out;
}

/// The parabola through (t0, v0), (t1, v1), (t2, v2).
double parabola(double t, double t0, double v0, double t1, double v1, double t2, double v2)
{
    return v0 * ((t - t1) * (t - t2)) / ((t0 - t1) * (t0 - t2)) + v1 * ((t - t0) * (t - t2)) / ((t1 - t0) * (t1 - t2)) +
           v2 * ((t - t0) * (t - t1)) / ((t2 - t0) * (t2 - t1));
}

}  // namespace

/// Of the natural spline, at every knot: the tridiagonal system solved by elimination, 0 at both ends.
std::vector<Values> Spline::second_derivatives() const
{
    const std::size_t n = knots_.size();
    std::vector<Values> m(n, Values{});
    std::vector<double> above(n, 0.0);  // of the eliminated system, whose diagonal is 1
    const auto h = [&](std::size_t j) { return knots_[j + 1].t - knots_[j].t; };
    for (std::size_t j = 1; j + 1 < n; ++j) {
        const double pivot = 2.0 * (h(j - 1) + h(j)) - h(j - 1) * above[j - 1];
        above[j] = h(j) / pivot;
        m[j] = each(components_, [&](std::size_t k) {
            const double slope = (knots_[j + 1].value[k] - knots_[j].value[k]) / h(j);
            const double before = (knots_[j].value[k] - knots_[j - 1].value[k]) / h(j - 1);
            return (6.0 * (slope - before) - h(j - 1) * m[j - 1][k]) / pivot;
        });
    }
    for (std::size_t j = n - 1; j-- > 1;)
        m[j] = each(components_, [&](std::size_t k) { return m[j][k] - above[j] * m[j + 1][k]; });
    return m;
}

void Spline::finish() { derivatives_ = second_derivatives(); }

Values Spline::at(double t, Kind as) const
{
    const std::size_t count = knots_.size(), last = count - 1;
    if (count == 0) return {};
    if (count == 1) return knots_[0].value;
    const auto knot = [&](std::size_t j) -> const Knot& { return knots_[j]; };
    const auto found =
        std::lower_bound(knots_.begin(), knots_.end(), t, [](const Knot& k, double v) { return k.t < v; });
    std::size_t i = static_cast<std::size_t>(found - knots_.begin());
    if (!(t < knots_.back().t)) i = count;
    if (as == Kind::Cubic) {
        if (count == 2)
            return each(components_, [&](std::size_t k) { return (knot(0).value[k] + knot(1).value[k]) / 2.0; });
        if (i < 2) return knot(1).value;
        if (i >= last) return knot(last - 1).value;
        const std::size_t a = i - 1;
        const double step = knot(i).t - knot(a).t, u = (t - knot(a).t) / step, u2 = u * u, u3 = u2 * u;
        return each(components_, [&](std::size_t k) {
            const auto slope = [&](std::size_t j) {
                return (knot(j + 1).value[k] - knot(j).value[k]) / (knot(j + 1).t - knot(j).t);
            };
            const double d0 = step * (slope(a - 1) + slope(a)) / 2.0, d1 = step * (slope(a) + slope(a + 1)) / 2.0;
            return knot(a).value[k] * (2.0 * u3 - 3.0 * u2 + 1.0) + knot(i).value[k] * (3.0 * u2 - 2.0 * u3) +
                   d0 * (u3 - 2.0 * u2 + u) + d1 * (u3 - u2);
        });
    }
    if (i == 0) return knot(0).value;
    if (i > last) return knot(last).value;
    const std::size_t a = i - 1;
    const double d = t - knot(a).t, h = knot(i).t - knot(a).t;
    if (as == Kind::Quadratic && count > 2) {
        const std::size_t p = i < 2 ? 0 : i - 2;
        return each(components_, [&](std::size_t k) {
            return parabola(t, knot(p).t, knot(p).value[k], knot(p + 1).t, knot(p + 1).value[k], knot(p + 2).t,
                            knot(p + 2).value[k]);
        });
    }
    if (as == Kind::Natural && count > 2) {
        const std::vector<Values> fresh = derivatives_.empty() ? second_derivatives() : std::vector<Values>{};
        const std::vector<Values>& m = derivatives_.empty() ? fresh : derivatives_;
        return each(components_, [&](std::size_t k) {
            const double slope = (knot(i).value[k] - knot(a).value[k]) / h - h * (m[i][k] + 2.0 * m[a][k]) / 6.0;
            return knot(a).value[k] + d * (slope + d * (m[a][k] / 2.0 + d * (m[i][k] - m[a][k]) / (6.0 * h)));
        });
    }
    return each(components_,
                [&](std::size_t k) { return knot(a).value[k] + d * (knot(i).value[k] - knot(a).value[k]) / h; });
}

}  // namespace function
