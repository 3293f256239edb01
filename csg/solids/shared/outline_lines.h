#pragma once

#include "numbers/lane_newton.h"
#include "csg/solids/shared/outline_crossings.h"

#include <array>
#include <bit>

/// Where many lines cross an outline, a line a lane: the places that outline_crossings() finds of each.
namespace csg {

/// Lines and stretches of them, as OutlineLine. Every piece is asked about all lanes, and its crossings are worked out
/// for those that meet it together.
class OutlineLines {
public:
    using Double = lanes::Double;
    using Bool = Double::batch_bool_type;
    using Mask = std::uint32_t;
    static constexpr std::size_t kWide = static_cast<std::size_t>(lanes::kDoubles);
    struct Place {
        Double x, y;
    };

    Place side, along;
    Double level, lo, hi;

    /// Calls f(piece, w, mask) for the crossings of some lanes of the mask, in the order of pieces, and of w on each.
    /// Left out are those that surely lie beyond the stretch; in which lanes the number of those before it is odd is
    /// the result.
    template <class F>
    Mask crossings(const OutlineShape& shape, Mask asked, F&& f) const
    {
        const Sizes sizes{{xsimd::abs(side.x), xsimd::abs(side.y)}, {xsimd::abs(along.x), xsimd::abs(along.y)}};
        Mask odd = 0;
        const auto cross = [&](std::size_t b, Mask near) {
            const std::size_t first = b * OutlineShape::Block::kPieces,
                              last = std::min(first + OutlineShape::Block::kPieces, shape.pieces().size());
            for (std::size_t i = first; i < last; ++i)
                odd ^=
                    meet_piece(shape.blocks()[b], i - first, shape.pieces()[i], sizes, near,
                               [&](const Double& w, Mask crossing) { f(static_cast<std::uint32_t>(i), w, crossing); });
        };
        for (std::size_t b = 0; b < shape.blocks().size(); ++b) {
            Mask near = asked;
            if (!shape.boxes().empty()) {
                const OutlineShape::Boxes& boxes = shape.boxes()[b / OutlineShape::Block::kPieces];
                const std::size_t k = b % OutlineShape::Block::kPieces;
                Mask before = 0, behind = 0;
                outside(boxes, k, sizes, before, behind);
                near &= ~(off(boxes, k, sizes) | behind);
            }
            if (near != 0) cross(b, near);
        }
        return odd;
    }

    /// OutlinePiece::at().
    static Place at(const OutlinePiece& piece, const Double& w)
    {
        const Bool first = w <= Double(0.0), last = w >= Double(1.0);
        const auto coordinate = [&](int k) {
            const Double on = ((Double(piece.a[k]) * w + Double(piece.b[k])) * w + Double(piece.c[k])) * w +
                              Double(piece.d[k]);
            return xsimd::select(first, Double(piece.start[k]), xsimd::select(last, Double(piece.end[k]), on));
        };
        return {coordinate(0), coordinate(1)};
    }
    static Double dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y; }

private:
    struct Sizes {
        Place side, along;
    };
    /// A cubic of w, a lane each.
    struct Cubic {
        Double a, b, c, d;
        Double value(const Double& w) const { return ((a * w + b) * w + c) * w + d; }
        Double slope(const Double& w) const { return (Double(3.0) * a * w + Double(2.0) * b) * w + c; }
    };

    static Place place(const double (&p)[2][8], std::size_t k) { return {Double(p[0][k]), Double(p[1][k])}; }
    static Place place(const glm::dvec2& p) { return {Double(p.x), Double(p.y)}; }
    template <class Box>
    Mask off(const Box& box, std::size_t k, const Sizes& sizes) const
    {
        return lanes::mask(xsimd::abs(dot(side, place(box.middle, k)) - level) > dot(sizes.side, place(box.half, k)));
    }
    template <class Box>
    void outside(const Box& box, std::size_t k, const Sizes& sizes, Mask& before, Mask& behind) const
    {
        const Double middle = dot(along, place(box.middle, k)), half = dot(sizes.along, place(box.half, k));
        before = lanes::mask(middle + half < lo);
        behind = lanes::mask(middle - half > hi);
    }

    /// f(w, mask). The lanes that cross it an odd number of times before their stretch.
    template <class F>
    Mask meet_piece(const OutlineShape::Block& block, std::size_t k, const OutlinePiece& piece, const Sizes& sizes,
                    Mask asked, F&& f) const
    {
        const Double first = dot(side, place(block.start, k)) - level, last = dot(side, place(block.end, k)) - level;
        const Bool below_first = first < Double(0.0), below_last = last < Double(0.0);
        const Mask flips = lanes::mask(below_first) ^ lanes::mask(below_last);
        const bool curved = (block.curved >> k & 1u) != 0;
        Mask left = (curved ? asked : asked & flips);
        if (left == 0) return 0;
        left &= ~off(block, k, sizes);
        if (left == 0) return 0;
        Mask before = 0, behind = 0;
        outside(block, k, sizes, before, behind);
        const Mask odd = left & flips & before;
        left &= ~(before | behind);
        if (left == 0) return odd;
        if (curved) {
            curve(piece, first, last, left, flips, f);
        } else {
            const Double w = first / (first - last), least = xsimd::select(w < Double(0.0), Double(0.0), w);
            f(xsimd::select(Double(1.0) < least, Double(1.0), least), left);
        }
        return odd;
    }

    /// detail::curve_crossings().
    template <class F>
    void curve(const OutlinePiece& piece, const Double& first, const Double& last, Mask asked, Mask flips, F&& f) const
    {
        const Double zero(0.0), two(2.0), three(3.0);
        const Cubic at{dot(side, place(piece.a)), dot(side, place(piece.b)), dot(side, place(piece.c)),
                       dot(side, place(piece.d)) - level};
        Mask turning = 0;
        if ((asked & ~flips) != 0) {
            const Double third(1.0 / 3.0),
                clear = Double(1e-13) * (xsimd::abs(at.a) + xsimd::abs(at.b) + xsimd::abs(at.c) + xsimd::abs(level));
            const Double one = at.d + third * at.c, other = at.d + third * (two * at.c + at.b);
            const Double least = lanes::smaller<Double>(lanes::smaller<Double>(first, last),
                                                        lanes::smaller<Double>(one, other)),
                         most = lanes::larger<Double>(lanes::larger<Double>(first, last),
                                                      lanes::larger<Double>(one, other));
            const Mask misses = lanes::mask((least > clear) | (most < zero - clear));
            asked &= flips | ~misses;
            turning = asked & ~flips;
        }
        if ((asked & flips) != 0) {
            const Double middle = at.b + at.c, end = three * at.a + two * at.b + at.c;
            const Bool up = (at.c > zero) & (middle > zero) & (end > zero),
                       down = (at.c < zero) & (middle < zero) & (end < zero), rises = last > first;
            turning |= asked & flips & ~lanes::mask((rises & up) | ((!rises) & down));
        }
        if (asked == 0) return;
        Double turns[2] = {Double(1.0), Double(1.0)};
        Mask has[2] = {0, 0};
        if (turning != 0) find_turns(three * at.a, two * at.b, at.c, turning, turns, has);
        Double from = zero, before = first;
        for (int i = 0; i <= 2 && asked != 0; ++i) {
            const Mask turned = i < 2 ? has[i] & asked : 0;
            const Bool turns_here = lanes::lanes_of(turned);
            const Double to = turned != 0 ? xsimd::select(turns_here, turns[i], Double(1.0)) : Double(1.0);
            const Double after = turned != 0 ? xsimd::select(turns_here, at.value(to), last) : last;
            const Mask changes = asked & (lanes::mask(before < zero) ^ lanes::mask(after < zero));
            if (changes != 0) f(root(at, from, to, before, after, changes), changes);
            from = to;
            before = after;
            asked = turned;
        }
    }

    /// inner_roots(): the first, where there is one, then the second.
    static void find_turns(const Double& a, const Double& b, const Double& c, Mask asked, Double (&out)[2],
                           Mask (&has)[2])
    {
        const Double zero(0.0), one(1.0);
        const Bool flat = a == zero;
        const Double discriminant = b * b - Double(4.0) * a * c;
        const Double q = Double(-0.5) * (b + lanes::signed_as(xsimd::sqrt(discriminant), b));
        const Double r0 = q / a, r1 = xsimd::select(q != zero, c / q, zero);
        const Double low = xsimd::select(flat, lanes::negated(c) / b, lanes::smaller<Double>(r0, r1)),
                     high = lanes::larger<Double>(r0, r1);
        const Mask by_square = lanes::mask((!flat) & (discriminant > zero)), by_line = lanes::mask(flat & (b != zero));
        const Mask lower = asked & (by_square | by_line) & lanes::mask((low > zero) & (low < one)),
                   upper = asked & by_square & lanes::mask((high > zero) & (high < one));
        has[0] = lower | upper;
        has[1] = lower & upper;
        out[0] = xsimd::select(lanes::lanes_of(lower), low, high);
        out[1] = high;
    }

    /// safeguarded_newton() in lanes of the mask, from the chord or, where the curve is a parabola, from its root.
    static Double root(const Cubic& at, const Double& lo, const Double& hi, const Double& before, const Double& after,
                       Mask asked)
    {
        constexpr int kMost = 60;
        constexpr double kClose = 1e-16;
        const Bool negative = before < Double(0.0);
        Double t = lo + (hi - lo) * (before / (before - after));
        const Bool parabola = at.a == Double(0.0);
        if ((lanes::mask(parabola) & asked) != 0) {
            const Double only = detail::only_root_of(at.b, at.c, at.d, negative);
            t = xsimd::select(parabola & (only > lo) & (only < hi), only, t);
        }
        const auto here = [&](const Double& w) { return lanes::ValuesAndSlopes{at.value(w), at.slope(w)}; };
        return lanes::change_of_sign(here, lo, hi, negative, t, {kClose, 0.0}, kMost, asked);
    }
};

}  // namespace csg
