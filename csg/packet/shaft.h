#pragma once

#include "csg/packet/point_set.h"
#include "csg/packet/tile_crossings.h"

/// What may stand between the hits of a tile and a lamp of some size, found once for all rays from the ones to the
/// other (shaft culling: Haines and Wallace, Shaft culling for efficient ray-cast radiosity, 1991).
namespace csg {

class Shaft {
public:
    /// Between every point of `from` and every point of `to`. Rays begin at `from`; crossings nearer to it than `least`
    /// do not count.
    Shaft(const WorldData& world, const PointSet& from, const PointSet& to, double least)
        : beam_(from, to, world.bvh.bounds)
    {
        if (world.faithful || !beam_.narrow()) return;
        serves_ = add_endless(world, from, to, least) && add_leaves(world);
    }

    /// False: too much lies there, or the points are not on two sides of anything. Rays have to go through the whole
    /// scene then.
    bool serves() const { return serves_; }
    /// Nothing stands there.
    bool empty() const { return serves_ && leaf_count_ == 0 && endless_count_ == 0; }

    /// Asks the query for the shadow rays, all of which run inside.
    template <class Rays, class Query>
    void ask(const WorldData& world, Rays& rays, Query& query) const
    {
        LaneFront<Rays> front(world.store, beam_, rays);
        PackedBoolean<Rays> boolean(world.store, rays);
        TileLeaf<Rays, Query> leaf{world, &beam_, rays, query, world.shadow_kinds, front, boolean};
        for (std::size_t i = 0; i < endless_count_; ++i) leaf.item(endless_[i], rays.all());
        for (std::size_t i = 0; i < leaf_count_; ++i) {
            if (i % kBetweenLooks == 0 && rays.farthest(0, rays.groups) < 0.0) return;
            leaf(leaves_[i].child, leaves_[i].lower, leaves_[i].upper, 0, rays.groups);
        }
    }

private:
    struct Leaf {
        ChildWord child;
        glm::dvec3 lower, upper;
    };
    static constexpr std::size_t kMostLeaves = 48, kMostEndless = 16;  // more are walked as fast by the hierarchy
    static constexpr std::size_t kBetweenLooks = 4;  // leaves before it is asked whether every ray is done

    bool add_endless(const WorldData& world, const PointSet& from, const PointSet& to, double least)
    {
        for (const std::uint32_t i : world.unbounded) {
            if (beside_plane(world, i, from, to, least)) continue;
            if (endless_count_ == kMostEndless) return false;
            endless_[endless_count_++] = i;
        }
        return true;
    }

    /// A plane that no ray crosses beyond `least`: all lie on one side of it, or begin upon it.
    static bool beside_plane(const WorldData& world, std::uint32_t index, const PointSet& from, const PointSet& to,
                             double least)
    {
        const WorldItem& item = world.items[index];
        if (item.solid == kNoPart || kind_of(item.solid) != SolidKind::Plane || item.guard != WorldItem::kNoGuard)
            return false;
        const Plane& plane = world.store.all<Plane>()[index_of(item.solid)];
        const auto side = [&](const PointSet& set) {
            const PointSet::Range range = set.along(plane.normal_out);
            return PointSet::Range{range.low - plane.offset, range.high - plane.offset};
        };
        const auto [begin_low, begin_high] = side(from);
        const auto [end_low, end_high] = side(to);
        // At most twice this: from any point to any.
        const double longest = std::max(from.farthest(to.at(0)), to.farthest(from.at(0)));
        // A ray that begins `below` under the plane and ends `above` over it crosses it at below / (below + above) of
        // its length.
        constexpr double kRoom = 0.1;
        const auto clear = [&](double below, double above) {
            return above > 0.0 && below * 2.0 * longest < kRoom * least * above;
        };
        return clear(std::max(0.0, -begin_low), end_low) || clear(std::max(0.0, begin_high), -end_high);
    }

    bool add_leaves(const WorldData& world)
    {
        if (world.bvh.nodes.empty()) return true;
        std::uint32_t stack[kBvhStack];
        int top = 0;
        stack[top++] = 0;
        while (top > 0) {
            const BvhNode& node = world.bvh.nodes[stack[--top]];
            alignas(32) float near[8];
            for (std::uint32_t mask = beam_.intersect(node.bounds, 0.0f, near); mask != 0; mask &= mask - 1) {
                const int i = std::countr_zero(mask);
                if ((node.kinds[i] & world.shadow_kinds) == 0) continue;
                if (!node.child[i].is_leaf()) {
                    stack[top++] = node.child[i].index();
                    continue;
                }
                if (leaf_count_ == kMostLeaves) return false;
                leaves_[leaf_count_++] = {node.child[i],
                                          {node.bounds[0][i], node.bounds[1][i], node.bounds[2][i]},
                                          {node.bounds[3][i], node.bounds[4][i], node.bounds[5][i]}};
            }
        }
        return true;
    }

    Beam beam_;
    std::array<Leaf, kMostLeaves> leaves_;
    std::array<std::uint32_t, kMostEndless> endless_;  ///< items without bounds
    std::size_t leaf_count_ = 0, endless_count_ = 0;
    bool serves_ = false;
};

}  // namespace csg
