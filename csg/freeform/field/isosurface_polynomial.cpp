#include "csg/freeform/bernstein.h"
#include "csg/freeform/field/isosurface_search.h"

#include <algorithm>
#include <cmath>

namespace csg {

bool IsosurfaceSearch::Ordinates::above() const
{
    return std::all_of(b.begin(), b.begin() + degree + 1, [&](double v) { return v > margin; });
}

void IsosurfaceSearch::Ordinates::turn()
{
    for (int i = 0; i <= degree; ++i) b[static_cast<std::size_t>(i)] = -b[static_cast<std::size_t>(i)];
}

/// De Casteljau's.
void IsosurfaceSearch::Ordinates::part(Ordinates& left, Ordinates& right) const
{
    left.degree = right.degree = degree;
    left.margin = right.margin = margin;
    right.b = b;
    for (int k = 0; k <= degree; ++k) {
        left.b[static_cast<std::size_t>(k)] = right.b[0];
        for (int i = 0; i < degree - k; ++i) {
            const auto at = static_cast<std::size_t>(i);
            right.b[at] = 0.5 * (right.b[at] + right.b[at + 1]);
        }
    }
}

bool IsosurfaceSearch::find_ordinates(const Grid& grid, std::int64_t parts, Ordinates& out) const
{
    const double end = grid.at(parts);
    FieldStretch stretch;
    stretch.from = ray_.origin + grid.from * ray_.direction;
    stretch.way = (end - grid.from) * ray_.direction;
    const glm::dvec3 last = ray_.origin + end * ray_.direction;
    stretch.room = kPointRoom * (glm::abs(ray_.origin) + glm::abs(stretch.from) + glm::abs(last));
    FieldPolynomial along;
    if (!terms_.field->along(stretch, along) || !(std::abs(terms_.threshold) < along.limit)) return false;

    // Each of some 40 halvings may round every ordinate once.
    constexpr double kHalving = 1e-13;
    out.degree = along.degree;
    out.margin = 4.0 * along.error + kHalving * (along.size + std::abs(terms_.threshold));
    if (!(out.margin < kInfinity)) return false;
    const auto n = static_cast<std::size_t>(along.degree);
    for (std::size_t i = 0; i <= n; ++i) out.b[i] = along.c[i] / detail::choose(n, i);
    for (std::size_t k = 1; k <= n; ++k)
        for (std::size_t i = n; i >= k; --i) out.b[i] += out.b[i - 1];
    for (std::size_t i = 0; i <= n; ++i) out.b[i] -= terms_.threshold;
    return true;
}

bool IsosurfaceSearch::halves(const Grid& grid, const Ordinates& of, std::int64_t first, std::int64_t width,
                              double sign, double& found, int& leaves) const
{
    if (leaves == 0 || grid.at(first) > to_ || of.above()) return false;
    if (width == 1) {
        --leaves;
        if (!(sign * value(grid.at(first + 1)) < 0.0)) return false;
        found = told(grid, first + 1, sign);
        return true;
    }
    Ordinates left, right;
    of.part(left, right);
    const std::int64_t half = width / 2;
    return halves(grid, left, first, half, sign, found, leaves) ||
           halves(grid, right, first + half, half, sign, found, leaves);
}

}  // namespace csg
