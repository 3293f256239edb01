#pragma once

#include "csg/tile_walk.h"
#include "csg/world_item.h"

/// The two questions a tile asks, in vector lanes where the solid allows it. Compiled once per instruction set. Numbers
/// come from the same operations in the same order as for one ray, so the answers are the same to the last bit.
namespace csg {

/// Entry and exit of the rays from i on and a ball, as sphere_roots gives them; where `met` is false they mean nothing.
struct BallLanes {
    lanes::Double near, far;
    lanes::Double::batch_bool_type met;

    BallLanes(const TileRays& rays, int i, const glm::dvec3& f, double radius)
    {
        using lanes::Double;
        const Double x(f.x), y(f.y), z(f.z);
        const Double dx = Double::load_aligned(rays.dx.data() + i), dy = Double::load_aligned(rays.dy.data() + i),
                     dz = Double::load_aligned(rays.dz.data() + i), inverse_a = Double::load_aligned(rays.inverse_a.data() + i);
        const Double foot_t = -(x * dx + y * dy + z * dz) * inverse_a;
        const Double fx = x + foot_t * dx, fy = y + foot_t * dy, fz = z + foot_t * dz;
        const Double below = Double(radius * radius) - (fx * fx + fy * fy + fz * fz);
        met = below > Double(0.0);
        if (lanes::mask(met) == 0) return;
        const Double correction = -(fx * dx + fy * dy + fz * dz) * inverse_a;
        const Double half = xsimd::sqrt(below * inverse_a);
        near = foot_t + (correction - half);
        far = foot_t + (correction + half);
        met = met & (near <= far);
    }
};

/// Opens leaf blocks for Query: query.each(item index, ray), query.ball(item index, centre - origin, radius, groups).
template <class Query>
struct TileLeaf {
    const WorldData& world;
    const Beam& beam;
    TileRays& rays;
    Query& query;
    std::uint32_t kinds;

    void operator()(ChildWord leaf, const glm::dvec3& lower, const glm::dvec3& upper, int first, int last) const
    {
        if (leaf.kind() == LeafKind::Spheres) {
            const SphereBlock& block = world.spheres[leaf.index()];
            for (std::uint32_t mask = beam.meet(block); mask != 0; mask &= mask - 1) {
                const int k = std::countr_zero(mask);
                const std::uint32_t item = block.item[k];
                if ((world.items[item].visible & kinds) == 0) continue;
                query.ball(item, rays.origin - glm::dvec3(block.x[k], block.y[k], block.z[k]), block.radius[k], first, last);
            }
            return;
        }
        for (RayMask mask = rays.meet(lower, upper, first, last); mask != 0; mask &= mask - 1) {
            const int ray = std::countr_zero(mask);
            if (leaf.kind() == LeafKind::Item) {
                each(leaf.index(), ray);
                continue;
            }
            const auto& start = world.bvh.triangle_first;
            for (std::uint32_t k = start[leaf.index()]; k < start[leaf.index() + 1]; ++k)
                each(world.bvh.triangle_members[k], ray);
        }
    }

    void each(std::uint32_t item, int ray) const
    {
        if ((world.items[item].visible & kinds) != 0 && !(rays.limit[static_cast<std::size_t>(ray)] < 0.0)) query.each(item, ray);
    }
};

/// The nearest hit of every ray.
class NearestOfTile {
public:
    NearestOfTile(const WorldData& world, TileRays& rays, Scratch& scratch, HitTile& out)
        : world_(world), rays_(rays), scratch_(scratch), out_(out)
    {
        out.t.fill(kInfinity);
        out.surface.fill(kNoSurface);
        item_.fill(kNone);
    }

    void each(std::uint32_t index, int i)
    {
        const auto k = static_cast<std::size_t>(i);
        const Hit hit = item_nearest(world_, world_.items[index], rays_.ray(i), rays_.t_min[k], rays_.limit[k], scratch_);
        if (!hit.found() || hit.t > rays_.limit[k]) return;
        if (!(hit.t < out_.t[k]) && !(static_cast<double>(index) < item_[k])) return;
        out_.set(i, hit);
        item_[k] = static_cast<double>(index);
        rays_.limit[k] = hit.t;
    }

    void ball(std::uint32_t index, const glm::dvec3& f, double radius, int first, int last)
    {
        using lanes::Double;
        const Double id(static_cast<double>(index));
        for (int i = first * kRayGroup; i < last * kRayGroup; i += lanes::kDoubles) {
            const BallLanes ball(rays_, i, f, radius);
            if (lanes::mask(ball.met) == 0) continue;
            const Double t_min = Double::load_aligned(rays_.t_min.data() + i), limit = Double::load_aligned(rays_.limit.data() + i);
            const Double best = Double::load_aligned(out_.t.data() + i), item = Double::load_aligned(item_.data() + i);
            const Double t = xsimd::select(ball.near >= t_min, ball.near, ball.far);
            const auto wins = ball.met & (t >= t_min) & (t <= limit) & ((t < best) | (id < item));
            if (lanes::mask(wins) == 0) continue;
            xsimd::select(wins, t, best).store_aligned(out_.t.data() + i);
            xsimd::select(wins, t, limit).store_aligned(rays_.limit.data() + i);
            xsimd::select(wins, id, item).store_aligned(item_.data() + i);
        }
    }

    /// Balls leave only their number while the walk lasts.
    void finish()
    {
        for (int i = 0; i < rays_.count; ++i) {
            const auto k = static_cast<std::size_t>(i);
            if (item_[k] == kNone) {
                out_.set(i, {});
                continue;
            }
            const WorldItem& item = world_.items[static_cast<std::size_t>(item_[k])];
            if (item.solid == kNoPart || item.inverted || kind_of(item.solid) != SolidKind::Sphere) continue;
            out_.set(i, {out_.t[k], world_.store.surface(item.solid), item.solid, 0, false});
        }
    }

private:
    static constexpr double kNone = 4294967295.0;
    const WorldData& world_;
    TileRays& rays_;
    Scratch& scratch_;
    HitTile& out_;
    alignas(64) TileRays::Lanes item_;   ///< the winner's place in the order of declaration
};

/// Whether every ray is blocked. A blocked ray's limit becomes -infinity: it is done.
class ShadowOfTile {
public:
    ShadowOfTile(const WorldData& world, TileRays& rays, Scratch& scratch) : world_(world), rays_(rays), scratch_(scratch) {}

    void each(std::uint32_t index, int i)
    {
        const auto k = static_cast<std::size_t>(i);
        const WorldItem& item = world_.items[index];
        const double limit = rays_.limit[k];
        if (item.all_opaque) {
            if (item_nearest(world_, item, rays_.ray(i), rays_.t_min[k], limit, scratch_).found()) meet(RayMask{1} << i, true);
            return;
        }
        item_crossings(world_, item, rays_.ray(i), rays_.t_min[k], limit, scratch_,
                       [&](const Hit& hit) { meet(RayMask{1} << i, world_.surface_opaque[hit.surface] != 0); });
    }

    void ball(std::uint32_t index, const glm::dvec3& f, double radius, int first, int last)
    {
        using lanes::Double;
        const bool opaque = world_.surface_opaque[world_.store.surface(world_.items[index].solid)] != 0;
        for (int i = first * kRayGroup; i < last * kRayGroup; i += lanes::kDoubles) {
            const BallLanes ball(rays_, i, f, radius);
            if (lanes::mask(ball.met) == 0) continue;
            const Double t_min = Double::load_aligned(rays_.t_min.data() + i), limit = Double::load_aligned(rays_.limit.data() + i);
            const auto in = ball.met & (((ball.near >= t_min) & (ball.near <= limit)) | ((ball.far >= t_min) & (ball.far <= limit)));
            meet(static_cast<RayMask>(lanes::mask(in)) << i, opaque);
        }
    }

    Shadow answer(int i) const
    {
        const RayMask bit = RayMask{1} << i;
        return (blocked_ & bit) != 0 ? Shadow::Blocked : (filtered_ & bit) != 0 ? Shadow::Filtered : Shadow::Clear;
    }

private:
    void meet(RayMask rays, bool opaque)
    {
        (opaque ? blocked_ : filtered_) |= rays;
        for (; opaque && rays != 0; rays &= rays - 1) rays_.limit[static_cast<std::size_t>(std::countr_zero(rays))] = -kInfinity;
    }

    const WorldData& world_;
    TileRays& rays_;
    Scratch& scratch_;
    RayMask blocked_ = 0, filtered_ = 0;
};

/// Asks everything of the query: unbounded items ray by ray, then the hierarchy by beam. False: nothing was asked,
/// the rays are too far apart.
template <class Query>
inline bool ask_tile(const WorldData& world, TileRays& rays, std::uint32_t kinds, Query& query)
{
    const Beam beam(rays, world.bvh.bounds);
    if (!beam.narrow()) return false;
    TileLeaf<Query> leaf{world, beam, rays, query, kinds};
    for (const std::uint32_t item : world.unbounded)
        for (int i = 0; i < rays.count; ++i) leaf.each(item, i);
    TileWalk(world.bvh, beam, rays, kinds, leaf).run();
    return true;
}

/// Fewer rays than this go one by one.
inline constexpr int kFewestForBeam = 4;

}  // namespace csg
