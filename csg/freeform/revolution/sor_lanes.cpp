#include "csg/freeform/revolution/axis_rays.h"
#include "csg/freeform/revolution/sor.h"
#include "numbers/lane_newton.h"

#include <bit>

namespace csg {

/// Sor::intersect() of as many rays as there are lanes: every number comes from the same operations in the same order.
class Sor::Tile {
public:
    static constexpr std::size_t kWide = AxisRays::kWide;

    /// Of the rays from `at` on.
    Tile(const Sor& sor, const LocalRays& local, std::size_t at, std::span<const Ray> rays, IntersectionList* out)
        : sor_(sor), out_(out), ray_(local.at(at))
    {
        last_.fill(-kInfinity);
        const Mask known = lanes::mask(ray_.valid()) & ((1u << rays.size()) - 1u), level = lanes::mask(ray_.level());
        for (Mask left = known & level; left != 0; left &= left - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(left));
            sor.intersect(rays[k], out[k]);
        }
        asked_ = known & ~level;
    }

    void run()
    {
        const double widest = std::sqrt(sor_.most_);
        const Double room = (Double(widest) - ray_.nearest) * (Double(widest) + ray_.nearest), zero(0.0);
        const Double reach = xsimd::select(
            ray_.run > zero, xsimd::sqrt(room) * ray_.rise / ray_.run * Double(1.0 + 1e-9), Double(kInfinity));
        low_ = ray_.foot - reach;
        high_ = ray_.foot + reach;
        const Segment &first = sor_.segments_.front(), &last = sor_.segments_.back();
        asked_ &= lanes::mask(room > zero) & ~lanes::mask((low_ > Double(last.high)) | (high_ < Double(first.low)));
        const Mask rising = asked_ & lanes::mask(ray_.rising());
        if (rising != 0) pass(rising, true);
        if (rising != asked_) pass(asked_ & ~rising, false);
    }

private:
    using Double = AxisRays::Double;
    using Bool = AxisRays::Bool;
    using Mask = AxisRays::Mask;

    /// The beyond_square() of a segment along the height v above the one nearest to the foot.
    struct Cubic {
        Double c3, c2, c1, c0;
        Double value(const Double& v) const { return ((c3 * v + c2) * v + c1) * v + c0; }
        Double slope(const Double& v) const { return (Double(3.0) * c3 * v + Double(2.0) * c2) * v + c1; }
    };
    /// A part of a segment where the cubic rises or falls all the way: between these heights, with these values.
    struct Piece {
        Double from, to, before, after;
    };

    /// Rays that all go up, or down.
    void pass(Mask asked, bool rising)
    {
        const Segment &first = sor_.segments_.front(), &last = sor_.segments_.back();
        const auto at_base = [&] { rim(sor_.base_, first.low, sor_.base_drawn_ ? kBase : kUndrawnFace, asked); };
        const auto at_cap = [&] { rim(sor_.cap_, last.high, sor_.cap_drawn_ ? kCap : kUndrawnFace, asked); };
        rising ? at_base() : at_cap();
        const std::size_t count = sor_.segments_.size();
        for (std::size_t n = 0; n < count && asked != 0; ++n) segment(rising ? n : count - 1 - n, rising, asked);
        rising ? at_cap() : at_base();
    }

    /// Rays through the disc that ends the solid.
    void rim(double square, double height, std::uint32_t face, Mask& asked)
    {
        const Double y(height);
        const Mask inside = asked & lanes::mask(ray_.beyond_square(Double(square), y - ray_.foot) > Double(0.0));
        if (inside != 0) toggle(ray_.at_height(y), face, inside, asked);
    }

    /// Takes the rays out of `asked` of which no more is wanted.
    void toggle(const Double& at, std::uint32_t face, Mask which, Mask& asked)
    {
        alignas(64) std::array<double, kWide> t;
        at.store_aligned(t.data());
        for (Mask left = which; left != 0; left &= left - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(left));
            last_[k] = std::max(t[k], last_[k]);
            inside_ ^= 1u << k;
            const bool more = (inside_ >> k & 1u) != 0 ? out_[k].enter(last_[k], face) : out_[k].leave(last_[k], face);
            if (!more) asked &= ~(1u << k);
        }
    }

    /// Sor::Meeting::segment().
    void segment(std::size_t index, bool rising, Mask& asked)
    {
        const Segment& s = sor_.segments_[index];
        const Double low(s.low), high(s.high), zero(0.0), outside(-1.0);
        const double top = index + 1 < sor_.segments_.size() ? sor_.segments_[index + 1].d : sor_.cap_;
        Mask near = asked & ~lanes::mask((high < low_) | (low > high_));
        if (near == 0) return;
        const Bool above = low<low_, under = high> high_;
        const Double start = xsimd::select(above, low_, low), end = xsimd::select(under, high_, high);
        near &= lanes::mask(start < end);
        if (near == 0) return;
        const Double foot = ray_.foot, middle = lanes::smaller(lanes::larger(foot, low), high), h = middle - low,
                     off = middle - foot;
        Piece whole{start - middle, end - middle,
                    xsimd::select(above, outside, ray_.beyond_square(Double(s.d), low - foot)),
                    xsimd::select(under, outside, ray_.beyond_square(Double(top), high - foot))};
        const Double a(s.a), b(s.b), c(s.c), rise2 = ray_.rise * ray_.rise, run2 = ray_.run * ray_.run;
        const Double slope = (Double(3.0 * s.a) * h + Double(2.0 * s.b)) * h + c;
        const Cubic cubic{rise2 * a, rise2 * (Double(3.0 * s.a) * h + b) - run2,
                          rise2 * slope - Double(2.0) * run2 * off,
                          ray_.beyond_square(((a * h + b) * h + c) * h + Double(s.d), off)};
        const std::array<Piece, 3> pieces = parted(cubic, whole);
        for (std::size_t n = 0; n < pieces.size(); ++n) {
            const Piece& piece = pieces[rising ? n : pieces.size() - 1 - n];
            const Bool begins_out = piece.before > zero, ends_out = piece.after > zero;
            const Mask changes = near & asked & (lanes::mask(begins_out) ^ lanes::mask(ends_out));
            if (changes == 0) continue;
            const Double v = root(cubic, piece, !begins_out, changes), w = h + v;
            const Double room = (((a * w + b) * w + c) * w + Double(s.d)) - ray_.nearest * ray_.nearest;
            toggle(ray_.at_square(room, middle + v, off + v < zero), kFirstSide + static_cast<std::uint32_t>(index),
                   changes, asked);
        }
    }

    /// At the cubic's turning points. What is not cut has pieces of no length that nothing changes along.
    static std::array<Piece, 3> parted(const Cubic& cubic, const Piece& whole)
    {
        const Double zero(0.0), half = cubic.c2, discriminant = half * half - Double(3.0) * cubic.c3 * cubic.c1;
        const Bool turns = discriminant > zero;
        std::array<Piece, 3> pieces{Piece{whole.from, whole.from, whole.before, whole.before},
                                    Piece{whole.from, whole.from, whole.before, whole.before}, whole};
        if (lanes::mask(turns) == 0) return pieces;
        const Double size = xsimd::sqrt(lanes::larger(discriminant, zero));
        const Double q = lanes::negated(half + (size | (half & Double(-0.0))));
        const Double one = q / (Double(3.0) * cubic.c3), other = cubic.c1 / q;
        Double from = whole.from, before = whole.before;
        const std::array<Double, 2> cuts{lanes::smaller(one, other), lanes::larger(one, other)};
        for (std::size_t n = 0; n < cuts.size(); ++n) {
            const Bool cut = turns & (cuts[n] > from) & (cuts[n] < whole.to);
            const Double to = xsimd::select(cut, cuts[n], from), after = xsimd::select(cut, cubic.value(to), before);
            pieces[n] = {from, to, before, after};
            from = to;
            before = after;
        }
        pieces[2] = {from, whole.to, before, whole.after};
        return pieces;
    }

    static Double root(const Cubic& cubic, const Piece& piece, const Bool& negative_at_from, Mask asked)
    {
        lanes::Newton newton{piece.from, piece.to, Double(0.5) * (piece.from + piece.to), negative_at_from};
        for (int step = 0; step < kMostSteps && asked != 0; ++step)
            newton.step({cubic.value(newton.t), cubic.slope(newton.t)}, Double(kClose) * xsimd::abs(newton.t), asked);
        return newton.t;
    }

    const Sor& sor_;
    IntersectionList* out_;
    AxisRays ray_;
    Double low_, high_;  ///< farther up and down a ray is farther from the axis than any of the solid
    Mask asked_ = 0, inside_ = 0;
    std::array<double, kWide> last_;
};

void Sor::intersect_many(std::span<const Ray> rays, IntersectionList* out) const
{
    if (segments_.empty()) return;
    intersect_in_lanes<Tile>(*this, rays, out);
}

}  // namespace csg
