#pragma once

#include "csg/packet/beam.h"
#include "csg/packet/packet_walk.h"

/// A tile through the hierarchy.
namespace csg {

/// How near to each other the rays of a tile run: the eight of each group go nearly the same way; all start in one
/// point; neither.
enum class Spread { Neighbours, FromOnePoint, Scattered };

/// Walks for the whole tile at once, nearest box first, up to a budget of leaf blocks (a beam that sees hundreds of
/// small things is slower than packets). From the stack as it stands each group of eight rays goes on alone then, if
/// these are neighbours; otherwise each ray does, by PacketWalk. leaf(child, lower, upper, first group, last group)
/// opens a block and lowers rays.limit.
template <class Rays, class Leaf>
class TileWalk {
public:
    TileWalk(const Bvh& bvh, const Beam& beam, const Rays& rays, std::uint32_t kinds, Leaf& leaf)
        : bvh_(bvh), beam_(beam), rays_(rays), kinds_(kinds), leaf_(leaf)
    {}

    void run(Spread spread)
    {
        if (bvh_.nodes.empty()) return;
        constexpr float kAnywhere = -std::numeric_limits<float>::infinity();
        constexpr int kBlocks[] = {32, 16, 8};
        stack_[0] = {ChildWord::node(0), 0, kAnywhere, kAnywhere};
        const int left = walk(stack_, 1, 0, rays_.groups, kBlocks[static_cast<int>(spread)]);
        if (left == 0) return;
        if (spread != Spread::Neighbours) return each_its_own_way(left);
        Entry own[kBvhStack];
        for (int g = 0; g < rays_.groups; ++g) {
            std::copy(stack_, stack_ + left, own);
            walk(own, left, g, g + 1, std::numeric_limits<int>::max());
        }
    }

private:
    [[gnu::noinline]] void each_its_own_way(int left)
    {
        const PacketSlabs<Rays> slabs(rays_);
        PacketWalk<Rays, Leaf> walk(bvh_, slabs, rays_, kinds_, leaf_);
        for (int i = 0; i < left; ++i) walk.put(stack_[i].child, stack_[i].near);
        walk.go_on();
    }

    struct Entry {
        ChildWord child;
        std::uint32_t slot;  ///< node * 8 + place: where its box is
        float near;
        float order;
    };

    /// Until the stack is empty or the budget is used up; returns what is left on the stack.
    int walk(Entry* stack, int top, int first, int last, int budget)
    {
        const bool packet = last - first == 1;
        float limit = rounded_up(rays_.farthest(first, last));
        while (top > 0 && limit >= 0.0f) {
            if (budget == 0) return top;
            const Entry entry = stack[--top];
            if (!(entry.near <= limit)) continue;
            if (entry.child.is_leaf()) {
                --budget;
                leaf_(entry.child, corner(entry.slot, 0), corner(entry.slot, 3), first, last);
                limit = rounded_up(rays_.farthest(first, last));
            } else {
                top = push_children(entry.child.index(), stack, top, limit, packet ? first : -1);
            }
        }
        return 0;
    }

    int push_children(std::uint32_t index, Entry* stack, int top, float limit, int packet)
    {
        const BvhNode& node = bvh_.nodes[index];
        alignas(32) float near[8];
        const int bottom = top;
        for (std::uint32_t mask = beam_.intersect(node.bounds, limit, near); mask != 0; mask &= mask - 1) {
            const auto i = static_cast<std::uint32_t>(std::countr_zero(mask));
            if ((node.kinds[i] & kinds_) == 0) continue;
            const Entry made{node.child[i], index * 8 + i, near[i], asked_at(node, i, near[i])};
            if (packet >= 0 &&
                rays_.intersect(corner(made.slot, 0), corner(made.slot, 3), rays_of_groups(packet, packet + 1)) == 0)
                continue;
            int at = top++;
            for (; at > bottom && stack[at - 1].order < made.order; --at) stack[at] = stack[at - 1];
            stack[at] = made;
        }
        return top;
    }

    glm::dvec3 corner(std::uint32_t slot, int row) const
    {
        const auto& bounds = bvh_.nodes[slot / 8].bounds;
        return {bounds[row][slot % 8], bounds[row + 1][slot % 8], bounds[row + 2][slot % 8]};
    }

    const Bvh& bvh_;
    const Beam& beam_;
    const Rays& rays_;
    std::uint32_t kinds_;
    Leaf& leaf_;
    Entry stack_[kBvhStack];
};

}  // namespace csg
