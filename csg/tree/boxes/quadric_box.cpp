#include "csg/tree/boxes/quadric_box.h"

#include <algorithm>
#include <cmath>

namespace csg {
namespace {

/// Least of square x^2 + linear x for x from lower to upper.
double least(double square, double linear, double lower, double upper)
{
    if (square > 0.0) {
        const double x = std::clamp(-linear / (2.0 * square), lower, upper);
        return x * (square * x + linear);
    }
    if (square == 0.0) return linear == 0.0 ? 0.0 : linear * (linear > 0.0 ? lower : upper);
    if (!std::isfinite(lower) || !std::isfinite(upper)) return -kInfinity;
    return std::min(lower * (square * lower + linear), upper * (square * upper + linear));
}

/// The half-spaces that stand across an axis of the frame (as nearly as turning leaves them) and the box, in that
/// frame.
Aabb local_limits(const Transform& frame, const std::vector<Plane>& planes, const Aabb& box)
{
    constexpr double kAcross = 1e-12, kSlack = 1e-9;
    Aabb local = Aabb::everything();
    if (box.finite()) {
        Transform back = frame;
        std::swap(back.linear, back.inverse_linear);
        std::swap(back.offset, back.inverse_offset);
        local = transformed_box(back, box);
    }
    for (const Plane& plane : planes) {
        const glm::dvec3 normal = glm::transpose(frame.linear) * plane.normal_out;
        const double offset = plane.offset - glm::dot(plane.normal_out, frame.offset);
        const double size = glm::length(normal);
        for (int i = 0; i < 3; ++i) {
            if (!(glm::length(normal - normal[i] * glm::dvec3(i == 0, i == 1, i == 2)) <= kAcross * size)) continue;
            const double at = offset / normal[i], slack = kSlack * (std::abs(at) + std::abs(plane.offset / size));
            if (normal[i] > 0.0) local.upper[i] = std::min(local.upper[i], at + slack);
            else local.lower[i] = std::max(local.lower[i], at - slack);
        }
    }
    return local;
}

/// Narrows one axis by what the others leave of the quadric.
void narrow(const Quadric& q, int axis, Aabb& local)
{
    constexpr double kSlack = 1e-9;
    double rest = q.constant, size = std::abs(q.constant);
    for (int j = 0; j < 3; ++j) {
        if (j == axis) continue;
        const double part = least(q.square[j], q.linear[j], local.lower[j], local.upper[j]);
        rest += part;
        size += std::abs(part);
    }
    if (!std::isfinite(rest)) return;
    rest -= kSlack * size;
    const double s = q.square[axis], l = q.linear[axis];
    if (s > 0.0) {
        const double discriminant = l * l - 4.0 * s * rest;
        if (!(discriminant >= 0.0)) return;  // nothing left: rays find that out by themselves
        const double middle = -l / (2.0 * s),
                     half = std::sqrt(discriminant) / (2.0 * s) * (1.0 + kSlack) + kSlack * std::abs(middle);
        local.lower[axis] = std::max(local.lower[axis], middle - half);
        local.upper[axis] = std::min(local.upper[axis], middle + half);
    } else if (s == 0.0 && l != 0.0) {
        const double end = -rest / l;
        if (l > 0.0) local.upper[axis] = std::min(local.upper[axis], end + kSlack * std::abs(end));
        else local.lower[axis] = std::max(local.lower[axis], end - kSlack * std::abs(end));
    }
}

}  // namespace

Aabb quadric_box(const Quadric& quadric, const std::vector<Plane>& planes, const Aabb& box)
{
    if (quadric.mixed != glm::dvec3(0.0)) return box;
    Aabb local = local_limits(quadric.frame, planes, box);
    if (local.empty()) return box;
    constexpr int kRounds = 2;  // what the last axis has learnt serves the first
    for (int round = 0; round < kRounds; ++round)
        for (int axis = 0; axis < 3; ++axis) narrow(quadric, axis, local);
    if (!local.finite() || local.empty()) return box;
    return box.intersected(transformed_box(quadric.frame, local));
}

}  // namespace csg
