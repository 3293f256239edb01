#pragma once

#include "csg/bvh/bvh.h"
#include "csg/base/lanes.h"
#include "csg/base/rounding.h"

#include <bit>
#include <cmath>

/// One ray through the hierarchy. Compiled once per instruction set.
namespace csg {

/// A ray prepared for boxes in single precision: origin and reciprocals rounded so that a box is never missed.
class RaySlabs {
public:
    explicit RaySlabs(const Ray& ray)
    {
        for (int axis = 0; axis < 3; ++axis) {
            const double d = ray.direction[axis];
            const bool backward = std::signbit(d);
            // Clamped, so that 0 * infinity never arises; 1e30 times any distance in a scene is past its end.
            const double inverse = std::abs(d) < 1e-30 ? (backward ? -1e30 : 1e30) : 1.0 / d;
            // Twice the error of the conversion to either side: cheaper than the neighbouring floats, and boxes are
            // only a sieve.
            const auto origin = static_cast<float>(ray.origin[axis]);
            const float error = std::abs(origin) * 2.4e-7f + 1e-37f;
            const float down = origin - error, up = origin + error;
            near_row[axis] = backward ? axis + 3 : axis;
            far_row[axis] = backward ? axis : axis + 3;
            near_origin[axis] = backward ? down : up;
            far_origin[axis] = backward ? up : down;
            // Three roundings of 6e-8 each: conversion, difference and product.
            near_inverse[axis] = static_cast<float>(inverse * (1.0 - 2.4e-7));
            far_inverse[axis] = static_cast<float>(inverse * (1.0 + 3.6e-7));
        }
    }

    /// Which of eight boxes (BvhNode::bounds) the ray meets in [t_min, t_max]; `near` receives where.
    std::uint32_t meet(const float (&bounds)[6][8], float t_min, float t_max, float* near) const
    {
        using lanes::FloatPart;
        std::uint32_t mask = 0;
        for (int part = 0; part < lanes::kFloatParts; ++part) {
            const int at = part * lanes::kFloatPart;
            FloatPart first(t_min), last(t_max);
            for (int axis = 0; axis < 3; ++axis) {
                const FloatPart a =
                    (FloatPart::load_aligned(bounds[near_row[axis]] + at) - FloatPart(near_origin[axis])) *
                    FloatPart(near_inverse[axis]);
                const FloatPart b =
                    (FloatPart::load_aligned(bounds[far_row[axis]] + at) - FloatPart(far_origin[axis])) *
                    FloatPart(far_inverse[axis]);
                first = xsimd::max(first, a);
                last = xsimd::min(last, b);
            }
            first.store_aligned(near + at);
            mask |= lanes::mask(first <= last) << at;
        }
        return mask;
    }

private:
    int near_row[3], far_row[3];
    float near_origin[3], far_origin[3], near_inverse[3], far_inverse[3];
};

/// Calls leaf(ChildWord) for the blocks that the ray meets, nearer children first. leaf returns the new far limit; a
/// negative one ends the walk. Only children with a bit of `kinds` are entered.
template <class Leaf>
inline void traverse(const Bvh& bvh, const RaySlabs& slabs, double t_min, double t_max, std::uint32_t kinds,
                     Leaf&& leaf)
{
    if (bvh.nodes.empty()) return;
    struct Entry {
        ChildWord child;
        float near;
    };
    Entry stack[kBvhStack];
    int top = 0;
    const float begin = rounded_down(t_min);
    float limit = rounded_up(t_max);
    ChildWord current = ChildWord::node(0);
    for (;;) {
        if (current.is_leaf()) {
            const double far = leaf(current);
            if (far < 0.0) return;
            limit = rounded_up(far);
        } else {
            const BvhNode& node = bvh.nodes[current.index()];
            alignas(32) float near[8];
            std::uint32_t mask = slabs.meet(node.bounds, begin, limit, near);
            int best = -1;
            for (; mask != 0; mask &= mask - 1) {
                const int i = std::countr_zero(mask);
                if ((node.kinds[i] & kinds) == 0) continue;
                if (best < 0) {
                    best = i;
                    continue;
                }
                const int later = near[i] < near[best] ? best : i;
                best = near[i] < near[best] ? i : best;
                stack[top++] = {node.child[later], near[later]};
            }
            if (best >= 0) {
                current = node.child[best];
                continue;
            }
        }
        do {
            if (top == 0) return;
            --top;
        } while (!(stack[top].near <= limit));
        current = stack[top].child;
    }
}

}  // namespace csg
