#include "csg/tree/held.h"

#include "csg/tree/front.h"
#include "numbers/functions/functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace csg {
namespace {

constexpr double kMeantToHold = 0.01;  ///< of the size, about the middle of the box

bool convex(const Program& program, const SolidStore& store)
{
    if (program.nodes.size() != 1 || program.nodes[0].inverted) return false;
    return with_solid(store, program.nodes[0].solid, [](const auto& solid) {
        using T = std::decay_t<decltype(solid)>;
        if constexpr (std::is_same_v<T, Cone>) return solid.convex();
        else
            return std::is_same_v<T, Sphere> || std::is_same_v<T, Ellipsoid> || std::is_same_v<T, Box> ||
                   std::is_same_v<T, OrientedBox> || std::is_same_v<T, Cylinder> || std::is_same_v<T, Plane>;
    });
}

/// The n-th number of a series that fills [0, 1) evenly (van der Corput).
double spread(std::uint32_t n, std::uint32_t base)
{
    double sum = 0.0, digit = 1.0 / base;
    for (; n > 0; n /= base, digit /= base) sum += digit * (n % base);
    return sum;
}

}  // namespace

bool held_by(const Aabb& box, const Program& bound, const SolidStore& store)
{
    if (!box.finite()) return false;
    const glm::dvec3 middle = 0.5 * (box.lower + box.upper), half = (1.0 - kMeantToHold) * (box.upper - middle);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 side(corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
        if (!contains(bound, store, middle + side * half)) return false;
    }
    return convex(bound, store);
}

bool held_by(const Program& drawn, const Program& bound, const SolidStore& store, std::uint32_t rays)
{
    const Aabb& box = drawn.bounds;
    if (held_by(box, bound, store)) return true;
    if (!box.finite()) return false;
    const glm::dvec3 middle = 0.5 * (box.lower + box.upper), size = box.upper - box.lower;
    const double far = glm::length(size);
    Scratch scratch;
    for (std::uint32_t n = 1; n <= rays; ++n) {
        const double z = 2.0 * spread(n, 7) - 1.0, around = 2.0 * std::numbers::pi * spread(n, 11),
                     r = std::sqrt(1.0 - z * z);
        const glm::dvec3 direction(r * numbers::cos(around), r * numbers::sin(around), z);
        const glm::dvec3 through = box.lower + size * glm::dvec3(spread(n, 2), spread(n, 3), spread(n, 5));
        const Ray ray{through - far * direction, direction};
        const auto [first, last] = visible_crossings(drawn, store, ray, 0.0, 2.0 * far, scratch);
        for (const Crossing* c = first; c != last; ++c)
            if (!contains(bound, store, middle + (1.0 - kMeantToHold) * (ray.at(c->t) - middle))) return false;
    }
    return true;
}

}  // namespace csg
