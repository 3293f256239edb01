#pragma once

#include "csg/packet/packet_slabs.h"

/// Rays that form no beam, through the hierarchy together.
namespace csg {

/// Each ray goes its own way, but they share the stack: a node is looked at once for all that come to it, and a leaf
/// is opened for these. leaf.open(child, rays) lowers rays.limit; leaf.fetch(child), if there is one, is told of what
/// will be looked at.
template <class Rays, class Leaf>
class PacketWalk {
public:
    PacketWalk(const Bvh& bvh, const PacketSlabs<Rays>& slabs, const Rays& rays, std::uint32_t kinds, Leaf& leaf)
        : bvh_(bvh), slabs_(slabs), rays_(rays), kinds_(kinds), leaf_(leaf)
    {}

    void run()
    {
        if (bvh_.nodes.empty()) return;
        put(ChildWord::node(0), -std::numeric_limits<float>::infinity());
        go_on();
    }

    /// A part of the hierarchy that all rays may come to, `near` being where at the earliest. The last is looked at
    /// first.
    void put(ChildWord child, float near) { stack_[top_++] = {child, near, near, rays_.all()}; }

    void go_on()
    {
        int top = top_;
        while (top > 0) {
            const Entry entry = stack_[--top];
            const RayMask left = reaching(entry.rays, entry.near);
            if (left == 0) continue;
            if (entry.child.is_leaf()) leaf_.open(entry.child, left);
            else top = push_children(bvh_.nodes[entry.child.index()], left, top);
        }
    }

private:
    struct Entry {
        ChildWord child;
        float near;  ///< where the first of the rays is in its box
        float order;
        RayMask rays;
    };

    /// Rays of the mask that look as far as this.
    RayMask reaching(RayMask asked, float near) const
    {
        using lanes::Double;
        RayMask mask = 0;
        const Double least(static_cast<double>(near));
        each_vector(asked, [&](int i) {
            mask |= RayMask{lanes::mask(Double::load_aligned(rays_.limit.data() + i) >= least)} << i;
        });
        return mask & asked;
    }

    int push_children(const BvhNode& node, RayMask asked, int top)
    {
        alignas(32) float near[8];
        std::array<RayMask, 8> rays;
        const int bottom = top;
        for (std::uint32_t mask = slabs_.intersect(node.bounds, asked, rays, near); mask != 0; mask &= mask - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(mask));
            if ((node.kinds[i] & kinds_) == 0) continue;
            if constexpr (requires { leaf_.fetch(node.child[i]); }) leaf_.fetch(node.child[i]);
            int at = top++;
            const float order = asked_at(node, static_cast<std::uint32_t>(i), near[i]);
            for (; at > bottom && stack_[at - 1].order < order; --at) stack_[at] = stack_[at - 1];
            stack_[at] = {node.child[i], near[i], order, rays[i]};
        }
        return top;
    }

    const Bvh& bvh_;
    const PacketSlabs<Rays>& slabs_;
    const Rays& rays_;
    std::uint32_t kinds_;
    Leaf& leaf_;
    int top_ = 0;
    Entry stack_[kBvhStack];
};

}  // namespace csg
