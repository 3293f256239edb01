#pragma once

#include "csg/types.h"

#include <cstdint>
#include <vector>

namespace csg {

/// A piece of an outline: a w^3 + b w^2 + c w + d for w from 0 to 1, from `start` to `end`. Pieces that meet share the
/// point itself, so that a ray passes between them on one side or the other.
struct OutlinePiece {
    glm::dvec2 a{0.0}, b{0.0}, c{0.0}, d{0.0};
    glm::dvec2 start{0.0}, end{0.0};

    static OutlinePiece line(const glm::dvec2& from, const glm::dvec2& to) { return {{}, {}, to - from, from, from, to}; }
    /// Bezier curves of degree 2 and 3.
    static OutlinePiece quadratic(const glm::dvec2& p0, const glm::dvec2& p1, const glm::dvec2& p2);
    glm::dvec2 at(double w) const { return w <= 0.0 ? start : w >= 1.0 ? end : ((a * w + b) * w + c) * w + d; }
    glm::dvec2 slope(double w) const { return (3.0 * a * w + 2.0 * b) * w + c; }
};

/// A plane region between closed outlines, by the even-odd rule. Immutable; shared by all instances.
class OutlineShape {
public:
    /// Every outline is closed: the pieces' ends and starts pair off.
    explicit OutlineShape(std::vector<OutlinePiece> pieces);

    bool empty() const { return pieces_.empty(); }
    const std::vector<OutlinePiece>& pieces() const { return pieces_; }
    const glm::dvec2& lower() const { return lower_; }
    const glm::dvec2& upper() const { return upper_; }
    bool contains(const glm::dvec2& p) const;
    /// No line crosses the outlines more often.
    std::uint32_t most_crossings() const { return most_; }
    /// The parameter of a point on a piece.
    double parameter(std::uint32_t piece, const glm::dvec2& p) const;

    /// Calls f(w, piece) where dot(side, p) crosses `level`, an even number of times all in all: a joint counts to one
    /// side.
    template <class F>
    void crossings(const glm::dvec2& side, double level, F&& f) const
    {
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
            const Reach& reach = reach_[i];
            // The piece lies in this box: wholly on one side of the line?
            const double middle = glm::dot(side, reach.middle) - level;
            if (std::abs(middle) > std::abs(side.x) * reach.half.x + std::abs(side.y) * reach.half.y) continue;
            piece_crossings(pieces_[i], side, level, [&](double w) { f(w, i); });
        }
    }

private:
    struct Reach {
        glm::dvec2 middle, half;   ///< a little larger than the piece
    };

    template <class F>
    static void piece_crossings(const OutlinePiece& piece, const glm::dvec2& side, double level, F&& f);

    std::vector<OutlinePiece> pieces_;
    std::vector<Reach> reach_;
    glm::dvec2 lower_{0.0}, upper_{0.0};
    std::uint32_t most_ = 0;
};

/// Roots of a quadratic inside (0, 1), in order.
inline int inner_roots(double a, double b, double c, double (&out)[2])
{
    int n = 0;
    const auto keep = [&](double w) {
        if (w > 0.0 && w < 1.0) out[n++] = w;
    };
    if (a == 0.0) {
        if (b != 0.0) keep(-c / b);
        return n;
    }
    const double discriminant = b * b - 4.0 * a * c;
    if (!(discriminant > 0.0)) return 0;
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    const double r0 = q / a, r1 = q != 0.0 ? c / q : 0.0;
    keep(glm::min(r0, r1));
    keep(glm::max(r0, r1));
    return n;
}

template <class F>
inline void OutlineShape::piece_crossings(const OutlinePiece& piece, const glm::dvec2& side, double level, F&& f)
{
    const auto beyond = [&](const glm::dvec2& p) { return glm::dot(side, p) - level; };
    const double first = beyond(piece.start), last = beyond(piece.end);
    if (piece.a == glm::dvec2(0.0) && piece.b == glm::dvec2(0.0)) {
        if ((first < 0.0) != (last < 0.0)) f(glm::clamp(first / (first - last), 0.0, 1.0));
        return;
    }
    const double a = glm::dot(side, piece.a), b = glm::dot(side, piece.b), c = glm::dot(side, piece.c), d = beyond(piece.d);
    double turns[2];
    const int n = inner_roots(3.0 * a, 2.0 * b, c, turns);
    double lo = 0.0, before = first;
    for (int i = 0; i <= n; ++i) {
        const double hi = i < n ? turns[i] : 1.0;
        const double after = i < n ? ((a * hi + b) * hi + c) * hi + d : last;
        if ((before < 0.0) != (after < 0.0)) {
            // Newton between the turns, kept in the bracket.
            double low = lo, high = hi, w = lo + (hi - lo) * (before / (before - after));
            for (int k = 0; k < 60; ++k) {
                const double value = ((a * w + b) * w + c) * w + d;
                if (value == 0.0) break;
                ((value < 0.0) == (before < 0.0) ? low : high) = w;
                double next = w - value / ((3.0 * a * w + 2.0 * b) * w + c);
                if (!(next > low && next < high)) next = 0.5 * (low + high);
                if (std::abs(next - w) <= 1e-16) break;
                w = next;
            }
            f(w);
        }
        lo = hi;
        before = after;
    }
}

}  // namespace csg
