#include "csg/solids/solid.h"

namespace csg {

namespace {

/// Box of the circle of `radius` about local (0, 0, z), across local x and y.
Aabb ring_box(const Transform& frame, double z, double radius)
{
    const glm::dmat3& l = frame.linear;
    return ellipsoid_box({l[0] * radius, l[1] * radius, glm::dvec3(0.0)}, frame.point({0.0, 0.0, z}));
}

}  // namespace

Aabb Sphere::bounds() const
{
    if (!(radius > 0.0)) return {};
    return padded({center - radius, center + radius});
}

Aabb Ellipsoid::bounds() const { return padded(ellipsoid_box(frame.linear, frame.offset)); }

Aabb Plane::bounds() const
{
    Aabb box = Aabb::everything();
    for (int i = 0; i < 3; ++i) {
        if (normal_out[(i + 1) % 3] != 0.0 || normal_out[(i + 2) % 3] != 0.0) continue;
        if (normal_out[i] > 0.0) box.upper[i] = offset / normal_out[i];
        else box.lower[i] = offset / normal_out[i];
    }
    return padded(box);
}

Aabb Cylinder::bounds() const
{
    Aabb box = ring_box(frame, 0.0, 1.0);
    box.include(ring_box(frame, 1.0, 1.0));
    return padded(box);
}

Aabb Cone::bounds() const
{
    Aabb box = ring_box(frame, low, std::abs(low));
    box.include(ring_box(frame, 1.0, 1.0));
    return padded(box);
}

Aabb Torus::bounds() const
{
    if (!(major > 0.0 && minor > 0.0)) return {};
    // A sphere swept along the circle: half extents add.
    const glm::dmat3& l = frame.linear;
    const Aabb circle = ellipsoid_box({l[0] * major, glm::dvec3(0.0), l[2] * major}, frame.offset);
    const Aabb sphere = ellipsoid_box(l * minor, glm::dvec3(0.0));
    return padded({circle.lower + sphere.lower, circle.upper + sphere.upper});
}

Aabb Quadric::bounds() const
{
    // p'Qp + linear.p + constant <= 0 with Q positive definite is an ellipsoid: centre -Q^-1 linear / 2, half extent
    // along e of sqrt(level e'Q^-1 e).
    const glm::dmat3 q({square.x, mixed.x / 2, mixed.y / 2}, {mixed.x / 2, square.y, mixed.z / 2},
                       {mixed.y / 2, mixed.z / 2, square.z});
    const double minor2 = square.x * square.y - mixed.x * mixed.x / 4, determinant = glm::determinant(q);
    const double size = std::max(std::abs(square.x), std::max(std::abs(square.y), std::abs(square.z)));
    constexpr double kDefinite = 1e-9;  // relative; flatter than that counts as unbounded
    if (!(square.x > kDefinite * size && minor2 > kDefinite * size * size &&
          determinant > kDefinite * size * size * size))
        return Aabb::everything();
    const glm::dmat3 inverse = glm::inverse(q);
    const glm::dvec3 center = inverse * linear * -0.5;
    const double level = -(constant + 0.5 * glm::dot(linear, center));
    if (!(level >= 0.0)) return {};
    glm::dvec3 half(0.0);
    for (int i = 0; i < 3; ++i) half[i] = std::sqrt(level * inverse[i][i]) * (1.0 + 1e-12);
    if (frame.identity()) return padded({center - half, center + half});
    return padded(transformed_box(frame, {center - half, center + half}));
}

Aabb Disc::drawn_bounds() const { return padded(ring_box(frame, 0.0, radius)); }

Aabb Triangle::bounds() const
{
    Aabb box;
    box.include(corner);
    box.include(corner + edge1);
    box.include(corner + edge2);
    return padded(box);
}

}  // namespace csg
