#include "csg/freeform/revolution/axis_rays.h"
#include "csg/freeform/revolution/sor.h"
#include "numbers/lane_newton.h"

#include <bit>

namespace csg {

/// How far the curve at a height lies beyond what a ray sweeps about the axis tells whether the ray is inside there.
/// \tparam T double: one ray; lanes: a ray each, and a bit of a mask
template <class T>
class Sor::Meeting {
public:
    using Mask = std::uint32_t;

    /// Of rays that are not level.
    Meeting(const Sor& sor, const AxisRayOf<T>& ray, Mask asked, IntersectionList* out)
        : sor_(sor), out_(out), ray_(ray), asked_(asked)
    {
        last_.fill(-kInfinity);
    }

    void run()
    {
        const T widest(std::sqrt(sor_.most_)), room = (widest - ray_.nearest) * (widest + ray_.nearest), zero(0.0);
        asked_ &= lanes::mask(room > zero);
        if (asked_ == 0) return;
        const T reach = lanes::either(
            ray_.run > zero, [&] { return lanes::root_of(room) * ray_.rise / ray_.run * T(1.0 + 1e-9); },
            [] { return T(kInfinity); });
        low_ = ray_.foot - reach;
        high_ = ray_.foot + reach;
        const Segment &first = sor_.segments_.front(), &last = sor_.segments_.back();
        asked_ &= ~lanes::mask(low_ > T(last.high) || high_ < T(first.low));
        const Mask rising = asked_ & lanes::mask(ray_.rising());
        if (rising != 0) pass(rising, true);
        if (rising != asked_) pass(asked_ & ~rising, false);
    }

private:
    using Truth = lanes::Truth<T>;
    static constexpr std::size_t kWide = sizeof(T) / sizeof(double);

    /// The beyond_square() of a segment along the height v above the one nearest to the foot.
    struct Cubic {
        T c3, c2, c1, c0;
        T value(const T& v) const { return ((c3 * v + c2) * v + c1) * v + c0; }
        T slope(const T& v) const { return (T(3.0) * c3 * v + T(2.0) * c2) * v + c1; }
    };
    /// A part of a segment where the cubic rises or falls all the way: between these heights, with these values.
    struct Piece {
        T from, to, before, after;
    };
    struct Pieces {
        std::size_t count = 0;
        std::array<Piece, 3> of;  // filled as far as the count says
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
        const T y(height);
        const Mask inside = asked & lanes::mask(ray_.beyond_square(T(square), y - ray_.foot) > T(0.0));
        if (inside != 0) toggle(ray_.at_height(y), face, inside, asked);
    }

    /// Takes the rays out of `asked` of which no more is wanted.
    void toggle(const T& at, std::uint32_t face, Mask which, Mask& asked)
    {
        alignas(64) std::array<double, kWide> t;
        lanes::store(at, t.data());
        for (Mask left = which; left != 0; left &= left - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(left));
            last_[k] = std::max(t[k], last_[k]);
            inside_ ^= 1u << k;
            const bool more = (inside_ >> k & 1u) != 0 ? out_[k].enter(last_[k], face) : out_[k].leave(last_[k], face);
            if (!more) asked &= ~(1u << k);
        }
    }

    /// The sides of one segment, in the ray's order.
    void segment(std::size_t index, bool rising, Mask& asked)
    {
        const Segment& s = sor_.segments_[index];
        const T low(s.low), high(s.high), zero(0.0), outside(-1.0);
        // Squared radii that neighbours share, so that both agree on which side of the ray's the joint lies.
        const double top = index + 1 < sor_.segments_.size() ? sor_.segments_[index + 1].d : sor_.cap_;
        Mask near = asked & ~lanes::mask(high < low_ || low > high_);
        if (near == 0) return;
        const Truth above = low_ > low, under = high_ < high;
        const T start = lanes::choose(above, low_, low), end = lanes::choose(under, high_, high);
        near &= lanes::mask(start < end);
        if (near == 0) return;
        // Around the height nearest to the foot, where a nearly level ray has all of its roots.
        const T foot = ray_.foot, middle = lanes::smaller(lanes::larger(foot, low), high), h = middle - low,
                off = middle - foot;
        const Piece whole{start - middle, end - middle,
                          lanes::choose(above, outside, ray_.beyond_square(T(s.d), low - foot)),
                          lanes::choose(under, outside, ray_.beyond_square(T(top), high - foot))};
        const T rise2 = ray_.rise * ray_.rise, run2 = ray_.run * ray_.run;
        const Cubic cubic{rise2 * T(s.a), rise2 * (T(3.0 * s.a) * h + T(s.b)) - run2,
                          rise2 * s.slope(h) - T(2.0) * run2 * off, ray_.beyond_square(s.square(h), off)};
        const Pieces pieces = parted(cubic, whole);
        for (std::size_t n = 0; n < pieces.count; ++n) {
            const Piece& piece = pieces.of[rising ? n : pieces.count - 1 - n];
            const Truth begins_out = piece.before > zero, ends_out = piece.after > zero;
            const Mask changes = near & asked & (lanes::mask(begins_out) ^ lanes::mask(ends_out));
            if (changes == 0) continue;
            const auto at = [&](const T& v) { return lanes::Sloped<T>{cubic.value(v), cubic.slope(v)}; };
            const T v = lanes::change_of_sign(at, piece.from, piece.to, !begins_out, T(0.5) * (piece.from + piece.to),
                                              {0.0, kClose}, kMostSteps, changes);
            const T room = s.square(T(h + v)) - ray_.nearest * ray_.nearest;
            toggle(ray_.at_square(room, middle + v, off + v < zero), kFirstSide + static_cast<std::uint32_t>(index),
                   changes, asked);
        }
    }

    /// At the cubic's turning points. A lane that is not cut where another is has a piece of no length there.
    static Pieces parted(const Cubic& cubic, const Piece& whole)
    {
        const T half = cubic.c2, discriminant = half * half - T(3.0) * cubic.c3 * cubic.c1, zero(0.0);
        const Truth turns = discriminant > zero;
        Pieces pieces;
        T from = whole.from, before = whole.before;
        const auto cut_at = [&](const T& v) {
            const Truth cut = turns && v > from && v < whole.to;
            if (lanes::mask(cut) == 0) return;
            const T to = lanes::choose(cut, v, from), after = lanes::choose(cut, cubic.value(to), before);
            pieces.of[pieces.count++] = {from, to, before, after};
            from = to;
            before = after;
        };
        if (lanes::mask(turns) != 0) {
            const T q =
                lanes::negated(half + lanes::signed_as(lanes::root_of(lanes::larger(discriminant, zero)), half));
            const T one = q / (T(3.0) * cubic.c3), other = cubic.c1 / q;
            cut_at(lanes::smaller(one, other));
            cut_at(lanes::larger(one, other));
        }
        pieces.of[pieces.count++] = {from, whole.to, before, whole.after};
        return pieces;
    }

    static constexpr double kClose = 1e-16;  // of a root: a step no longer than this much of it is the last
    static constexpr int kMostSteps = 100;

    const Sor& sor_;
    IntersectionList* out_;
    const AxisRayOf<T>& ray_;
    T low_, high_;  ///< farther up and down a ray is farther from the axis than any of the solid
    Mask asked_, inside_ = 0;
    std::array<double, kWide> last_;
};

void Sor::intersect(const Ray& ray, IntersectionList& out) const
{
    const AxisRay seen(ray);
    if (!seen.valid() || segments_.empty()) return;
    if (seen.level()) meet_level(seen, out);
    else Meeting<double>(*this, seen, 1, &out).run();
}

void Sor::meet_level(const AxisRay& ray, IntersectionList& out) const
{
    const double y = ray.foot;
    if (!(y >= segments_.front().low && y <= segments_.back().high)) return;
    const Segment& s = segment_at(y);
    const double room = s.square(y - s.low) - ray.nearest * ray.nearest;
    if (!(room > 0.0)) return;
    const auto face = kFirstSide + static_cast<std::uint32_t>(&s - segments_.data());
    const double a = ray.at_square(room, y, true), b = ray.at_square(room, y, false);
    if (out.enter(std::min(a, b), face)) out.leave(std::max(a, b), face);
}

void Sor::intersect_many(std::span<const Ray> rays, IntersectionList* out) const
{
    if (segments_.empty()) return;
    const auto tile = [this](const AxisRays& ray, AxisRays::Mask asked, std::span<const Ray>, IntersectionList* told) {
        Meeting<lanes::Double>(*this, ray, asked, told).run();
    };
    intersect_in_lanes(*this, rays, out, tile);
}

}  // namespace csg
