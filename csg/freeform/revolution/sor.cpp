#include "csg/freeform/revolution/sor.h"

#include "csg/freeform/revolution/axis_ray.h"
#include "numbers/safeguarded_newton.h"
#include "csg/solids/shared/outline_shape.h"

#include <algorithm>

namespace csg {
namespace {

constexpr double kLeastEnd = 1e-4;  // squared radius of an end that is drawn (spec 5b, 8.2)

}  // namespace

Sor::Sor(const std::vector<glm::dvec2>& points, bool open)
{
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!(std::abs(points[i].x) < 1e150 && std::abs(points[i].y) < 1e150)) return;
    for (std::size_t k = 0; k + 3 < points.size(); ++k) {
        const glm::dvec2 &before = points[k], &low = points[k + 1], &high = points[k + 2], &behind = points[k + 3];
        const double height = high.y - low.y;
        if (!(height > 0.0)) continue;
        const double at_low = low.x * low.x, at_high = high.x * high.x;
        const double slope_low = 2.0 * low.x * (high.x - before.x) / (high.y - before.y);
        const double slope_high = 2.0 * high.x * (behind.x - low.x) / (behind.y - low.y);
        if (!(std::abs(slope_low) < kInfinity && std::abs(slope_high) < kInfinity)) continue;
        const double mean = (at_high - at_low) / height;
        Segment s{low.y,
                  high.y,
                  (slope_low + slope_high - 2.0 * mean) / (height * height),
                  (3.0 * mean - 2.0 * slope_low - slope_high) / height,
                  slope_low,
                  at_low,
                  std::max(at_low, at_high)};
        double turns[2];
        const int n = inner_roots(3.0 * s.a * height * height, 2.0 * s.b * height, s.c, turns);
        for (int i = 0; i < n; ++i) s.most = std::max(s.most, s.square(turns[i] * height));
        most_ = std::max(most_, s.most);
        segments_.push_back(s);
    }
    if (segments_.empty()) return;
    base_ = segments_.front().d;
    cap_ = points[points.size() - 2].x * points[points.size() - 2].x;
    base_drawn_ = !open && base_ > kLeastEnd;
    cap_drawn_ = !open && cap_ > kLeastEnd;
}

/// One ray: how far the curve at a height lies beyond what the ray sweeps about the axis tells whether the ray is
/// inside there.
class Sor::Meeting {
public:
    Meeting(const Sor& sor, const Ray& ray, IntersectionList& out) : sor_(sor), ray_(ray), out_(out) {}

    void find()
    {
        if (!ray_.valid() || sor_.segments_.empty()) return;
        if (ray_.level()) return level();
        const Segment &first = sor_.segments_.front(), &last = sor_.segments_.back();
        double room = (std::sqrt(sor_.most_) - ray_.nearest) * (std::sqrt(sor_.most_) + ray_.nearest);
        if (!(room > 0.0)) return;
        // Farther up and down the ray is farther from the axis than any of it.
        const double reach = ray_.run > 0.0 ? std::sqrt(room) * ray_.rise / ray_.run * (1.0 + 1e-9) : kInfinity;
        const double low = ray_.foot - reach, high = ray_.foot + reach;
        if (low > last.high || high < first.low) return;
        const int count = static_cast<int>(sor_.segments_.size());
        const double at_base = ray_.beyond_square(sor_.base_, first.low - ray_.foot),
                     at_cap = ray_.beyond_square(sor_.cap_, last.high - ray_.foot);
        if (ray_.rising()) {
            if (at_base > 0.0 && !cross(first.low, sor_.base_drawn_ ? kBase : kUndrawnFace)) return;
            for (int i = 0; i < count && sor_.segments_[static_cast<std::size_t>(i)].low <= high; ++i)
                if (!segment(static_cast<std::uint32_t>(i), low, high)) return;
            if (at_cap > 0.0) cross(last.high, sor_.cap_drawn_ ? kCap : kUndrawnFace);
        } else {
            if (at_cap > 0.0 && !cross(last.high, sor_.cap_drawn_ ? kCap : kUndrawnFace)) return;
            for (int i = count - 1; i >= 0 && sor_.segments_[static_cast<std::size_t>(i)].high >= low; --i)
                if (!segment(static_cast<std::uint32_t>(i), low, high)) return;
            if (at_base > 0.0) cross(first.low, sor_.base_drawn_ ? kBase : kUndrawnFace);
        }
    }

private:
    /// False: no more is wanted.
    bool toggle(double t, std::uint32_t face)
    {
        last_ = std::max(t, last_);
        inside_ = !inside_;
        return inside_ ? out_.enter(last_, face) : out_.leave(last_, face);
    }
    bool cross(double y, std::uint32_t face) { return toggle(ray_.at_height(y), face); }

    void level()
    {
        const double y = ray_.foot;
        if (!(y >= sor_.segments_.front().low && y <= sor_.segments_.back().high)) return;
        const Segment& s = sor_.segment_at(y);
        const double room = s.square(y - s.low) - ray_.nearest * ray_.nearest;
        if (!(room > 0.0)) return;
        const auto face = kFirstSide + static_cast<std::uint32_t>(&s - sor_.segments_.data());
        const double a = ray_.at_square(room, y, true), b = ray_.at_square(room, y, false);
        if (toggle(std::min(a, b), face)) toggle(std::max(a, b), face);
    }

    /// The sides of one segment, in the ray's order.
    bool segment(std::uint32_t index, double low, double high)
    {
        const Segment& s = sor_.segments_[index];
        const double foot = ray_.foot;
        // Squared radii that neighbours share, so that both agree on which side of the ray's the joint lies.
        const double top = index + 1 < sor_.segments_.size() ? sor_.segments_[index + 1].d : sor_.cap_;
        double start = s.low, end = s.high;
        double before = ray_.beyond_square(s.d, s.low - foot), after = ray_.beyond_square(top, s.high - foot);
        if (s.high < low || s.low > high) return true;
        if (start < low) start = low, before = -1.0;
        if (end > high) end = high, after = -1.0;
        if (!(start < end)) return true;
        // Around the height nearest to the foot, where a nearly level ray has all of its roots.
        const double middle = glm::clamp(foot, s.low, s.high), h = middle - s.low, off = middle - foot;
        const double rise2 = ray_.rise * ray_.rise, run2 = ray_.run * ray_.run;
        const double c3 = rise2 * s.a, c2 = rise2 * (3.0 * s.a * h + s.b) - run2,
                     c1 = rise2 * s.slope(h) - 2.0 * run2 * off;
        const double c0 = ray_.beyond_square(s.square(h), off);
        const auto value = [&](double v) { return ((c3 * v + c2) * v + c1) * v + c0; };
        const auto slope = [&](double v) { return (3.0 * c3 * v + 2.0 * c2) * v + c1; };
        double ends[4] = {start - middle, 0.0, 0.0, 0.0}, values[4] = {before, 0.0, 0.0, 0.0};
        int pieces = 0;
        const auto cut = [&](double v) {
            if (!(v > ends[pieces] && v < end - middle)) return;
            ends[++pieces] = v;
            values[pieces] = value(v);
        };
        const double half = c2, discriminant = half * half - 3.0 * c3 * c1;
        if (discriminant > 0.0) {
            const double q = -(half + std::copysign(std::sqrt(discriminant), half)), one = q / (3.0 * c3),
                         other = c1 / q;
            cut(std::min(one, other));
            cut(std::max(one, other));
        }
        ends[++pieces] = end - middle;
        values[pieces] = after;
        for (int k = 0; k < pieces; ++k) {
            const int i = ray_.rising() ? k : pieces - 1 - k;
            if ((values[i] > 0.0) == (values[i + 1] > 0.0)) continue;
            const double v = root(value, slope, ends[i], ends[i + 1], values[i] > 0.0);
            const double room = s.square(h + v) - ray_.nearest * ray_.nearest;
            if (!toggle(ray_.at_square(room, middle + v, off + v < 0.0), kFirstSide + index)) return false;
        }
        return true;
    }

    template <class Value, class Slope>
    static double root(const Value& value, const Slope& slope, double lo, double hi, bool out_at_lo)
    {
        const auto at = [&](double v) { return ValueAndSlope{value(v), slope(v)}; };
        return safeguarded_newton(at, lo, hi, !out_at_lo, 0.5 * (lo + hi), {0.0, kClose}, kMostSteps);
    }

    const Sor& sor_;
    const AxisRay ray_;
    IntersectionList& out_;
    bool inside_ = false;
    double last_ = -kInfinity;
};

void Sor::intersect(const Ray& ray, IntersectionList& out) const { Meeting(*this, ray, out).find(); }

const Sor::Segment& Sor::segment_at(double y) const
{
    auto found = std::upper_bound(segments_.begin(), segments_.end(), y,
                                  [](double height, const Segment& s) { return height < s.high; });
    return found == segments_.end() ? segments_.back() : *found;
}

bool Sor::contains(const glm::dvec3& p) const
{
    if (segments_.empty() || !(p.y >= segments_.front().low && p.y <= segments_.back().high)) return false;
    const Segment& s = segment_at(p.y);
    return p.x * p.x + p.z * p.z <= s.square(p.y - s.low);
}

glm::dvec3 Sor::gradient(const glm::dvec3& p, std::uint32_t face) const
{
    if (face == kBase) return {0.0, -1.0, 0.0};
    if (face == kCap) return {0.0, 1.0, 0.0};
    const Segment& s = segments_[face - kFirstSide];
    return {p.x, -0.5 * s.slope(p.y - s.low), p.z};
}

glm::dvec2 Sor::uv(const glm::dvec3& p, std::uint32_t face) const
{
    const double turn = turn_about_y(p, std::sqrt(most_)), rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (face == kBase) return {turn, rho / std::sqrt(base_) - 1.0};
    if (face == kCap) return {turn, 2.0 - rho / std::sqrt(cap_)};
    const Segment& s = segments_[face - kFirstSide];
    return {turn, (face - kFirstSide + (p.y - s.low) / (s.high - s.low)) / static_cast<double>(segments_.size())};
}

Aabb Sor::bounds() const
{
    if (segments_.empty()) return {};
    const double widest = std::sqrt(most_);
    return {{-widest, segments_.front().low, -widest}, {widest, segments_.back().high, widest}};
}

}  // namespace csg
