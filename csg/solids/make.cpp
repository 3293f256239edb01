#include "csg/solids/solid.h"

#include <utility>

namespace csg {

Cylinder Cylinder::make(const glm::dvec3& first, const glm::dvec3& second, double radius, bool open, const Transform& t,
                        Roundings by)
{
    const glm::dvec3 axis = first - second;
    return {t * axis_frame(second, unit(axis, by), radius, glm::length(axis), by), open};
}

bool Cone::make(const glm::dvec3& first, double first_radius, const glm::dvec3& second, double second_radius, bool open,
                const Transform& t, Cone& out, double& cylinder_radius)
{
    constexpr double kSameRadius = 1e-10;  // absolute, POV-Ray's (spec 5a, 5.4)
    if (std::abs(first_radius - second_radius) < kSameRadius) {
        cylinder_radius = first_radius;
        return false;
    }
    glm::dvec3 large = first, small = second;
    double big = first_radius, little = second_radius;
    if (big < little) std::swap(large, small), std::swap(big, little);
    if ((big - little) * (big - little) < kSameRadius * std::abs(big)) {
        cylinder_radius = big;
        return false;
    }
    const double length = glm::length(large - small);
    const glm::dvec3 axis = (large - small) / length;
    const double below = little * length / (big - little);  // apex to the small end
    out.low = little / big;
    out.open = open;
    out.frame = t * axis_frame(small - axis * below, axis, big, below + length);
    return true;
}

Plane Plane::transformed(const Transform& t) const
{
    const glm::dvec3 n = t.normal(normal_out);
    const double length = glm::length(n);
    if (!(length > 0.0)) return *this;
    // A translation or rotation keeps the offset's accuracy: no point of the plane is rounded.
    return {n / length, (offset - glm::dot(normal_out, t.inverse_offset)) / length};
}

Disc Disc::make(const glm::dvec3& center, const glm::dvec3& normal, double radius, double hole, const Transform& t)
{
    const double length = glm::length(normal);
    if (!(length > 0.0)) return {0.0, 1.0, t};  // never drawn
    return {std::abs(radius), std::abs(hole), t * axis_frame(center, normal / length, 1.0, 1.0)};
}

Triangle Triangle::make(const std::array<glm::dvec3, 3>& vertices)
{
    Triangle made;
    made.corner = vertices[0];
    made.edge1 = vertices[1] - vertices[0];
    made.edge2 = vertices[2] - vertices[0];
    return made;
}

Triangle Triangle::make(const std::array<glm::dvec3, 3>& vertices, const std::array<glm::dvec3, 3>& normals)
{
    Triangle made = make(vertices);
    made.normals = normals;
    made.smooth = true;
    return made;
}

}  // namespace csg
