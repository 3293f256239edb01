#include "render/plan/geometry/solids.h"

#include "csg/freeform/freeform.h"

#include <cmath>
#include <stdexcept>

namespace plan {
namespace {

/// Columns of a rotation times one factor, to within rounding: relative to the factor squared, a few hundred units in
/// the last place, for matrices multiplied up from many rotations.
constexpr double kSimilarity = 1e-13;

bool similarity(const glm::dmat3& m, double& factor)
{
    const double a = glm::dot(m[0], m[0]), b = glm::dot(m[1], m[1]), c = glm::dot(m[2], m[2]);
    const double slack = kSimilarity * a;
    factor = std::sqrt(a);
    return a > 0.0 && std::abs(a - b) <= slack && std::abs(a - c) <= slack && std::abs(glm::dot(m[0], m[1])) <= slack &&
           std::abs(glm::dot(m[0], m[2])) <= slack && std::abs(glm::dot(m[1], m[2])) <= slack;
}

bool rigid(const glm::dmat3& m)
{
    double factor = 1.0;
    return similarity(m, factor) && std::abs(factor - 1.0) <= kSimilarity;
}

bool diagonal(const glm::dmat3& m)
{
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (row != column && m[column][row] != 0.0) return false;
    return true;
}

using Corners = std::array<glm::dvec3, 3>;

/// POV-Ray draws a smooth_triangle only if its three normals point to one side of its face, none along it (spec
/// 5b, 2.2); the faces of meshes know no such rule.
bool normals_on_one_side(const Corners& corners, const std::array<glm::dvec3, 3>& normals)
{
    const glm::dvec3 face = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double a = glm::dot(face, normals[0]), b = glm::dot(face, normals[1]), c = glm::dot(face, normals[2]);
    return (a > 0.0 && b > 0.0 && c > 0.0) || (a < 0.0 && b < 0.0 && c < 0.0);
}

/// In the order whose cross product of edges is POV-Ray's normal: against the order as written, and once the triangle
/// was moved so that its largest component has a sign of its own (spec 5b, 2.1).
Corners oriented(const Corners& c, bool moved)
{
    const glm::dvec3 n = glm::cross(c[1] - c[0], c[2] - c[0]), size = glm::abs(n);
    const double leading = size.x > size.y && size.x > size.z ? -n.x : size.z >= size.y ? -n.z : n.y;
    return moved && leading >= 0.0 ? c : Corners{c[0], c[2], c[1]};
}

struct ToWorld {
    const csg::Transform& t;
    bool on_surface, sides_by_order;
    csg::Roundings by;

    Corners moved(const Corners& c) const { return {t.point(c[0]), t.point(c[1]), t.point(c[2])}; }
    csg::Solid operator()(const scene::Sphere& s) const
    {
        double factor = 1.0;
        const bool turned = !diagonal(t.linear) || t.linear[0][0] <= 0.0 || t.linear[1][1] <= 0.0 ||
                            t.linear[2][2] <= 0.0;
        if (similarity(t.linear, factor) && !(turned && on_surface))
            return csg::Sphere{t.point(s.center), std::abs(s.radius) * factor};
        return csg::Ellipsoid{t * csg::Transform::translate(s.center) *
                              csg::Transform::scale(glm::dvec3(std::abs(s.radius)))};
    }
    csg::Solid operator()(const scene::Box& s) const
    {
        if (!diagonal(t.linear)) return csg::OrientedBox{s.lower, s.upper, t};
        const glm::dvec3 a = t.point(s.lower), b = t.point(s.upper);
        return csg::Box{glm::min(a, b), glm::max(a, b)};
    }
    csg::Solid operator()(const scene::Plane& s) const { return csg::Plane{s.normal, s.offset}.transformed(t); }
    csg::Solid operator()(const scene::Cylinder& s) const
    {
        return csg::Cylinder::make(s.base, s.cap, std::abs(s.radius), s.open, t, by);
    }
    csg::Solid operator()(const scene::Cone& s) const
    {
        csg::Cone cone;
        double radius = 0.0;
        if (csg::Cone::make(s.base, s.base_radius, s.cap, s.cap_radius, s.open, t, cone, radius)) return cone;
        return csg::Cylinder::make(s.base, s.cap, radius, s.open, t, by);
    }
    csg::Solid operator()(const scene::Torus& s) const
    {
        if (has_spindle(s)) return csg::Freeform{csg::make_freeform<csg::SpindleTorus>(spindle_torus(s)), t};
        return csg::Torus{std::abs(s.major), std::abs(s.minor), t};
    }
    csg::Solid operator()(const scene::Shared<scene::Quadric>& s) const
    {
        return csg::Quadric{s->square, s->mixed, s->linear, s->constant, t};
    }
    csg::Solid operator()(const scene::Disc& s) const
    {
        return csg::Disc::make(s.center, s.normal, s.radius, s.hole, t);
    }
    csg::Solid operator()(const scene::Triangle& s) const
    {
        return csg::Triangle::make(oriented(moved(s.vertex), !sides_by_order && !t.identity()));
    }
    csg::Solid operator()(const scene::Shared<scene::SmoothTriangle>& s) const
    {
        const Corners corners = moved(s->vertex), &n = s->normal;
        std::array<glm::dvec3, 3> normals = {t.normal(n[0]), t.normal(n[1]), t.normal(n[2])};
        // `scale` makes each as long as the others again; a `matrix` of that kind would not, which is rare.
        if (double factor = 1.0; !similarity(t.linear, factor))
            for (glm::dvec3& normal : normals)
                if (normal != glm::dvec3(0.0)) normal = glm::normalize(normal);
        // Scales that differ by axis turn normals against the face. POV-Ray looks after each statement; what lies
        // between the first place and the last is not known here.
        if (!normals_on_one_side(s->vertex, n) || !normals_on_one_side(corners, normals))
            return csg::Triangle::make({corners[0], corners[0], corners[0]});  // no area: never met
        return csg::Triangle::make(corners, normals);
    }
    csg::Solid operator()(const scene::Extrusion& s) const
    {
        csg::Extrusion made;
        made.shape = s.outline;
        made.low = s.low;
        made.high = s.high;
        made.open = s.open;
        made.ends_up = s.ends_up;
        made.frame = t;
        return made;
    }
    csg::Solid operator()(const scene::Polynomial& s) const { return csg::Polynomial{s.shape, t}; }
    csg::Solid operator()(const scene::Freeform& s) const
    {
        const auto* patch = std::get_if<csg::BicubicPatch>(&s.shape->kind);
        // A patch is flat enough or not where it stands (spec 5b, 5).
        if (patch == nullptr || !(patch->input().flatness > 0.0) || rigid(t.linear))
            return csg::Freeform{csg::drawn_shape(s.shape), t};
        csg::BicubicPatch::Input moved = patch->input();
        for (auto& row : moved.points)
            for (glm::dvec3& point : row) point = t.point(point);
        return csg::Freeform{csg::make_freeform<csg::BicubicPatch>(moved), {}};
    }
    csg::Solid operator()(const scene::Mesh&) const
    {
        throw std::logic_error("a mesh is shared, and made by GeometryCompiler");
    }
    csg::Solid operator()(const scene::Csg&) const { throw std::logic_error("a CSG object is many solids"); }
    csg::Solid operator()(const scene::Shared<scene::Light>&) const { throw std::logic_error("a light is no solid"); }
};

}  // namespace

bool has_spindle(const scene::Torus& torus)
{
    using Spindle = scene::Torus::Spindle;
    return torus.spindle == Spindle::Intersection ||
           (torus.spindle != Spindle::Usual && torus.major > 0.0 && torus.minor > torus.major);
}

csg::SpindleTorus spindle_torus(const scene::Torus& torus)
{
    using Spindle = csg::SpindleTorus::Spindle;
    static constexpr Spindle kSpindles[] = {Spindle::Union, Spindle::Union, Spindle::Merge, Spindle::Difference,
                                            Spindle::Intersection};
    return {torus.major, torus.minor, kSpindles[static_cast<std::size_t>(torus.spindle)]};
}

csg::Solid world_solid(const scene::Shape& shape, const csg::Transform& to_world, bool on_surface, bool sides_by_order,
                       csg::Roundings by)
{
    return std::visit(ToWorld{to_world, on_surface, sides_by_order, by}, shape);
}

}  // namespace plan
