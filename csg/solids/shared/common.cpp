#include "csg/solids/shared/common.h"

#include "csg/solids/shared/tube.h"
#include "numbers/functions/functions.h"

#include <numbers>

namespace csg {

glm::dvec2 sphere_uv(const glm::dvec3& n)
{
    constexpr double kTurn = 2.0 * std::numbers::pi;
    constexpr double kPole = 1e-10;  // of the squared distance from the axis: POV-Ray's (spec 5a, 6)
    const double v = 0.5 + numbers::asin(glm::clamp(n.y, -1.0, 1.0)) / std::numbers::pi;
    if (n.x * n.x + n.z * n.z <= kPole) return {0.0, v};
    const double u = numbers::atan2(n.z, n.x) / kTurn;
    return {u < 0.0 ? u + 1.0 : u, v};
}

Aabb padded(const Aabb& box)
{
    if (box.empty()) return box;
    const double largest = [&] {
        double m = 0.0;
        for (int i = 0; i < 3; ++i)
            for (const double v : {box.lower[i], box.upper[i]})
                if (std::isfinite(v)) m = std::max(m, std::abs(v));
        return m;
    }();
    const glm::dvec3 margin(8.0 * std::numeric_limits<double>::epsilon() * largest);
    return {box.lower - margin, box.upper + margin};
}

Aabb transformed_box(const Transform& frame, const Aabb& local)
{
    Aabb result;
    for (int corner = 0; corner < 8; ++corner)
        result.include(
            frame.point({corner & 1 ? local.upper.x : local.lower.x, corner & 2 ? local.upper.y : local.lower.y,
                         corner & 4 ? local.upper.z : local.lower.z}));
    return result;
}

Aabb ellipsoid_box(const glm::dmat3& linear, const glm::dvec3& center)
{
    glm::dvec3 half(0.0);
    for (int i = 0; i < 3; ++i) half[i] = numbers::hypot(linear[0][i], linear[1][i], linear[2][i]);
    return {center - half, center + half};
}

Transform axis_frame(const glm::dvec3& base, const glm::dvec3& axis, double across, double along, Roundings by)
{
    // Rodrigues: z turned to the axis about k = (-axis_y, axis_x, 0); where that vanishes, about x (spec 5a, 3.3).
    glm::dvec3 k(-axis.y, axis.x, 0.0);
    double c = axis.z, s = std::sqrt(axis.x * axis.x + axis.y * axis.y);
    if (std::abs(axis.z) > 1.0 - 1e-10) {
        k = {1.0, 0.0, 0.0};
        c = axis.z > 0.0 ? 1.0 : -1.0;
        s = 0.0;
    } else {
        k = unit(k, by);
    }
    Transform turn;
    if (by == Roundings::Own) {
        const glm::dmat3 cross({0, k.z, -k.y}, {-k.z, 0, k.x}, {k.y, -k.x, 0});
        turn.linear = glm::dmat3(c) + cross * s + glm::outerProduct(k, k) * (1.0 - c);
    } else {  // POV-Ray asks for the angle
        const double angle = numbers::acos(c), cosine = numbers::cos(angle), sine = numbers::sin(angle),
                     rest = 1.0 - cosine, xy = k.x * k.y * rest, xs = k.x * sine, ys = k.y * sine;
        turn.linear = glm::dmat3({k.x * k.x + cosine * (1.0 - k.x * k.x), xy, -ys},
                                 {xy, k.y * k.y + cosine * (1.0 - k.y * k.y), xs}, {ys, -xs, cosine});
    }
    turn.inverse_linear = glm::transpose(turn.linear);
    return Transform::translate(base) * (turn * Transform::scale({across, across, along}));
}

}  // namespace csg
