#pragma once

#include "csg/tree/program.h"

#include <cmath>

/// What decides whether places along a ray are the same, and whether it comes near a node.
namespace csg {

/// Two ends this close along a ray are one: relative to the parameter and to the size of the origin, 64 units in the
/// last place. Coincident faces of different solids come out of different formulas and differ by a few of them.
inline constexpr double kCoincidence = 64.0 * 0x1p-53;

/// The size of a ray's origin, in units of its parameter: what kCoincidence is relative to, besides the parameter.
inline double origin_reach(const Ray& ray)
{
    const glm::dvec3 o = glm::abs(ray.origin), d = glm::abs(ray.direction);
    return glm::max(o.x, glm::max(o.y, o.z)) / glm::max(d.x, glm::max(d.y, d.z));
}

/// A part of a ray; none as it begins.
struct Stretch {
    double from = kInfinity, to = -kInfinity;

    static Stretch everything() { return {-kInfinity, kInfinity}; }
    /// Makes it reach over another.
    void include(const Stretch& other)
    {
        from = glm::min(from, other.from);
        to = glm::max(to, other.to);
    }
    void narrow(const Stretch& other)
    {
        from = glm::max(from, other.from);
        to = glm::min(to, other.to);
    }
};

/// Whether the ray meets the node's box within a stretch, which becomes what lies in the box. inverse: of its
/// direction.
inline bool narrow_to_box(const Node& node, const Ray& ray, const glm::dvec3& inverse, Stretch& part)
{
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const bool backward = std::signbit(inverse[i]);
        const double a = (static_cast<double>(backward ? node.upper[k] : node.lower[k]) - ray.origin[i]) * inverse[i];
        const double b = (static_cast<double>(backward ? node.lower[k] : node.upper[k]) - ray.origin[i]) * inverse[i];
        if (a > part.from) part.from = a;  // NaN keeps what was there
        if (b < part.to) part.to = b;
    }
    return part.from <= part.to + kCoincidence * std::abs(part.to);
}

/// Boxes hold what solids tell but for its last digits. reach: origin_reach().
inline void widen(Stretch& in_box, double reach)
{
    constexpr double kRoom = 1e-6;
    in_box.from -= kRoom * (std::abs(in_box.from) + reach);
    in_box.to += kRoom * (std::abs(in_box.to) + reach);
}

/// Narrows a stretch to what lies between the first and the last place where a ray meets a leaf that has no box: a
/// half-space or a quadric. Others are left as they are. False: the ray misses it.
inline bool narrow_to_endless(const SolidStore& store, const Node& node, const Ray& ray, Stretch& part)
{
    if (node.op != Op::Leaf || node.bounded) return true;
    Stretch held;
    if (kind_of(node.solid) == SolidKind::Plane) {
        Interval in{-kInfinity, kInfinity};
        const bool met = store.all<Plane>()[index_of(node.solid)].interval(ray, in);
        if (!node.inverted && met) held = {in.entry, in.exit};
        else if (node.inverted && in.entry > -kInfinity) held = {-kInfinity, in.entry};
        else if (node.inverted && in.exit < kInfinity) held = {in.exit, kInfinity};
        else return true;  // along it
    } else if (kind_of(node.solid) == SolidKind::Quadric && !node.inverted) {
        std::array<Span, 2> memory;
        SpanList spans(memory.data(), static_cast<std::uint32_t>(memory.size()));
        store.all<Quadric>()[index_of(node.solid)].intersect(ray, spans);
        for (const Span& span : spans) held.include({span.in.t, span.out.t});
    } else {
        return true;
    }
    part.narrow(held);
    return part.from <= part.to + kCoincidence * std::abs(part.to);
}

/// Narrows a stretch to what a leaf is asked for: beyond the box of an operator above it that one holds nothing,
/// whatever the leaf does, and an intersection holds nothing beyond any of its operands, which are asked where the leaf
/// has no end of its own. Of bounds nothing is left out, for a guard asks whether the ray meets them anywhere. False,
/// and nothing is narrowed, where the ray misses one.
inline bool narrow_to_deciding(const SolidStore& store, const Node* nodes, std::uint32_t leaf, const Ray& ray,
                               Stretch& part)
{
    constexpr int kMostEndless = 8;  // operands that are looked at, of one operator
    const glm::dvec3 inverse = 1.0 / ray.direction;
    Stretch in_box = part;
    for (std::uint32_t i = leaf; i != 0 && nodes[nodes[i].parent].op != Op::Guard;) {
        const std::uint32_t below = i;
        i = nodes[i].parent;
        if (nodes[i].bounded && !narrow_to_box(nodes[i], ray, inverse, in_box)) return false;
        if (nodes[leaf].bounded || (nodes[i].op != Op::Intersection && nodes[i].op != Op::Clip)) continue;
        int looks = kMostEndless;
        for (std::uint32_t k = i + 1; k < nodes[i].end && looks > 0; k = nodes[k].end, --looks)
            if (k != below && !narrow_to_endless(store, nodes[k], ray, in_box)) return false;
    }
    widen(in_box, origin_reach(ray));
    part.narrow(in_box);
    return true;
}

}  // namespace csg
