#include "csg/freeform/sweep/conic_prism_course.h"

#include "csg/freeform/shared/sorted_ends.h"
#include "csg/solids/shared/outline_crossings.h"

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

void ConicPrism::intersect(const Ray& ray, IntersectionList& out) const
{
    const glm::dvec3 &p = ray.origin, &d = ray.direction;
    if (outline_->empty()) return;
    const Course<double> course(*this, {p.x, p.y, p.z}, {d.x, d.y, d.z}, out.from, out.to);
    const Interval within = course.within(course.entry, course.exit, d.y);
    if (course.through_apex) {
        if (d.y == 0.0 || !outline_->contains({d.x / d.y, d.z / d.y})) return;
        if (out.enter(course.shift + within.entry, end_face(within.entry_face)))
            out.leave(course.shift + within.exit, end_face(within.exit_face));
        return;
    }
    if (!course.asked) return;
    auto line = course.line<OutlineLine>();
    SortedEnds walls;
    bool inside = false;  // before all walls that are kept
    const bool odd = outline_crossings(*outline_, line, [&](double w, std::uint32_t piece) {
        const glm::dvec2 c = outline_->pieces()[piece].at(w);
        const double t = course.wall(c.x, c.y);
        if (course.before(t)) inside = !inside;
        if (!course.holds(t)) return;
        walls.add(t, kFirstWall + piece);
        if (course.one_sided && out.first_only && course.shift + t >= out.from)
            line.hi = std::min(line.hi, course.farthest_along(t, 1.0));
    });
    tell(course.shift, within, walls, inside != odd, out);
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
