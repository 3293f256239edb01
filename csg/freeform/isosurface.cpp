#include "csg/freeform/isosurface.h"

#include "csg/freeform/isosurface_search.h"

namespace csg {
namespace {

constexpr std::uint32_t kField = 7;         // face of the field's own crossings; below it the container's
constexpr double kOnBall = 1e-10;           // a crossing as near to the ball has the ball's normal (spec 5b, 13.4)

}  // namespace

void Isosurface::meet(const Ray& ray, RayRecord& out) const
{
    Interval way;
    if (!terms_.container.interval(ray, way) || way.exit - way.entry < terms_.accuracy) return;
    if (way.exit < out.from || way.entry > out.to) return;
    const double begin = std::max(way.entry, out.from);
    IsosurfaceSearch search(terms_, ray, out.to);

    // POV-Ray draws the wall where a ray comes in, and where it goes out only if it began inside (spec 5b, 13.1).
    const bool from_outside = way.entry > terms_.accuracy;
    int left = terms_.max_trace;
    bool inside = search.value(begin) < 0.0;
    if (inside) {
        const bool drawn = !terms_.open && from_outside && begin == way.entry;
        if (drawn) --left;
        if (!out.enter(way.entry, drawn ? way.entry_face : kUndrawnFace)) return;
    }
    double from = begin;
    Crossed found;
    const bool wall_drawn = !terms_.open && !from_outside;
    while (from < way.exit && !(out.first_only && left <= 0 && !wall_drawn) &&
           search.first(from, way.exit, inside ? -1.0 : 1.0, found)) {
        const double t = search.narrow(found, inside ? -1.0 : 1.0);
        const std::uint32_t face = left > 0 ? kField : kUndrawnFace;
        --left;
        if (!(inside ? out.leave(t, face) : out.enter(t, face))) return;
        inside = !inside;
        from = found.behind;
    }
    if (inside) out.leave(way.exit, wall_drawn ? way.exit_face : kUndrawnFace);
}

glm::dvec3 Isosurface::gradient(const glm::dvec3& p, std::uint32_t face) const
{
    const Container& c = terms_.container;
    if (face < kField) return c.normal(p, face);
    if (c.ball && std::abs(std::sqrt(glm::dot(p - c.center, p - c.center)) - c.radius) < kOnBall) return p - c.center;
    const double step = terms_.accuracy, here = terms_.field->value(p);
    return {terms_.field->value({p.x + step, p.y, p.z}) - here, terms_.field->value({p.x, p.y + step, p.z}) - here,
            terms_.field->value({p.x, p.y, p.z + step}) - here};
}

}  // namespace csg
