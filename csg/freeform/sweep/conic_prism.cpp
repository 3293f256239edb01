#include "csg/freeform/sweep/conic_prism_walls.h"

#include "csg/freeform/shared/sorted_ends.h"
#include "csg/solids/shared/outline_crossings.h"
#include "csg/solids/shared/common.h"

namespace csg {
namespace {

constexpr double kApex = 1e-10;  // a height that POV-Ray takes for the apex's (spec 5b, 6.5)

}  // namespace

ConicPrism::ConicPrism(std::shared_ptr<const OutlineShape> outline, double low, double high, bool open,
                       const glm::dvec2 (&reach)[2])
    : outline_(std::move(outline)), low_(low), high_(high), open_(open), extent_(box(reach[0], reach[1]))
{}

Aabb ConicPrism::box(const glm::dvec2& lower, const glm::dvec2& upper) const
{
    Aabb all;
    for (const double y : {low_, high_})
        for (const glm::dvec2& p : {lower, upper}) all.include({p.x * y, y, p.y * y});
    return all;
}

/// Seen from the apex the ray is a straight line across the outline, and the plane of both cuts it where the ray passes
/// a wall. Where the ray is level with the apex it is infinitely far out on that line: outside.
void ConicPrism::intersect(const Ray& ray, IntersectionList& out) const
{
    const glm::dvec3& d = ray.direction;
    const double square = glm::dot(d, d);
    if (outline_->empty() || !(square > 0.0 && square < kInfinity)) return;
    const double shift = -glm::dot(ray.origin, d) / square;
    const glm::dvec3 o = ray.at(shift);  // near the apex
    Interval within;
    if (!slab(o.y, d.y, low_, high_, within)) return;
    const glm::dvec3 normal = glm::cross(o, d);
    const glm::dvec2 side(normal.x, normal.z);
    if (side == glm::dvec2(0.0)) {
        if (d.y == 0.0 || !outline_->contains({d.x / d.y, d.z / d.y})) return;
        if (out.enter(shift + within.entry, end_face(within.entry_face)))
            out.leave(shift + within.exit, end_face(within.exit_face));
        return;
    }
    const double apex = -o.y / d.y;  // where the ray is level with it; never, if the ray is level
    // The stretch of that straight line that is asked for: one piece of it, unless the prism reaches to both sides of
    // the apex.
    const bool rises = d.y != 0.0, one_sided = low_ > 0.0 || high_ < 0.0 || (rises && (low_ == 0.0 || high_ == 0.0));
    const auto widened = [](double end, double sign) { return end + sign * kWider * std::abs(end); };
    const double nearest = glm::max(within.entry, widened(out.from, -1.0) - shift),
                 farthest = glm::min(within.exit, widened(out.to, 1.0) - shift);
    if (nearest > farthest) return;
    // Before the stretch lies what the line runs through on its way here from infinity, where the ray is level with the
    // apex.
    const bool apex_behind = rises && apex >= within.exit;
    const auto is_before = [&](double t) {
        if (!one_sided) return rises && t < apex;  // its far past
        return t < nearest ? !rises || apex_behind || t > apex : apex_behind && t > apex;
    };
    OutlineLine line{side, -normal.y, {-side.y, side.x}};
    if (one_sided) {
        line.lo = -farthest_along(line, o, d, nearest, -1.0);
        line.hi = farthest_along(line, o, d, farthest, 1.0);
    }
    SortedEnds walls;
    bool inside = false;  // before all walls that are kept
    const bool odd = outline_crossings(*outline_, line, [&](double w, std::uint32_t piece) {
        const glm::dvec2 c = outline_->pieces()[piece].at(w);
        const glm::dvec2 gap(c.x * o.y - o.x, c.y * o.y - o.z), closing(d.x - c.x * d.y, d.z - c.y * d.y);
        const double t = glm::dot(gap, closing) / glm::dot(closing, closing);
        if (is_before(t)) inside = !inside;
        if (one_sided && !(t >= nearest && t <= farthest)) return;
        walls.add(t, kFirstWall + piece);
        if (one_sided && out.first_only && shift + t >= out.from)
            line.hi = std::min(line.hi, farthest_along(line, o, d, t, 1.0));
    });
    inside = inside != odd;
    tell({shift, within}, walls, inside, out);
}

/// How far along the line the ray is at t, a little more in the direction of `sign`: times `sign`. Infinite where it is
/// level with the apex.
double ConicPrism::farthest_along(const OutlineLine& line, const glm::dvec3& o, const glm::dvec3& d, double t,
                                  double sign) const
{
    if (!(std::abs(t) < kInfinity)) return kInfinity;
    const double y = glm::clamp(o.y + t * d.y, low_, high_);
    if (y == 0.0) return kInfinity;
    // More than the roundings of a wall's place.
    const glm::dvec2 p(o.x + t * d.x, o.z + t * d.z),
        size(std::abs(o.x) + std::abs(t * d.x), std::abs(o.z) + std::abs(t * d.z));
    const double along = glm::dot(line.along, p) / y;
    const double room = glm::dot(glm::abs(line.along), size) + std::abs(along) * (std::abs(o.y) + std::abs(t * d.y));
    return sign * along + 1e-12 * room / std::abs(y);
}

bool ConicPrism::contains(const glm::dvec3& p) const
{
    return p.y >= low_ && p.y <= high_ && p.y != 0.0 && !outline_->empty() &&
           outline_->contains({p.x / p.y, p.z / p.y});
}

glm::dvec3 ConicPrism::gradient(const glm::dvec3& p, std::uint32_t face) const
{
    if (face < kFirstWall || !(std::abs(p.y) > kApex)) return {0.0, 1.0, 0.0};
    const std::uint32_t piece = face - kFirstWall;
    const glm::dvec2 q(p.x / p.y, p.z / p.y), slope = outline_->pieces()[piece].slope(outline_->parameter(piece, q));
    return {slope.y, q.y * slope.x - q.x * slope.y, -slope.x};
}

}  // namespace csg
