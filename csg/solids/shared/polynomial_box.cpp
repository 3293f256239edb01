#include "csg/solids/shared/polynomial_box.h"
#include "numbers/infinity.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace csg {
namespace {

constexpr int kMostBoxed = 12;           // degree; higher ones have too many terms to be worth it
constexpr int kCells = 4;                // along an edge of the cube of directions
constexpr int kMostParted = 7;           // halvings of a cell
constexpr int kPartings = 240;           // of cells in all
constexpr double kTight = 0.02;          // of the reach: what lies so little beyond the middle of a cell is not parted
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
    const bool through = of.low <= 0.0 && of.high >= 0.0;
    Part size{through ? 0.0 : std::min(std::abs(of.low), std::abs(of.high)),
              std::max(std::abs(of.low), std::abs(of.high))},
        even{1.0, 1.0}, odd = of;
    size = {size.low * size.low, size.high * size.high};
    for (int n = 1; n <= degree; ++n) {
        const auto k = static_cast<std::size_t>(n);
        if (n % 2 == 0) {
            even = {even.low * size.low, even.high * size.high};
            out[k] = even;
        } else {
            out[k] = odd;
            odd = {odd.low * of.low * of.low, odd.high * of.high * of.high};
        }
    }
    return out;
}

/// A polynomial of the distance, lowest power first.
using Lowest = std::array<double, kMostBoxed + 1>;

/// Grows the box by what a polynomial may have inside of each cone of directions.
class Cones {
public:
    Cones(int degree, const std::vector<double>& coefficients) : degree_(degree)
    {
        std::size_t next = 0;
        for (int i = degree; i >= 0; --i)
            for (int j = degree - i; j >= 0; --j)
                for (int k = degree - i - j; k >= 0; --k)
                    if (const double c = coefficients[next++]; c != 0.0) terms_.push_back({c, at(i), at(j), at(k)});
        for (const Term& t : terms_) rounding_[t.i + t.j + t.k] += kRoundingPart * std::abs(t.c);
    }

    /// False: the inside is not bounded, or that could not be proven.
    bool run()
    {
        for (int x = -1; x <= 1; ++x)
            for (int y = -1; y <= 1; ++y)
                for (int z = -1; z <= 1; ++z)
                    if ((x != 0 || y != 0 || z != 0) &&
                        !leads({Part{1.0 * x, 1.0 * x}, Part{1.0 * y, 1.0 * y}, Part{1.0 * z, 1.0 * z}}))
                        return false;
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0})
                for (int i = 0; i < kCells; ++i)
                    for (int j = 0; j < kCells; ++j) {
                        Cell cell;
                        cell[at(axis)] = {side, side};
                        cell[at((axis + 1) % 3)] = piece(i);
                        cell[at((axis + 2) % 3)] = piece(j);
                        if (!add(cell, axis, 0)) return false;
                    }
        // The one that its middle says most about first.
        for (int k = 0; k < kPartings && cones_.front().spare > 0.0; ++k) {
            std::pop_heap(cones_.begin(), cones_.end());
            const Cone cone = cones_.back();
            cones_.pop_back();
            const auto u = at((cone.axis + 1) % 3), v = at((cone.axis + 2) % 3);
            for (int quarter = 0; quarter < 4; ++quarter) {
                Cell part = cone.cell;
                part[u] = half(cone.cell[u], quarter & 1);
                part[v] = half(cone.cell[v], quarter >> 1);
                if (!add(part, cone.axis, cone.partings + 1)) return false;
            }
        }
        box_.include(glm::dvec3(0.0));
        for (const Cone& cone : cones_) {
            const double reach = cone.reach * kWider;
            if (!(reach < kFarthest)) return false;
            const Cell& c = cone.cell;
            box_.include(reach * glm::dvec3(c[0].low, c[1].low, c[2].low));
            box_.include(reach * glm::dvec3(c[0].high, c[1].high, c[2].high));
        }
        return true;
    }
    const Aabb& box() const { return box_; }

private:
    using Cell = std::array<Part, 3>;  ///< directions: one coordinate is 1 or -1
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    static Part piece(int i) { return {-1.0 + 2.0 * i / kCells, -1.0 + 2.0 * (i + 1) / kCells}; }

    static Part half(const Part& of, int which)
    {
        const double middle = 0.5 * (of.low + of.high);
        return which == 0 ? Part{of.low, middle} : Part{middle, of.high};
    }
    static Part middle(const Part& of)
    {
        const double m = 0.5 * (of.low + of.high);
        return {m, m};
    }

    struct Term {
        double c;
        std::size_t i, j, k;
    };
    struct Cone {
        Cell cell;
        int axis, partings;
        double reach;  ///< positive from there on
        double spare;  ///< of the reach: what parting may take off; 0 where it is not worth it
        bool operator<(const Cone& other) const { return spare < other.spare; }
    };

    bool leads(const Cell& cell) const { return lowest(cell)[at(degree_)] > 0.0; }

    /// Least sums of the terms of each degree over the directions of a cell.
    Lowest lowest(const Cell& cell) const
    {
        const Powers x = powers_of(cell[0], degree_), y = powers_of(cell[1], degree_), z = powers_of(cell[2], degree_);
        Lowest out{};
        for (const Term& t : terms_) {
            const Part p = product(product(x[t.i], y[t.j]), z[t.k]);
            out[t.i + t.j + t.k] += t.c > 0.0 ? t.c * p.low : t.c * p.high;
        }
        for (int n = 0; n <= degree_; ++n) out[at(n)] -= rounding_[at(n)];
        return out;
    }

    /// False: there is no end in the middle of the cell.
    bool add(const Cell& cell, int axis, int partings)
    {
        const Lowest inner = lowest({middle(cell[0]), middle(cell[1]), middle(cell[2])});
        if (!(inner[at(degree_)] > 0.0)) return false;
        const Lowest low = lowest(cell);
        const double least = positive_from(inner), reach = low[at(degree_)] > 0.0 ? positive_from(low) : kInfinity;
        const bool worth = partings < kMostParted && (1.0 - kTight) * reach > least;
        cones_.push_back({cell, axis, partings, reach, worth ? reach - least : 0.0});
        std::push_heap(cones_.begin(), cones_.end());
        return true;
    }

    /// From where on a polynomial is surely positive: its expansion there has no negative coefficient.
    double positive_from(const Lowest& low) const
    {
        double sure = 1e-3;
        while (!grows_from(low, sure) && sure < kFarthest) sure *= 2.0;
        double below = 0.0;
        for (int i = 0; i < 10 && sure < kFarthest; ++i) {
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
    std::vector<Term> terms_;
    Lowest rounding_{};        ///< of the sum of each degree
    std::vector<Cone> cones_;  ///< a heap
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
