#include "csg/freeform/shared/bernstein.h"
#include "csg/freeform/field/isosurface_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

/// Isosurfaces whose field is a polynomial along the ray. Its Bernstein form is halved where the ordinates have both
/// signs, down to the intervals of the grid, so that the crossing is the one that ranges of the field lead to.
namespace csg {

bool IsosurfaceSearch::find_polynomial()
{
    FieldStretch stretch;
    stretch.from = ray_.origin + known_.from * ray_.direction;
    stretch.way = (known_.end - known_.from) * ray_.direction;
    const glm::dvec3 last = ray_.origin + known_.end * ray_.direction;
    stretch.room = kPointRoom * (glm::abs(ray_.origin) + glm::abs(stretch.from) + glm::abs(last));
    FieldPolynomial& along = known_.along;
    if (!terms_.field->along(stretch, along) || !(std::abs(terms_.threshold) < along.limit)) return false;
    // The polynomial's error twice and the values' own; each of some 40 halvings may round every ordinate once.
    constexpr double kHalving = 1e-13;
    known_.margin = 4.0 * along.error + kHalving * (along.size + std::abs(terms_.threshold));
    along.c[0] -= terms_.threshold;
    return known_.margin < kInfinity;
}

struct IsosurfaceSearch::Halving {
    double sign;
    int leaves;  ///< how many more grid intervals may be evaluated
    double found;
};

bool IsosurfaceSearch::by_polynomial(double sign, double& found) const
{
    // Where a field is flat, ordinates decide less than ranges do, since their error is a share of the field's largest
    // term. After so many intervals without a decision the ranges take over.
    constexpr int kMostLeaves = 200;
    Halving search{sign, kMostLeaves, 0.0};
    std::array<double, FieldPolynomial::kMost + 1> c;
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = sign * known_.along.c[i];
    const auto degree = static_cast<std::size_t>(known_.along.degree);
    bool met = false;
    const auto try_degree = [&]<std::size_t n>() {
        if (degree == n) met = halves(ordinates_of<n + 1>(c.data()), 0, known_.parts(), search);
    };
    [&]<std::size_t... n>(std::index_sequence<n...>) { (try_degree.template operator()<n>(), ...); }
    (std::make_index_sequence<FieldPolynomial::kMost + 1>());
    found = search.found;
    return met || (search.leaves == 0 && eighths(known_.grid, 0, known_.levels, sign, found));
}

template <std::size_t count>
bool IsosurfaceSearch::halves(const std::array<double, count>& b, std::int64_t first, std::int64_t width,
                              Halving& search) const
{
    if (search.leaves == 0 || known_.grid.at(first) > to_) return false;
    if (std::all_of(b.begin(), b.end(), [&](double v) { return v > known_.margin; })) return false;
    if (width == 1) {
        --search.leaves;
        if (!(search.sign * value(known_.grid.at(first + 1)) < 0.0)) return false;
        search.found = told(known_.grid, first + 1, search.sign);
        return true;
    }
    std::array<double, count> left, right;
    halve(b, left, right);
    const std::int64_t half = width / 2;
    return halves(left, first, half, search) || halves(right, first + half, half, search);
}

}  // namespace csg
