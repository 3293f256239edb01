#include "csg/solids/shared/polynomial_box.h"
#include "numbers/functions/functions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace csg {
namespace {

constexpr int kMostBoxed = 12;           // degree; higher ones have too many terms to be worth it
constexpr int kCells = 8;                // along an edge of the cube of directions
constexpr int kMostParted = 2;           // halvings of a cell where the sign of the leading terms is not clear
constexpr double kRoundingPart = 1e-12;  // of the sum of the terms' sizes: what sums of intervals may be off by
constexpr double kFarthest = 1e8;        // a box so large is no box
constexpr double kWider = 1.0 + 1e-6;

struct Part {
    double low, high;
};

Part product(const Part& a, const Part& b)
{
    const double all[4] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    return {*std::min_element(all, all + 4), *std::max_element(all, all + 4)};
}

/// Powers 0 to degree of the numbers of an interval.
using Powers = std::array<Part, kMostBoxed + 1>;
Powers powers_of(const Part& of, int degree)
{
    Powers out;
    out[0] = {1.0, 1.0};
    const double most = std::max(std::abs(of.low), std::abs(of.high)), least = of.low > 0.0    ? of.low
                                                                               : of.high < 0.0 ? -of.high
                                                                                               : 0.0;
    for (int n = 1; n <= degree; ++n) {
        const auto k = static_cast<std::size_t>(n);
        if (n % 2 == 0) out[k] = {numbers::pow(least, n), numbers::pow(most, n)};
        else out[k] = {numbers::pow(of.low, n), numbers::pow(of.high, n)};
    }
    return out;
}

/// A polynomial of the distance, lowest power first.
using Lowest = std::array<double, kMostBoxed + 1>;

/// Grows the box by what a polynomial may have inside of each cone of directions.
class Cones {
public:
    Cones(int degree, const std::vector<double>& coefficients) : degree_(degree), coefficients_(coefficients) {}

    /// False: there is no end.
    bool run()
    {
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z)
                    if ((x != 0 || y != 0 || z != 0) &&
                        !leads({Part{1.0 * x, 1.0 * x}, Part{1.0 * y, 1.0 * y}, Part{1.0 * z, 1.0 * z}}))
                        return false;
        box_.include(glm::dvec3(0.0));
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0})
                for (int i = 0; i < kCells; ++i)
                    for (int j = 0; j < kCells; ++j) {
                        Cell cell;
                        cell[at(axis)] = {side, side};
                        cell[at((axis + 1) % 3)] = piece(i);
                        cell[at((axis + 2) % 3)] = piece(j);
                        if (!add(cell, axis, kMostParted)) return false;
                    }
        return true;
    }
    const Aabb& box() const { return box_; }

private:
    using Cell = std::array<Part, 3>;  ///< directions: one coordinate is 1 or -1
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    static Part piece(int i) { return {-1.0 + 2.0 * i / kCells, -1.0 + 2.0 * (i + 1) / kCells}; }

    bool leads(const Cell& cell) const { return lowest(cell)[at(degree_)] > 0.0; }

    /// Least sums of the terms of each degree over the directions of a cell.
    Lowest lowest(const Cell& cell) const
    {
        const Powers x = powers_of(cell[0], degree_), y = powers_of(cell[1], degree_), z = powers_of(cell[2], degree_);
        Lowest out{}, size{};
        std::size_t next = 0;
        for (int i = degree_; i >= 0; --i)
            for (int j = degree_ - i; j >= 0; --j)
                for (int k = degree_ - i - j; k >= 0; --k, ++next) {
                    const double c = coefficients_[next];
                    if (c == 0.0) continue;
                    const Part p = product(product(x[at(i)], y[at(j)]), z[at(k)]);
                    out[at(i + j + k)] += c > 0.0 ? c * p.low : c * p.high;
                    size[at(i + j + k)] += std::abs(c);
                }
        for (int n = 0; n <= degree_; ++n) out[at(n)] -= kRoundingPart * size[at(n)];
        return out;
    }

    bool add(const Cell& cell, int axis, int partings)
    {
        const Lowest low = lowest(cell);
        if (!(low[at(degree_)] > 0.0)) {
            if (partings == 0) return false;
            const auto u = at((axis + 1) % 3), v = at((axis + 2) % 3);
            const auto half = [](const Part& of, int which) {
                const double middle = 0.5 * (of.low + of.high);
                return which == 0 ? Part{of.low, middle} : Part{middle, of.high};
            };
            for (int k = 0; k < 4; ++k) {
                Cell part = cell;
                part[u] = half(cell[u], k & 1);
                part[v] = half(cell[v], k >> 1);
                if (!add(part, axis, partings - 1)) return false;
            }
            return true;
        }
        const double reach = positive_from(low) * kWider;
        if (!(reach < kFarthest)) return false;
        box_.include(reach * glm::dvec3(cell[0].low, cell[1].low, cell[2].low));
        box_.include(reach * glm::dvec3(cell[0].high, cell[1].high, cell[2].high));
        return true;
    }

    /// From where on a polynomial is surely positive: its expansion there has no negative coefficient.
    double positive_from(const Lowest& low) const
    {
        double sure = 1e-3;
        while (!grows_from(low, sure) && sure < kFarthest) sure *= 2.0;
        double below = 0.0;
        for (int i = 0; i < 24 && sure < kFarthest; ++i) {
            const double middle = 0.5 * (below + sure);
            (grows_from(low, middle) ? sure : below) = middle;
        }
        return sure;
    }
    bool grows_from(Lowest c, double distance) const
    {
        for (int first = 0; first < degree_; ++first) {
            for (int k = degree_ - 1; k >= first; --k) c[at(k)] += distance * c[at(k + 1)];
            if (!(c[at(first)] > 0.0)) return false;
        }
        return true;
    }

    int degree_;
    const std::vector<double>& coefficients_;
    Aabb box_;
};

}  // namespace

Aabb polynomial_box(int degree, const std::vector<double>& coefficients)
{
    if (degree % 2 != 0 || degree > kMostBoxed) return Aabb::everything();
    Cones cones(degree, coefficients);
    return cones.run() ? cones.box() : Aabb::everything();
}

}  // namespace csg
