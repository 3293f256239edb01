#pragma once

#include "csg/bvh/slab_axis.h"
#include "csg/bvh/bvh.h"
#include "numbers/lanes.h"
#include "numbers/rounding.h"

#include <bit>
#include <cmath>

/// One ray through the hierarchy.
namespace csg {

/// A ray prepared for boxes in single precision: origin and reciprocals rounded so that a box is never missed.
class RaySlabs {
public:
    explicit RaySlabs(const Ray& ray)
    {
        for (int axis = 0; axis < 3; ++axis) {
            const double d = ray.direction[axis];
            axes_[axis] = SlabAxis(axis, ray.origin[axis], slab_reciprocal(d), std::signbit(d));
        }
    }

    /// Which of eight boxes (BvhNode::bounds) the ray meets in [t_min, t_max]; `near` receives where.
    std::uint32_t intersect(const float (&bounds)[6][8], float t_min, float t_max, float* near) const
    {
        using lanes::FloatPart;
        std::uint32_t mask = 0;
        for (int part = 0; part < lanes::kFloatParts; ++part) {
            const int at = part * lanes::kFloatPart;
            FloatPart first(t_min), last(t_max);
            for (const SlabAxis& axis : axes_) axis.cut(bounds, at, first, last);
            first.store_aligned(near + at);
            mask |= lanes::mask(first <= last) << at;
        }
        return mask;
    }

private:
    SlabAxis axes_[3];
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
            std::uint32_t mask = slabs.intersect(node.bounds, begin, limit, near);
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
