#include "csg/freeform/field/isosurface.h"

#include "csg/freeform/field/isosurface_search.h"

#include <algorithm>

namespace csg {
namespace {

constexpr double kLeastStep = 1e-9;  // of the container: of shorter ones rounding leaves less than 6 digits
constexpr double kOnSphere = 1e-10;  // a crossing as near to the sphere has the sphere's normal (spec 5b, 13.4)

}  // namespace

/// Where POV-Ray begins to look, and on which side; the search has looked from there to the end of the way (spec
/// 5b, 13.1, its steps 2 to 4).
struct Isosurface::Start {
    double t = 0.0;
    bool inside = false, wall = false;  ///< wall: it is drawn where the ray comes in
};

Isosurface::Start Isosurface::start(IsosurfaceSearch& search, const Interval& way) const
{
    const double accuracy = search.accuracy(), near = 4.0 * accuracy * terms_.max_gradient, beyond = 5.0 * accuracy;
    Start out{.t = std::max(way.entry, 0.0)};
    if (out.t > accuracy) {
        search.look(out.t, way.exit);
        out.inside = search.starts_inside();
        out.wall = out.inside && !terms_.open;
        return out;
    }
    const double here = search.value(out.t);
    if (terms_.open ? std::abs(here) < near : here < near) {
        out.t = beyond;
        out.inside = search.value(out.t) < 0.0;
    } else {
        out.inside = here < 0.0;
    }
    search.look(out.t, way.exit);
    return out;
}

void Isosurface::intersect(const Ray& ray, IntersectionList& out) const
{
    Interval way;
    if (!terms_.container.interval(ray, way) || way.exit < std::max(out.from, 0.0) || way.entry > out.to) return;
    IsosurfaceSearch search(terms_, ray, way, out.to);
    const double accuracy = search.accuracy();
    const Start begin = start(search, way);
    if (way.exit - begin.t < accuracy) return;
    int left = terms_.max_trace - (begin.wall ? 1 : 0);
    bool inside = begin.inside;
    if (inside && !out.enter(way.entry, begin.wall ? way.entry_face : kUndrawnFace)) return;
    // The wall is drawn where a ray goes out only if it began inside.
    const bool wall = !terms_.open && std::max(way.entry, 0.0) <= accuracy && search.value(way.exit) < 0.0;
    double t = 0.0, from = begin.t;
    while (way.exit - from >= accuracy && search.first(inside ? -1.0 : 1.0, t)) {
        const std::uint32_t face = left > 0 ? kField : kUndrawnFace;
        if (!(inside ? out.leave(t, face) : out.enter(t, face))) return;
        inside = !inside;
        from = t + 5.0 * accuracy;
        if (--left > 0 || !out.first_only) {
            search.look(from, way.exit);
            continue;
        }
        if (wall) out.touch(way.exit, way.exit_face);
        return;
    }
    if (inside) out.leave(way.exit, wall ? way.exit_face : kUndrawnFace);
}

glm::dvec3 Isosurface::gradient(const glm::dvec3& p, std::uint32_t face) const
{
    const Container& c = terms_.container;
    if (face < kField) return c.normal(p, face);
    if (c.is_sphere && std::abs(std::sqrt(glm::dot(p - c.center, p - c.center)) - c.radius) < kOnSphere)
        return p - c.center;
    const glm::dvec3 size = c.bounds().upper - c.bounds().lower;
    const double step = std::max(terms_.accuracy, kLeastStep * glm::max(glm::max(size.x, size.y), size.z)),
                 here = terms_.field->value(p);
    return {terms_.field->value({p.x + step, p.y, p.z}) - here, terms_.field->value({p.x, p.y + step, p.z}) - here,
            terms_.field->value({p.x, p.y, p.z + step}) - here};
}

}  // namespace csg
