#include "csg/freeform/revolution/lathe.h"
#include "csg/freeform/revolution/axis_rays.h"
#include "csg/freeform/revolution/lathe_limits.h"
#include "csg/freeform/revolution/lathe_point.h"
#include "csg/freeform/revolution/lathe_reach.h"
#include "csg/freeform/revolution/lathe_told.h"
#include "numbers/lane_newton.h"

#include <bit>
#include <tuple>

namespace csg {

/// Lathe::intersect() of as many rays as there are lanes: every number comes from the same operations in the same
/// order. What is done for some lanes of a vector only is told by masks.
class Lathe::Tile {
public:
    static constexpr std::size_t kWide = AxisRays::kWide;

    Tile(const Lathe& lathe, const AxisRays& ray, AxisRays::Mask asked, std::span<const Ray> rays,
         IntersectionList* out)
        : lathe_(lathe), rays_(rays), out_(out), ray_(ray), asked_(asked)
    {
        alignas(64) Numbers from, to;
        from.fill(-kInfinity);
        to.fill(kInfinity);
        for (std::size_t k = 0; k < rays.size(); ++k) {
            told_[k].begin(out[k]);
            if (out[k].first_only) from[k] = out[k].from, to[k] = out[k].to;
        }
        lathe_heights<Double>(ray_, Double::load_aligned(from.data()), Double::load_aligned(to.data()), low_, high_);
    }

    void run()
    {
        for (std::size_t b = 0; b < lathe_.reaches_.size(); ++b) {
            Mask near = asked_;
            if (!lathe_.groups_.empty()) near &= ~misses(lathe_.groups_[b / Reaches::kArcs], b % Reaches::kArcs);
            const std::size_t first = b * Reaches::kArcs, most = std::min(Reaches::kArcs, lathe_.arcs_.size() - first);
            for (std::size_t i = 0; i < most && near != 0; ++i)
                if (const Mask met = near & ~misses(lathe_.reaches_[b], i); met != 0)
                    meet_arc(static_cast<std::uint32_t>(first + i), met);
        }
        find_roots();
        for (Mask left = asked_; left != 0; left &= left - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(left));
            Told& told = told_[k];
            told.resolve_waiting([&](const Waiting& one) { told.add(one.t, one.face); });
            if (told.first_only()) {
                told.tell_nearest(out_[k]);
                continue;
            }
            const AxisRay ray(rays_[k]);
            for (const glm::dvec2& rim : lathe_.rims_)
                if (ray.beyond(rim.x, rim.y - ray.foot) > 0.0) told.add(ray.at_height(rim.y), kUndrawnFace);
            const auto is_negative = [&](std::uint32_t face) { return lathe_.arcs_[face].negative; };
            told.tell(ray, lathe_.hole_, is_negative, out_[k]);
        }
    }

private:
    using Double = AxisRays::Double;
    using Bool = AxisRays::Bool;
    using Mask = AxisRays::Mask;
    using Range = SlopeRangeOf<Double>;
    using Numbers = std::array<double, kWide>;
    /// A crossing that has been worked out, but for other rays' sake.
    struct Waiting {
        double nearest, t;
        std::uint32_t face;
    };
    using Told = LatheTold<Waiting>;
    struct Place {
        Double x, y;
    };
    static Bool negative(const Double& v) { return v < Double(0.0); }
    /// LathePoint.
    struct Point {
        Double w, radius, height, above, slope_radius, slope_above, beyond;
        Bool out() const { return beyond > Double(0.0); }
    };
    static Point chosen(const Bool& which, const Point& a, const Point& b)
    {
        return {lanes::choose(which, a.w, b.w),
                lanes::choose(which, a.radius, b.radius),
                lanes::choose(which, a.height, b.height),
                lanes::choose(which, a.above, b.above),
                lanes::choose(which, a.slope_radius, b.slope_radius),
                lanes::choose(which, a.slope_above, b.slope_above),
                lanes::choose(which, a.beyond, b.beyond)};
    }
    static Place at(const Arc& arc, const Double& w)
    {
        const auto of = [&](int k) {
            return ((Double(arc.a[k]) * w + Double(arc.b[k])) * w + Double(arc.c[k])) * w + Double(arc.d[k]);
        };
        return {of(0), of(1)};
    }
    static Place slope(const Arc& arc, const Double& w)
    {
        const auto of = [&](int k) {
            return (Double(3.0 * arc.a[k]) * w + Double(2.0 * arc.b[k])) * w + Double(arc.c[k]);
        };
        return {of(0), of(1)};
    }

    /// Lathe::Sweep::misses() of one of eight.
    Mask misses(const Reaches& reach, std::size_t k) const
    {
        const Double low(reach.low[k]), high(reach.high[k]);
        return lanes::mask(passes_by(ray_, low, high, Double(reach.nearest[k]), Double(reach.farthest[k])) |
                           (high < low_) | (low > high_));
    }

    Point point(const Place& slope, const Double& w, const Double& radius, const Double& height,
                const Double& above) const
    {
        return {w, radius, height, above, slope.x, slope.y, ray_.beyond(radius, above)};
    }

    /// Lathe::Meeting::meet_arc().
    void meet_arc(std::uint32_t index, Mask asked)
    {
        const Arc& arc = lathe_.arcs_[index];
        face_ = index;
        const Double start_y(arc.start.y), end_y(arc.end.y), above_start = start_y - ray_.foot,
                                                             above_end = end_y - ray_.foot;
        const Point start = point({Double(arc.start_slope.x), Double(arc.start_slope.y)}, Double(arc.lo),
                                  Double(arc.start.x), start_y, above_start),
                    end = point({Double(arc.end_slope.x), Double(arc.end_slope.y)}, Double(arc.hi), Double(arc.end.x),
                                end_y, above_end);
        const Bool passing = lanes::differ(negative(above_start), negative(above_end));
        const Mask passes = asked & lanes::mask(passing);
        if (passes == 0) {
            meet_cell(arc, start, end, negative(above_start + above_end), asked);
            return;
        }
        const Double w = level_parameter(arc, above_start, above_end, passes);
        const Double nearer(glm::min(arc.start.x, arc.end.x)), farther(glm::max(arc.start.x, arc.end.x));
        const Double radius = lanes::smaller(lanes::larger(at(arc, w).x, nearer), farther);
        const Point foot = point(slope(arc, w), w, radius, ray_.foot, Double(0.0));
        const Bool from_below = negative(above_start);
        meet_cell(arc, start, chosen(passing, foot, end),
                  (passing & from_below) | ((!passing) & negative(above_start + above_end)), asked);
        meet_cell(arc, foot, end, !from_below, passes);
    }

    void meet_cell(const Arc& arc, const Point& start, const Point& end, const Bool& below, Mask asked)
    {
        if (arc.straight) {
            meet_line(arc, start, end, below, asked);
        } else {
            cells_left_ = Double(LatheLimits::kMostCells);
            meet_curve(arc, start, end, below, asked);
        }
    }

    Double level_parameter(const Arc& arc, const Double& above_start, const Double& above_end, Mask asked) const
    {
        const Double lo(arc.lo), hi(arc.hi);
        const Double w = lo + (hi - lo) * (above_start / (above_start - above_end));
        if (arc.straight) return w;
        const auto level = [&](const Double& v) {
            return lanes::ValuesAndSlopes{at(arc, v).y - ray_.foot, slope(arc, v).y};
        };
        return lanes::change_of_sign(level, lo, hi, negative(above_start), w, {LatheLimits::kClose, 0.0}, 60, asked);
    }

    void meet_line(const Arc& arc, const Point& start, const Point& end, const Bool& below, Mask asked)
    {
        const Double r(arc.d.x), u = Double(arc.d.y) - ray_.foot, dr(arc.c.x), du(arc.c.y), zero(0.0);
        const Double rise2 = ray_.rise * ray_.rise, run2 = ray_.run * ray_.run;
        const Double a = rise2 * dr * dr - run2 * du * du, b = rise2 * r * dr - run2 * u * du, c = ray_.beyond(r, u);
        const Double cross = ray_.run * (r * du - u * dr),
                     discriminant = rise2 * (cross * cross + ray_.nearest * ray_.nearest * a);
        const Bool out = start.out(), changing = lanes::differ(out, end.out()), turned = lanes::differ(out, a > zero);
        const Mask changes = asked & lanes::mask(changing);
        Mask twice = asked & ~changes & lanes::mask((discriminant > zero) & (!turned));
        if ((changes | twice) == 0) return;
        const Double q = lanes::negated(b + lanes::signed_as(xsimd::sqrt(lanes::larger(discriminant, zero)), b));
        const Double one = q / a, other = lanes::choose(q != zero, c / q, zero);
        const Double first = lanes::smaller(one, other), last = lanes::larger(one, other);
        twice &= lanes::mask((first > start.w) & (last < end.w));
        Double w = lanes::choose(a == zero, other, lanes::choose(turned, last, first));
        w = lanes::choose(w >= start.w, w, start.w);
        w = lanes::choose(w <= end.w, w, end.w);
        w = lanes::choose(changing, w, first);
        add_at(arc, w, below, changes | twice);
        if (twice != 0) add_at(arc, last, below, twice);
    }

    void add_at(const Arc& arc, const Double& w, const Bool& below, Mask asked)
    {
        find_roots();  // in order
        alignas(64) Numbers t;
        place(arc, w, below).store_aligned(t.data());
        for (; asked != 0; asked &= asked - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(asked));
            told_[k].add(t[k], face_);
        }
    }
    /// The ray's parameter where it meets the arc at w.
    Double place(const Arc& arc, const Double& w, const Bool& below) const
    {
        const Place p = at(arc, w), d = slope(arc, w);
        return ray_.polished(ray_.at(p.x, p.y, below), p.x, p.y, d.x, d.y);
    }

    /// Lathe::Meeting::meet_curve().
    void meet_curve(const Arc& arc, const Point& start, const Point& end, const Bool& below, Mask asked)
    {
        const Double rise2 = ray_.rise * ray_.rise, run2 = ray_.run * ray_.run;
        Range gain = slope_range(start.radius, end.radius, start.slope_radius, end.slope_radius);
        Range loss = slope_range(start.above, end.above, start.slope_above, end.slope_above);
        gain.least = gain.least * rise2, gain.most = gain.most * rise2;
        loss.least = loss.least * run2, loss.most = loss.most * run2;
        const Mask changes = asked & lanes::mask(lanes::differ(start.out(), end.out()));
        const Double width = end.w - start.w;
        const Double steepest = Double(2.0) * lanes::larger(gain.most - loss.least, loss.most - gain.least);
        asked &= changes | ~lanes::mask(xsimd::abs(start.beyond) + xsimd::abs(end.beyond) > width * steepest);
        if (asked == 0) return;
        Mask open = asked & ~lanes::mask(apart(gain, loss));
        if (open != 0) open &= ~lanes::mask(falls_by_roots(start, end, gain.negative));
        if (open != 0) open &= ~lanes::mask(width < Double(LatheLimits::kNarrow));
        if (open != 0) {
            cells_left_ = lanes::choose(lanes::lanes_of(open), cells_left_ - Double(1.0), cells_left_);
            open &= ~lanes::mask(negative(cells_left_));
        }
        if (const Mask roots = asked & ~open & changes; roots != 0) add_between(start, end, below, roots);
        if (open == 0) return;
        const Double w = Double(0.5) * (start.w + end.w);
        const Place p = at(arc, w);
        const Point middle = point(slope(arc, w), w, p.x, p.y, p.y - ray_.foot);
        meet_curve(arc, start, middle, below, open);
        meet_curve(arc, middle, end, below, open);
    }

    Bool falls_by_roots(const Point& start, const Point& end, const Bool& toward_axis) const
    {
        const Double c = ray_.nearest, r0 = xsimd::abs(start.radius), r1 = xsimd::abs(end.radius);
        const Double least = lanes::smaller(r0, r1), most = lanes::larger(r0, r1);
        const Bool clear = least > c;
        if (lanes::mask(clear) == 0) return clear;
        const Double factor_least = most / xsimd::sqrt((most - c) * (most + c)),
                     factor_most = least / xsimd::sqrt((least - c) * (least + c));
        Range gain =
            slope_range(ray_.rise * factor_least, ray_.rise * factor_most, start.slope_radius, end.slope_radius);
        gain.negative = toward_axis;
        Range loss = slope_range(ray_.run, ray_.run, start.slope_above, end.slope_above);
        loss.negative = lanes::differ(negative(start.slope_above + end.slope_above), negative(start.above + end.above));
        return clear & apart(gain, loss);
    }

    /// A crossing lies between these. Those of a few cells are closed in on together: a step of one is worked out while
    /// another waits for its quotient.
    void add_between(const Point& start, const Point& end, const Bool& below, Mask asked)
    {
        if (root_count_ == kMostRoots) find_roots();
        Root& root = roots_[root_count_++];
        root.face = face_;
        root.asked = asked;
        root.below = below;
        std::tie(root.nearest, root.farthest) = ray_.between(start.radius, start.height, end.radius, end.height, below);
        prepare(root, start, end);
    }

    void find_roots()
    {
        for (int step = 0; step < kMostSteps; ++step) {
            Mask open = 0;
            for (std::size_t i = 0; i < root_count_; ++i)
                if (Root& root = roots_[i]; root.open != 0) {
                    root.newton.step(evaluated(root), LatheLimits::kClose, root.open);
                    open |= root.open;
                }
            if (open == 0) break;
        }
        for (std::size_t i = 0; i < root_count_; ++i) add_root(roots_[i]);
        root_count_ = 0;
    }

    /// A crossing on an arc between two points, of which one is out.
    struct Root {
        lanes::Newton newton;
        Double sign, nearest, farthest;
        Bool by_roots, below;
        Mask asked, open, rooted;
        std::uint32_t face;
    };

    Double across(const Double& r) const
    {
        return xsimd::sqrt(lanes::larger((r - ray_.nearest) * (r + ray_.nearest), Double(0.0)));
    }
    Double by_root(const Double& along, const Double& above) const
    {
        return ray_.rise * along - ray_.run * xsimd::abs(above);
    }

    /// Lathe::Meeting::refined(), up to its first step, ...
    void prepare(Root& root, const Point& start, const Point& end) const
    {
        const Double c = ray_.nearest, half(0.5);
        root.sign = lanes::choose(negative(start.above + end.above), Double(-1.0), Double(1.0));
        root.by_roots = (ray_.rise < ray_.run) & (xsimd::abs(start.radius) > c) & (xsimd::abs(end.radius) > c);
        root.rooted = lanes::mask(root.by_roots) & root.asked;
        root.open = root.asked;
        Double before = start.beyond, after = end.beyond;
        if (root.rooted != 0) {
            before = lanes::choose(root.by_roots, by_root(across(start.radius), start.above), before);
            after = lanes::choose(root.by_roots, by_root(across(end.radius), end.above), after);
        }
        const Double lo = start.w, hi = end.w;
        const Double w = lanes::choose(before != after, lo + (hi - lo) * (before / (before - after)), half * (lo + hi));
        root.newton = {lo, hi, lanes::choose((w > lo) & (w < hi), w, half * (lo + hi)), !start.out()};
    }
    /// ... what it asks at each, ...
    lanes::ValuesAndSlopes evaluated(const Root& root) const
    {
        const Arc& arc = lathe_.arcs_[root.face];
        const Double &v = root.newton.t, zero(0.0);
        const Place p = at(arc, v), d = slope(arc, v);
        const Double above = p.y - ray_.foot;
        lanes::ValuesAndSlopes found{zero, zero};
        if (root.rooted != root.asked)
            found = {ray_.beyond(p.x, above),
                     Double(2.0) * (ray_.rise * ray_.rise * p.x * d.x - ray_.run * ray_.run * above * d.y)};
        if (root.rooted == 0) return found;
        const Double along = across(p.x);
        return {lanes::choose(root.by_roots, by_root(along, above), found.value),
                lanes::choose(root.by_roots, ray_.rise * d.x * p.x / along - ray_.run * root.sign * d.y, found.slope)};
    }
    /// ... and what comes of it.
    void add_root(const Root& root)
    {
        alignas(64) Numbers t, least, most;
        place(lathe_.arcs_[root.face], root.newton.t, root.below).store_aligned(t.data());
        root.nearest.store_aligned(least.data());
        root.farthest.store_aligned(most.data());
        for (Mask left = root.asked; left != 0; left &= left - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(left));
            Told& told = told_[k];
            if (told.first_only())
                told.wait({least[k], t[k], root.face}, most[k], [&](const Waiting& one) { told.add(one.t, one.face); });
            else told.add(t[k], root.face);
        }
    }

    static constexpr std::size_t kMostRoots = 4;
    static constexpr int kMostSteps = 80;

    const Lathe& lathe_;
    std::span<const Ray> rays_;
    IntersectionList* out_;
    AxisRays ray_;
    Double low_, high_;  ///< heights of the range that is asked for
    Double cells_left_ = Double(0.0);
    Mask asked_;
    std::uint32_t face_ = 0;
    std::size_t root_count_ = 0;
    std::array<Root, kMostRoots> roots_;
    std::array<Told, kWide> told_;
};

bool Lathe::intersects_many() const { return true; }

void Lathe::intersect_many(std::span<const Ray> rays, IntersectionList* out) const
{
    const auto tile = [this](const AxisRays& ray, AxisRays::Mask asked, std::span<const Ray> of,
                             IntersectionList* told) { Tile(*this, ray, asked, of, told).run(); };
    intersect_in_lanes(*this, rays, out, tile);
}

}  // namespace csg
