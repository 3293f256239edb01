#include "csg/freeform/revolution/sor.h"

#include "csg/freeform/revolution/axis_ray.h"
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
