#include "csg/freeform/field/isosurface.h"

#include "csg/freeform/field/isosurface_search.h"

#include <algorithm>
#include <cmath>

namespace csg {
namespace {

constexpr double kLeastStep = 1e-9;  // of the container: of shorter ones rounding leaves less than 6 digits
constexpr double kOnSphere = 1e-10;  // a crossing as near to the sphere has the sphere's normal (spec 5b, 13.4)
constexpr double kShortWay = 0.125;  // of the way: a search for what is on it is shorter by a step or more
constexpr double kOnWall = 1e-9;     // of the container: an undrawn end as near to a side of the box is on it

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
    const Interval whole = way;
    if (terms_.short_ways && out.to - out.from < kShortWay * (way.exit - way.entry)) {
        way.entry = std::max(way.entry, out.from);
        way.exit = std::min(way.exit, out.to);
    }
    IsosurfaceSearch search(terms_, ray, way, out.to);
    const double accuracy = search.accuracy();
    const Start begin = start(search, way);
    if (way.exit - begin.t < accuracy) return;
    int left = terms_.max_trace - (begin.wall ? 1 : 0);
    bool inside = begin.inside;
    if (inside && !out.enter(whole.entry, begin.wall ? way.entry_face : kUndrawnFace)) return;
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
    if (inside) out.leave(whole.exit, wall ? way.exit_face : kUndrawnFace);
}

std::optional<glm::dvec3> Isosurface::wall_gradient(const glm::dvec3& p, std::uint32_t face) const
{
    const Container& c = terms_.container;
    if (face < kField) return c.normal(p, face);
    if (c.is_sphere && std::abs(std::sqrt(glm::dot(p - c.center, p - c.center)) - c.radius) < kOnSphere)
        return p - c.center;
    if (c.is_sphere || face != kUndrawnFace) return {};
    const glm::dvec3 size = c.upper - c.lower;
    const double near = kOnWall * glm::max(glm::max(size.x, size.y), size.z);
    for (std::uint32_t k = 0; k < 6; ++k) {
        const auto axis = static_cast<int>(k / 2);
        if (std::abs(p[axis] - (k % 2 == 0 ? c.lower : c.upper)[axis]) < near) return c.normal(p, k);
    }
    return {};
}

double Isosurface::difference_step() const
{
    const glm::dvec3 size = terms_.container.bounds().upper - terms_.container.bounds().lower;
    return std::max(terms_.accuracy, kLeastStep * glm::max(glm::max(size.x, size.y), size.z));
}

glm::dvec3 Isosurface::gradient(const glm::dvec3& p, std::uint32_t face) const
{
    if (const auto wall = wall_gradient(p, face)) return *wall;
    const double step = difference_step(), here = terms_.field->value(p);
    return {terms_.field->value({p.x + step, p.y, p.z}) - here, terms_.field->value({p.x, p.y + step, p.z}) - here,
            terms_.field->value({p.x, p.y, p.z + step}) - here};
}

void Isosurface::gradients(std::span<const glm::dvec3> points, std::span<const std::uint32_t> faces,
                           glm::dvec3* out) const
{
    constexpr std::size_t kNone = ~std::size_t{0};
    const double step = difference_step();
    std::size_t waiting = kNone;
    EightPoints places;
    const auto place = [&](std::size_t first, const glm::dvec3& p) {  // the point and three beside it
        for (std::size_t i = 0; i < 4; ++i) {
            places.x.v[first + i] = i == 1 ? p.x + step : p.x;
            places.y.v[first + i] = i == 2 ? p.y + step : p.y;
            places.z.v[first + i] = i == 3 ? p.z + step : p.z;
        }
    };
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (const auto wall = wall_gradient(points[k], faces[k])) {
            out[k] = *wall;
        } else if (waiting == kNone) {
            waiting = k;
        } else {
            place(0, points[waiting]);
            place(4, points[k]);
            Eight f;
            terms_.field->values(places, f);
            out[waiting] = glm::dvec3(f.v[1], f.v[2], f.v[3]) - f.v[0];
            out[k] = glm::dvec3(f.v[5], f.v[6], f.v[7]) - f.v[4];
            waiting = kNone;
        }
    }
    if (waiting != kNone) out[waiting] = gradient(points[waiting], faces[waiting]);
}

}  // namespace csg
