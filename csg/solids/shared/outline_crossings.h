#pragma once

#include "numbers/lane_arithmetic.h"
#include "numbers/safeguarded_newton.h"
#include "csg/solids/shared/outline_shape.h"

#include <algorithm>
#include <bit>

/// Where a line crosses an outline.
namespace csg {

/// The line dot(side, p) = level, and the stretch of it that matters: dot(along, p) from lo to hi.
struct OutlineLine {
    glm::dvec2 side{0.0};
    double level = 0.0;
    glm::dvec2 along{0.0};
    double lo = -kInfinity, hi = kInfinity;
};

/// A ray across the plane of an outline: its parameter, and the line that it goes along.
/// \tparam Line OutlineLine, or many of them; Place, T: what such a one has its points and numbers as
template <class Line, class Place, class T>
struct OutlineRay {
    Place from, along;
    T square, over, first, coarse;

    OutlineRay(const Place& origin, const Place& way) : from(origin), along(way)
    {
        square = along.x * along.x + along.y * along.y;
        over = T(1.0) / square;
        first = from.x * along.x + from.y * along.y;
        // A part of what goes into it: more than the roundings of a place.
        coarse = T(1e-14) * (lanes::size_of(T(from.x * along.x)) + lanes::size_of(T(from.y * along.y)));
    }
    T at(const Place& p) const { return ((p.x - from.x) * along.x + (p.y - from.y) * along.y) * over; }
    /// How far along the line it is at t, at the most.
    T latest(const T& t) const { return first + t * square + room(t); }
    Line line(const T& nearest, const T& farthest) const
    {
        Line line;
        line.side = {lanes::negated(along.y), along.x};
        line.level = line.side.x * from.x + line.side.y * from.y;
        line.along = along;
        line.lo = first + nearest * square - room(nearest);
        line.hi = latest(farthest);
        return line;
    }

private:
    T room(const T& t) const { return coarse + T(1e-14) * lanes::size_of(t) * square; }
};

namespace detail {

/// Where b w^2 + c w + d rises through 0, or falls. NaN if it never does.
template <class T>
inline T only_root_of(const T& b, const T& c, const T& d, const lanes::Truth<T>& rises)
{
    const T root = lanes::root_of(c * c - T(4.0) * b * d), slope = lanes::choose(rises, root, lanes::negated(root));
    return lanes::either(
        lanes::differ(c > T(0.0), rises), [&] { return (slope - c) / (T(2.0) * b); },
        [&] { return T(-2.0) * d / (c + slope); });
}

/// Where a piece that is not straight crosses the line: f(w), in order.
template <class F>
inline void curve_crossings(const OutlinePiece& piece, const OutlineLine& line, F&& f)
{
    const auto beyond = [&](const glm::dvec2& p) { return glm::dot(line.side, p) - line.level; };
    const double first = beyond(piece.start), last = beyond(piece.end);
    const double a = glm::dot(line.side, piece.a), b = glm::dot(line.side, piece.b), c = glm::dot(line.side, piece.c),
                 d = beyond(piece.d);
    double turns[2];
    int n = 0;
    if ((first < 0.0) == (last < 0.0)) {
        // Bezier ordinates all clearly on one side: so is the piece.
        constexpr double kThird = 1.0 / 3.0;
        const double clear = 1e-13 * (std::abs(a) + std::abs(b) + std::abs(c) + std::abs(line.level));
        const double one = d + kThird * c, two = d + kThird * (2.0 * c + b);
        const double least = glm::min(glm::min(first, last), glm::min(one, two)),
                     most = glm::max(glm::max(first, last), glm::max(one, two));
        if (least > clear || most < -clear) return;
        n = inner_roots(3.0 * a, 2.0 * b, c, turns);
    } else {
        // It rises or falls all the way if the ordinates of its slope have one sign.
        const double middle = b + c, end = 3.0 * a + 2.0 * b + c;
        const bool even = last > first ? c > 0.0 && middle > 0.0 && end > 0.0 : c < 0.0 && middle < 0.0 && end < 0.0;
        if (!even) n = inner_roots(3.0 * a, 2.0 * b, c, turns);
    }
    double lo = 0.0, before = first;
    for (int i = 0; i <= n; ++i) {
        const double hi = i < n ? turns[i] : 1.0;
        const double after = i < n ? ((a * hi + b) * hi + c) * hi + d : last;
        if ((before < 0.0) != (after < 0.0)) {
            double w = lo + (hi - lo) * (before / (before - after));
            if (a == 0.0) {
                const double root = only_root_of(b, c, d, before < 0.0);
                if (root > lo && root < hi) w = root;
            }
            const auto at = [=](double v) {
                return ValueAndSlope{((a * v + b) * v + c) * v + d, (3.0 * a * v + 2.0 * b) * v + c};
            };
            f(safeguarded_newton(at, lo, hi, before < 0.0, w, {1e-16, 0.0}, 60));
        }
        lo = hi;
        before = after;
    }
}

/// A line and boxes, a lane each.
class OutlineLanes {
public:
    static constexpr int kEight = static_cast<int>(OutlineShape::Block::kPieces);

    explicit OutlineLanes(const OutlineLine& line)
        : side_{Double(line.side.x), Double(line.side.y)}, along_{Double(line.along.x), Double(line.along.y)},
          level_(line.level), lo_(line.lo)
    {
        for (int k = 0; k < 2; ++k) {
            side_size_[k] = xsimd::abs(side_[k]);
            along_size_[k] = xsimd::abs(along_[k]);
        }
    }

    /// Of the lanes from `at` on: which points lie below the line, ...
    std::uint32_t below(const double (&p)[2][8], int at) const
    {
        return lanes::mask(dot(side_, p, at) - level_ < Double(0.0));
    }
    /// ... which boxes lie wholly on one side of it, ...
    template <class Box>
    std::uint32_t off(const Box& box, int at) const
    {
        return lanes::mask(xsimd::abs(dot(side_, box.middle, at) - level_) > dot(side_size_, box.half, at));
    }
    /// ... and wholly before or behind the stretch of it.
    template <class Box>
    void outside(const Box& box, int at, double hi, std::uint32_t& before, std::uint32_t& behind) const
    {
        const Double middle = dot(along_, box.middle, at), half = dot(along_size_, box.half, at);
        before = lanes::mask(middle + half < lo_);
        behind = lanes::mask(middle - half > Double(hi));
    }

private:
    using Double = lanes::Double;
    static Double dot(const Double (&v)[2], const double (&p)[2][8], int at)
    {
        return v[0] * Double::load_aligned(p[0] + at) + v[1] * Double::load_aligned(p[1] + at);
    }

    Double side_[2], along_[2], side_size_[2], along_size_[2], level_, lo_;
};

}  // namespace detail

/// Calls f(w, piece) for crossings of the line, those that surely lie beyond the stretch left out: those before it are
/// only counted, and the result is whether their number is odd. All crossings are an even number: a joint counts to one
/// side. `f` may lower line.hi.
template <class F>
inline bool outline_crossings(const OutlineShape& shape, OutlineLine& line, F&& f)
{
    using detail::OutlineLanes;
    const OutlineLanes lanes(line);
    const std::vector<OutlineShape::Block>& blocks = shape.blocks();
    bool odd = false;
    const auto cross = [&](std::size_t b) {
        const OutlineShape::Block& block = blocks[b];
        const int most = static_cast<int>(
            std::min(OutlineShape::Block::kPieces, shape.pieces().size() - b * OutlineShape::Block::kPieces));
        for (int at = 0; at < most; at += lanes::kDoubles) {
            const std::uint32_t flips = lanes.below(block.start, at) ^ lanes.below(block.end, at);
            std::uint32_t left = (flips | (block.curved >> at & ((1u << lanes::kDoubles) - 1))) & ~lanes.off(block, at);
            if (left == 0) continue;
            std::uint32_t before = 0, behind = 0;
            lanes.outside(block, at, line.hi, before, behind);
            odd ^= (std::popcount(left & flips & before) & 1) != 0;
            for (left &= ~(before | behind); left != 0; left &= left - 1) {
                const std::uint32_t i = static_cast<std::uint32_t>(b * OutlineShape::Block::kPieces) +
                                        static_cast<std::uint32_t>(at + std::countr_zero(left));
                const OutlinePiece& piece = shape.pieces()[i];
                if ((block.curved >> (i % OutlineShape::Block::kPieces) & 1u) != 0) {
                    detail::curve_crossings(piece, line, [&](double w) { f(w, i); });
                } else {
                    const double first = glm::dot(line.side, piece.start) - line.level,
                                 last = glm::dot(line.side, piece.end) - line.level;
                    f(glm::clamp(first / (first - last), 0.0, 1.0), i);
                }
            }
        }
    };
    if (shape.boxes().empty()) {
        for (std::size_t b = 0; b < blocks.size(); ++b) cross(b);
        return odd;
    }
    for (std::size_t b = 0; b < blocks.size(); b += OutlineShape::Block::kPieces) {
        const OutlineShape::Boxes& boxes = shape.boxes()[b / OutlineShape::Block::kPieces];
        std::uint32_t off = 0;
        for (int at = 0; at < OutlineLanes::kEight; at += lanes::kDoubles) {
            std::uint32_t before = 0, behind = 0;
            lanes.outside(boxes, at, line.hi, before, behind);
            off |= (lanes.off(boxes, at) | behind) << at;
        }
        const std::size_t held = std::min(OutlineShape::Block::kPieces, blocks.size() - b);
        for (std::uint32_t left = ~off & ((1u << held) - 1); left != 0; left &= left - 1)
            cross(b + static_cast<std::size_t>(std::countr_zero(left)));
    }
    return odd;
}

}  // namespace csg
