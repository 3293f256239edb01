#include "csg/freeform/revolution/lathe_limits.h"
#include "csg/freeform/revolution/lathe_point.h"
#include "csg/freeform/revolution/lathe_reach.h"
#include "csg/freeform/revolution/lathe_told.h"
#include "numbers/safeguarded_newton.h"

namespace csg {

/// Arcs all of whose circles lie on one side of what a ray sweeps about the axis or, where the nearest end is enough,
/// which the ray passes out of the range that is asked for.
class Lathe::Sweep {
public:
    Sweep(const AxisRay& ray, double from, double to, bool first_only)
        : ray_{ray.rise, ray.run, ray.nearest, ray.foot}, by_range_(first_only && !ray.level())
    {
        if (!by_range_) return;
        double low = 0.0, high = 0.0;
        lathe_heights<double>(ray, from, to, low, high);
        low_ = Double(low);
        high_ = Double(high);
    }

    std::uint32_t misses(const Reaches& reach, int at) const
    {
        const Double low = Double::load_aligned(reach.low + at), high = Double::load_aligned(reach.high + at);
        auto missed = passes_by(ray_, low, high, Double::load_aligned(reach.nearest + at),
                                Double::load_aligned(reach.farthest + at));
        if (by_range_) missed = missed | (high < low_) | (low > high_);
        return lanes::mask(missed);
    }

private:
    using Double = lanes::Double;

    AxisSweep<Double> ray_;
    Double low_, high_;
    bool by_range_;
};

/// One ray through a lathe.
class Lathe::Meeting {
public:
    Meeting(const Lathe& lathe, const Ray& ray, const IntersectionList& wanted) : lathe_(lathe), ray_(ray)
    {
        told_.begin(wanted);
    }

    void find()
    {
        if (!ray_.valid()) return;
        const Sweep sweep(ray_, told_.from(), told_.to(), told_.first_only());
        lathe_.each_near(sweep, [&](std::size_t arc) { meet_arc(static_cast<std::uint32_t>(arc)); });
        told_.resolve_waiting([&](const Waiting& one) { resolve(one); });
        if (ray_.level() || told_.first_only()) return;
        for (const glm::dvec2& rim : lathe_.rims_)
            if (ray_.beyond(rim.x, rim.y - ray_.foot) > 0.0) told_.add(ray_.at_height(rim.y), kUndrawnFace);
    }

    void tell(IntersectionList& out) const
    {
        if (told_.first_only()) return told_.tell_nearest(out);
        const auto is_negative = [&](std::uint32_t face) { return lathe_.arcs_[face].negative; };
        told_.tell(ray_, lathe_.hole_, is_negative, out);
    }

private:
    /// A crossing between two points of an arc that is still to be found, no nearer than `nearest`.
    struct Waiting {
        double nearest, side;
        std::uint32_t face;
        LathePoint start, end;
    };

    LathePoint point(const Arc& arc, double w, double radius, double height, double above) const
    {
        return point(arc.slope(w), w, radius, height, above);
    }
    LathePoint point(const glm::dvec2& slope, double w, double radius, double height, double above) const
    {
        return {w, radius, height, above, slope.x, slope.y, ray_.beyond(radius, above)};
    }
    /// A crossing lies between these. Where one is enough, those out of the range that was asked for are left out, and
    /// the others wait for their turn, the nearest first. Where all are told, those out of the range are as exact as
    /// any: CSG goes on from them.
    void add_between(const Arc& arc, const LathePoint& start, const LathePoint& end, double side)
    {
        if (!told_.first_only()) return add_at(arc, refined(arc, start, end), side);
        const auto [least, most] = ray_.between(start.radius, start.height, end.radius, end.height, side < 0.0);
        told_.wait({least, side, face_, start, end}, most, [&](const Waiting& one) { resolve(one); });
    }
    void resolve(const Waiting& one)
    {
        const Arc& arc = lathe_.arcs_[one.face];
        face_ = one.face;
        add_at(arc, refined(arc, one.start, one.end), one.side);
    }
    void add_at(const Arc& arc, double w, double side)
    {
        const glm::dvec2 p = arc.at(w), d = arc.slope(w);
        told_.add(ray_.polished(ray_.at(p.x, p.y, side < 0.0), p.x, p.y, d.x, d.y), face_);
    }

    void meet_arc(std::uint32_t index)
    {
        face_ = index;
        const Arc& arc = lathe_.arcs_[index];
        const double above_start = arc.start.y - ray_.foot, above_end = arc.end.y - ray_.foot;
        const bool passes = (above_start < 0.0) != (above_end < 0.0);
        if (ray_.level()) {
            if (!passes) return;
            const double radius = arc.at(level_parameter(arc, above_start, above_end)).x;
            if (!(std::abs(radius) > ray_.nearest)) return;
            told_.add(ray_.at(radius, ray_.foot, true), index);
            told_.add(ray_.at(radius, ray_.foot, false), index);
            return;
        }
        const LathePoint start = point(arc.start_slope, arc.lo, arc.start.x, arc.start.y, above_start);
        const LathePoint end = point(arc.end_slope, arc.hi, arc.end.x, arc.end.y, above_end);
        if (!passes) {
            meet_cell(arc, start, end, above_start + above_end);
            return;
        }
        // Below and above the foot the ray meets a circle on different sides; a nearly level ray does so close
        // together.
        const double w = level_parameter(arc, above_start, above_end);
        const double radius =
            glm::clamp(arc.at(w).x, glm::min(arc.start.x, arc.end.x), glm::max(arc.start.x, arc.end.x));
        const LathePoint foot = point(arc, w, radius, ray_.foot, 0.0);
        meet_cell(arc, start, foot, above_start < 0.0 ? -1.0 : 1.0);
        meet_cell(arc, foot, end, above_start < 0.0 ? 1.0 : -1.0);
    }

    void meet_cell(const Arc& arc, const LathePoint& start, const LathePoint& end, double side)
    {
        if (arc.straight) {
            meet_line(arc, start, end, side);
        } else {
            cells_left_ = LatheLimits::kMostCells;
            meet_curve(arc, start, end, side);
        }
    }

    /// Where the arc has the height of the foot.
    double level_parameter(const Arc& arc, double above_start, double above_end) const
    {
        const double w = arc.lo + (arc.hi - arc.lo) * (above_start / (above_start - above_end));
        if (arc.straight) return w;
        const auto at = [&](double v) { return ValueAndSlope{arc.at(v).y - ray_.foot, arc.slope(v).y}; };
        return safeguarded_newton(at, arc.lo, arc.hi, above_start < 0.0, w, {kClose, 0.0}, 60);
    }

    /// beyond() along a straight arc is a quadratic whose discriminant needs no difference of nearly equal numbers but
    /// where the ray is a tangent.
    void meet_line(const Arc& arc, const LathePoint& start, const LathePoint& end, double side)
    {
        const double r = arc.d.x, u = arc.d.y - ray_.foot, dr = arc.c.x, du = arc.c.y;
        const double rise2 = ray_.rise * ray_.rise, run2 = ray_.run * ray_.run;
        const double a = rise2 * dr * dr - run2 * du * du, b = rise2 * r * dr - run2 * u * du, c = ray_.beyond(r, u);
        const double cross = ray_.run * (r * du - u * dr),
                     discriminant = rise2 * (cross * cross + ray_.nearest * ray_.nearest * a);
        const bool changes = start.out() != end.out();
        if (!changes && (!(discriminant > 0.0) || start.out() != (a > 0.0))) return;
        const double q = -(b + std::copysign(std::sqrt(glm::max(discriminant, 0.0)), b));
        const double one = q / a, other = q != 0.0 ? c / q : 0.0;
        const double first = glm::min(one, other), last = glm::max(one, other);
        if (!changes) {
            if (!(first > start.w && last < end.w)) return;
            add_at(arc, first, side);
            add_at(arc, last, side);
            return;
        }
        double w = a == 0.0 ? other : start.out() == (a > 0.0) ? first : last;
        if (!(w >= start.w)) w = start.w;
        if (!(w <= end.w)) w = end.w;
        add_at(arc, w, side);
    }

    /// Bisects until beyond() rises or falls all the way, or cannot be 0.
    void meet_curve(const Arc& arc, const LathePoint& start, const LathePoint& end, double side)
    {
        const double rise2 = ray_.rise * ray_.rise, run2 = ray_.run * ray_.run;
        // Half of its slope is the difference of these.
        SlopeRange gain = slope_range(start.radius, end.radius, start.slope_radius, end.slope_radius);
        SlopeRange loss = slope_range(start.above, end.above, start.slope_above, end.slope_above);
        gain.least *= rise2, gain.most *= rise2;
        loss.least *= run2, loss.most *= run2;
        const bool changes = start.out() != end.out();
        const double width = end.w - start.w;
        if (!changes) {
            // Cheaper than the questions below, which would end in the same.
            const double steepest = 2.0 * glm::max(gain.most - loss.least, loss.most - gain.least);
            if (std::abs(start.beyond) + std::abs(end.beyond) > width * steepest) return;
        }
        if (apart(gain, loss) || falls_by_roots(start, end, gain.negative) || width < kNarrow || --cells_left_ < 0) {
            if (changes) add_between(arc, start, end, side);
            return;
        }
        const double w = 0.5 * (start.w + end.w);
        const glm::dvec2 p = arc.at(w);
        const LathePoint middle = point(arc, w, p.x, p.y, p.y - ray_.foot);
        meet_curve(arc, start, middle, side);
        meet_curve(arc, middle, end, side);
    }

    /// Whether rise sqrt(r^2 - nearest^2) - run |above| rises or falls all the way: the better question of rays that
    /// are nearly level.
    bool falls_by_roots(const LathePoint& start, const LathePoint& end, bool toward_axis) const
    {
        const double c = ray_.nearest, r0 = std::abs(start.radius), r1 = std::abs(end.radius);
        const double least = glm::min(r0, r1), most = glm::max(r0, r1);
        if (!(least > c)) return false;
        const double factor_least = most / std::sqrt((most - c) * (most + c)),
                     factor_most = least / std::sqrt((least - c) * (least + c));
        SlopeRange gain =
            slope_range(ray_.rise * factor_least, ray_.rise * factor_most, start.slope_radius, end.slope_radius);
        gain.negative = toward_axis;
        SlopeRange loss = slope_range(ray_.run, ray_.run, start.slope_above, end.slope_above);
        loss.negative = (start.slope_above + end.slope_above < 0.0) != (start.above + end.above < 0.0);
        return apart(gain, loss);
    }

    /// The root between two points of which one is out.
    double refined(const Arc& arc, const LathePoint& start, const LathePoint& end) const
    {
        const double c = ray_.nearest, sign = start.above + end.above < 0.0 ? -1.0 : 1.0;
        const bool by_roots = ray_.rise < ray_.run && std::abs(start.radius) > c && std::abs(end.radius) > c;
        double across = 0.0;  // how far from the ray's nearest point
        const auto value = [&](double radius, double above) {
            if (!by_roots) return ray_.beyond(radius, above);
            across = std::sqrt(glm::max((radius - c) * (radius + c), 0.0));
            return ray_.rise * across - ray_.run * std::abs(above);
        };
        const double lo = start.w, hi = end.w;
        const double before = value(start.radius, start.above), after = value(end.radius, end.above);
        double w = before != after ? lo + (hi - lo) * (before / (before - after)) : 0.5 * (lo + hi);
        if (!(w > lo && w < hi)) w = 0.5 * (lo + hi);
        const auto at = [&](double v) {
            const glm::dvec2 p = arc.at(v), d = arc.slope(v);
            const double above = p.y - ray_.foot, now = value(p.x, above);
            return ValueAndSlope{
                now, by_roots ? ray_.rise * d.x * p.x / across - ray_.run * sign * d.y
                              : 2.0 * (ray_.rise * ray_.rise * p.x * d.x - ray_.run * ray_.run * above * d.y)};
        };
        return safeguarded_newton(at, lo, hi, !start.out(), w, {kClose, 0.0}, 80);
    }

    static constexpr double kClose = LatheLimits::kClose, kNarrow = LatheLimits::kNarrow;

    const Lathe& lathe_;
    const AxisRay ray_;
    std::uint32_t face_ = 0;
    int cells_left_ = 0;
    LatheTold<Waiting> told_;
};

void Lathe::intersect(const Ray& ray, IntersectionList& out) const
{
    Meeting meeting(*this, ray, out);
    meeting.find();
    meeting.tell(out);
}

}  // namespace csg
