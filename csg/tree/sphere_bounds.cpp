#include "csg/tree/sphere_bounds.h"

#include <cmath>

namespace csg {
namespace {

/// Crossings are drawn where they are computed; this covers their rounding, relative to the size of the spheres.
constexpr double kSlack = 1e-9;

/// How far the lens of two spheres reaches along the unit vector `u`, for spheres that cut each other.
double reach(const Sphere& a, const Sphere& b, const glm::dvec3& u)
{
    const auto holds = [](const Sphere& sphere, const glm::dvec3& p) {
        return glm::distance(sphere.center, p) <= sphere.radius;
    };
    const glm::dvec3 of_a = a.center + a.radius * u, of_b = b.center + b.radius * u;
    if (holds(b, of_a)) return glm::dot(of_a, u);
    if (holds(a, of_b)) return glm::dot(of_b, u);
    // Otherwise the farthest point lies on the circle that the spheres share.
    const glm::dvec3 between = b.center - a.center;
    const double distance = glm::length(between);
    const double along = (distance * distance + a.radius * a.radius - b.radius * b.radius) / (2.0 * distance);
    const double radius = std::sqrt(std::max(0.0, a.radius * a.radius - along * along));
    const double cosine = glm::dot(u, between) / distance;
    return glm::dot(a.center + along / distance * between, u) +
           radius * std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
}

Aabb lens(const Sphere& a, const Sphere& b)
{
    const double distance = glm::distance(a.center, b.center);
    const glm::dvec3 size = glm::max(glm::abs(a.center), glm::abs(b.center)) + a.radius + b.radius;
    if (!(distance < a.radius + b.radius) || !(distance > std::abs(a.radius - b.radius))) return Aabb::everything();
    Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 u(0);
        u[axis] = 1.0;
        box.upper[axis] = reach(a, b, u) + kSlack * size[axis];
        box.lower[axis] = -reach(a, b, -u) - kSlack * size[axis];
    }
    return box;
}

}  // namespace

Aabb lens_bounds(const Program& program, const SolidStore& store)
{
    Aabb box = program.bounds;
    if (program.nodes.empty() || program.nodes[0].op != Op::Intersection) return box;
    constexpr std::size_t kMostSpheres = 16;  // pairs are looked at
    std::array<const Sphere*, kMostSpheres> spheres{};
    std::size_t count = 0;
    for (std::size_t k = 1; k < program.nodes.size() && count < kMostSpheres; k = program.nodes[k].end) {
        const Node& node = program.nodes[k];
        if (node.op == Op::Leaf && !node.inverted && kind_of(node.solid) == SolidKind::Sphere)
            spheres[count++] = &store.all<Sphere>()[index_of(node.solid)];
    }
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < i; ++k) box = box.intersected(lens(*spheres[i], *spheres[k]));
    return box;
}

}  // namespace csg
