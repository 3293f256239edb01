#pragma once

#include "csg/packet/lanes/extrusion_sieve.h"
#include "csg/packet/lane_front.h"
#include "csg/packet/near_bound.h"
#include "csg/packet/lanes/lane_quartic.h"
#include "csg/packet/lanes/polynomial_sieve.h"
#include "csg/packet/lanes/lane_torus.h"
#include "csg/packet/mesh_rays.h"
#include "csg/packet/boolean/packed_boolean.h"
#include "csg/packet/tile_many.h"
#include "csg/packet/tile_walk.h"
#include "csg/items/world_item.h"

/// What a leaf block means to a tile.
namespace csg {

/// Opens leaf blocks for Query:
///   query.solid(item index, rays, at)  a convex solid; at(i) gives lanes::Intervals of the rays from i on
///   query.ask(front, item, form, rays) a CSG object in lanes; only where query.lanes_serve(item)
///   query.program(item index, front)   what came of it
///   query.record(item index, ray, told)  what a lone solid that answers many rays together has told of one;
///   query.first_only(item)             whether the nearest drawn end of it is enough
///   query.any_will_do()                and any other as well
///   query.block_all(mask)              where any will do: rays that meet a solid that is opaque
///   query.hit(item index, ray, hit)    one crossing of a CSG object: the nearest, or each of them
///   query.each(item index, ray)        anything else, ray by ray
///   query.guarded_until(ray)           as `end` of passes()
template <class Rays, class Query>
struct TileLeaf {
    const WorldData& world;
    const Beam* beam;  ///< null: the rays form none
    Rays& rays;
    Query& query;
    std::uint32_t kinds;
    LaneFront<Rays>& front;
    PackedBoolean<Rays>& boolean;

    void operator()(ChildWord leaf, const glm::dvec3& lower, const glm::dvec3& upper, int first, int last) const
    {
        if (leaf.kind() == LeafKind::Spheres) {
            spheres(world.spheres[leaf.index()], first, last);
            return;
        }
        const RayMask mask = rays.intersect(lower, upper, rays_of_groups(first, last));
        if (mask != 0) items(leaf, mask);
    }

    /// The block for rays that form no beam.
    void open(ChildWord leaf, RayMask mask) const
    {
        if (leaf.kind() == LeafKind::Spheres) spheres(world.spheres[leaf.index()], mask);
        else items(leaf, mask);
    }

    /// An item against the rays of the mask.
    void item(std::uint32_t index, RayMask mask) const
    {
        const WorldItem& item = world.items[index];
        if ((item.visible & kinds) == 0) return;
        const bool guarded = item.guard != WorldItem::kNoGuard;
        if (item.solid != kNoPart && !guarded && lanes::has_test(world.store, item.solid)) {
            lanes::with_test(world.store, item.solid, rays, [&](const auto& at) { query.solid(index, mask, at); });
            return;
        }
        if (kind_of(item.solid) == SolidKind::Torus && !guarded && torus(index, mask)) return;
        if (kind_of(item.solid) == SolidKind::Quadric && !guarded) return quadric(index, mask);
        if (serves_instance(item, mask)) return within(index, mask);
        const Polynomial* const polynomial = polynomial_of(item, mask);
        const bool mesh = serves_mesh(item, mask), quartic = polynomial != nullptr && QuarticEnds::serve(*polynomial),
                   sieve = polynomial != nullptr && has_sieve(*polynomial);
        if (guarded && (mask & (mask - 1)) != 0 &&
            (item.simple || item.boolean || item.many || mesh || quartic || sieve))
            mask = passing(item, mask);
        if (mesh) return faces(index, mask);
        if (quartic) return pieces(index, QuarticEnds(*polynomial, rays, mask));
        if (sieve) mask = rays_near(*polynomial, rays, mask);
        if (item.many && (mask & (mask - 1)) != 0) {
            if (item.solid != kNoPart) return together(index, mask);
            return fetched(index, mask);
        }
        if (item.simple && (mask & (mask - 1)) != 0 && query.lanes_serve(item)) {
            query.ask(front, item, world.programs[item.program].products, mask);
            query.program(index, front);
            mask = front.undecided;
        }
        if (serves_ends(item, mask)) mask = by_ends(index, mask);
        for (; mask != 0; mask &= mask - 1) each(index, std::countr_zero(mask));
    }

private:
    void items(ChildWord leaf, RayMask mask) const
    {
        if (leaf.kind() == LeafKind::Item) {
            item(leaf.index(), mask);
            return;
        }
        const auto& start = world.bvh.triangle_first;
        for (std::uint32_t k = start[leaf.index()]; k < start[leaf.index() + 1]; ++k)
            triangle(world.bvh.triangle_members[k], mask);
    }

    /// The rays that the item's guard lets through.
    RayMask passing(const WorldItem& item, RayMask mask) const
    {
        mask = near_bound(world, world.guards[item.guard], rays, mask,
                          [&](std::size_t k) { return query.guarded_until(k); });
        RayMask out = 0;
        each_ray(mask, [&](std::size_t k) {
            if (!(rays.limit[k] < 0.0) && passes(world, item, rays.ray(static_cast<int>(k)), rays.t_min[k],
                                                 query.guarded_until(k), query.scratch()))
                out |= RayMask{1} << k;
        });
        return out;
    }

    bool serves_mesh(const WorldItem& item, RayMask mask) const
    {
        constexpr int kFewest = 4;
        return kind_of(item.solid) == SolidKind::Mesh && std::popcount(mask) >= kFewest && query.first_only(item);
    }

    /// A mesh of which the nearest face of each ray is enough, or any where the query needs no more.
    void faces(std::uint32_t index, RayMask mask) const
    {
        const WorldItem& item = world.items[index];
        const Mesh& mesh = world.store.all<Mesh>()[index_of(item.solid)];
        MeshRays near;
        each_ray(mask, [&](std::size_t k) {
            if (!(rays.limit[k] < 0.0))
                near.add(mesh.shape->bounds(), local_ray(mesh.frame, rays.ray(static_cast<int>(k))), k, rays.t_min[k],
                         rays.limit[k]);
        });
        MeshFaces met(*mesh.shape, near, rays, query.any_will_do());
        const PacketSlabs<MeshRays> slabs(near);
        PacketWalk(mesh.shape->bvh(), slabs, near, ~0u, met).run();
        for (std::size_t i = 0; i < static_cast<std::size_t>(near.count); ++i) {
            if (!(met.t[i] < kInfinity)) continue;
            const Hit hit{met.t[i], mesh.surface(met.face[i]), item.solid, met.face[i], item.inverted};
            if (hit.found()) query.hit(index, near.place[i], hit);
        }
    }

    bool serves_instance(const WorldItem& item, RayMask mask) const
    {
        constexpr int kFewest = 3;
        return item.instance != Hit::kNoInstance && item.guard == WorldItem::kNoGuard && query.first_only(item) &&
               std::popcount(mask) >= kFewest;
    }

    /// An instance of which the nearest hit of each ray is enough, or any: these rays together are a tile of its world.
    [[gnu::noinline]] void within(std::uint32_t index, RayMask mask) const
    {
        RayTile asked;
        std::array<std::uint8_t, kTileRays> place;
        std::size_t count = 0;
        each_ray(mask, [&](std::size_t k) {
            if (rays.limit[k] < 0.0) return;
            asked.set(count, rays.ray(static_cast<int>(k)), rays.t_min[k], rays.limit[k]);
            place[count++] = static_cast<std::uint8_t>(k);
        });
        if (count == 0) return;
        asked.count = static_cast<int>(count);
        asked.common_origin = Rays::kShared;
        if constexpr (Query::any_will_do()) {
            std::array<Shadow, kTileRays> ending;
            instance_shadow(world, world.items[index], asked, query.scratch(), ending.data());
            RayMask blocked = 0;
            for (std::size_t i = 0; i < count; ++i)
                if (ending[i] == Shadow::Blocked) blocked |= RayMask{1} << place[i];
            query.block_all(blocked);
        } else {
            HitTile met;
            instance_nearest(world, world.items[index], asked, query.scratch(), met);
            for (std::size_t i = 0; i < count; ++i)
                if (met.surface[i] != kNoSurface) query.hit(index, place[i], met.at(static_cast<int>(i)));
        }
    }

    static bool serves_ends(const WorldItem& item, RayMask mask)
    {
        constexpr int kFewest = 3;
        return item.boolean && std::popcount(mask) >= kFewest;
    }

    /// A CSG object by its boolean form. Returns the rays that remain to be asked one by one.
    RayMask by_ends(std::uint32_t index, RayMask mask) const
    {
        const WorldItem& item = world.items[index];
        boolean.ask(world.programs[item.program], mask, query.first_only(item), query.scratch());
        boolean.each_crossing([&](std::size_t k, const Hit& hit) { query.hit(index, k, hit); });
        return boolean.undecided;
    }

    TileMany<Rays, Query> many() const { return {world, rays, query}; }

    /// A lone solid that answers many rays together.
    void together(std::uint32_t index, RayMask mask) const
    {
        const WorldItem& item = world.items[index];
        const bool first_only = query.first_only(item);
        const std::uint32_t at = index_of(item.solid);
        const Extrusion* const extrusion =
            kind_of(item.solid) == SolidKind::Extrusion ? &world.store.all<Extrusion>()[at] : nullptr;
        if (extrusion != nullptr) mask = rays_near(*extrusion, rays, mask);
        if (mask == 0) return;
        const RayBatch& batch = extrusion != nullptr
                                    ? many().told_of(*extrusion, mask, first_only)
                                    : many().told_of(world.store.all<Freeform>()[at], mask, first_only);
        for (std::size_t k = 0; k < batch.count; ++k) query.record(index, batch.place[k], batch.records[k]);
    }

    /// A CSG object of which some leaf answers many rays together: these first, then ray by ray.
    void fetched(std::uint32_t index, RayMask mask) const
    {
        if (many().serves_merged(world.items[index])) mask = many().by_merged(index, mask);
        FetchedSpans& known = query.scratch().fetched;
        const std::vector<Node>& nodes = world.programs[world.items[index].program].nodes;
        for (std::uint32_t i = 0; i < nodes.size(); ++i) {
            const Node& node = nodes[i];
            if (node.op != Op::Leaf || kind_of(node.solid) != SolidKind::Freeform) continue;
            const Freeform& solid = world.store.all<Freeform>()[index_of(node.solid)];
            if (!solid.intersects_many()) continue;
            const auto corner = [](const std::array<float, 3>& c) { return glm::dvec3(c[0], c[1], c[2]); };
            const RayMask asked = node.test_box ? rays.intersect(corner(node.lower), corner(node.upper), mask) : mask;
            if ((asked & (asked - 1)) == 0) continue;
            const RayBatch& told = many().told_of(solid, asked, false, [&](const Ray& ray, Stretch& range) {
                return narrow_to_deciding(world.store, nodes.data(), i, ray, range);
            });
            known.add(&node, told, [&](std::size_t k) { return std::pair(rays.t_min[k], rays.limit[k]); });
        }
        if (serves_ends(world.items[index], mask)) mask = by_ends(index, mask);
        for (; mask != 0; mask &= mask - 1) {
            known.select(std::countr_zero(mask));
            each(index, std::countr_zero(mask));
        }
        known.clear();
    }

    /// False: its solver is not for lanes.
    bool torus(std::uint32_t index, RayMask mask) const
    {
        const Torus& solid = world.store.all<Torus>()[index_of(world.items[index].solid)];
        if (!detail::factors_serve(solid)) return false;
        const TorusEnds ends(solid, rays, mask, query.any_will_do() && query.first_only(world.items[index]));
        if constexpr (Query::any_will_do())
            if (ends.sure != 0) query.block_all(ends.sure);
        pieces(index, ends);
        return true;
    }

    /// Of a solid that has several a ray.
    template <class Ends>
    void pieces(std::uint32_t index, const Ends& ends) const
    {
        for (int which = 0; which < Ends::kPieces; ++which)
            query.solid(index, ends.met[which], [&](int i) { return ends.piece(which, i); });
        for (RayMask left = ends.unclear; left != 0; left &= left - 1) each(index, std::countr_zero(left));
    }

    /// A lone polynomial that enough rays come to; null otherwise.
    const Polynomial* polynomial_of(const WorldItem& item, RayMask mask) const
    {
        constexpr int kFewest = 3;
        return kind_of(item.solid) == SolidKind::Polynomial && std::popcount(mask) >= kFewest
                   ? &world.store.all<Polynomial>()[index_of(item.solid)]
                   : nullptr;
    }

    /// Its second spans are kept while the first are looked at.
    void quadric(std::uint32_t index, RayMask mask) const
    {
        const Quadric& solid = world.store.all<Quadric>()[index_of(world.items[index].solid)];
        std::array<lanes::Intervals, kTileRays / lanes::kDoubles> beyond;
        RayMask unclear = 0, twice = 0;
        lanes::with_spans(solid, rays, [&](const auto& both) {
            query.solid(index, mask, [&](int i) {
                lanes::Intervals& second = beyond[static_cast<std::size_t>(i) / lanes::kDoubles];
                const lanes::Intervals own = both(i, second);
                unclear |= RayMask{lanes::mask(own.unclear)} << i & mask;
                twice |= RayMask{lanes::mask(second.met)} << i & mask;
                return own;
            });
        });
        if (twice != 0)
            query.solid(index, twice, [&](int i) { return beyond[static_cast<std::size_t>(i) / lanes::kDoubles]; });
        for (; unclear != 0; unclear &= unclear - 1) each(index, std::countr_zero(unclear));
    }

    /// A lone triangle without a guard, as all are that leaves of triangles hold.
    void triangle(std::uint32_t index, RayMask mask) const
    {
        const WorldItem& item = world.items[index];
        if ((item.visible & kinds) == 0) return;
        lanes::with_test(world.store, item.solid, rays, [&](const auto& at) { query.solid(index, mask, at); });
    }

    void spheres(const SphereBlock& block, int first, int last) const
    {
        spheres_in_beam(block, rays_of_groups(first, last));
    }
    void spheres_in_beam(const SphereBlock& block, RayMask asked) const
    {
        for (std::uint32_t mask = beam->intersect(block); mask != 0; mask &= mask - 1) {
            const int k = std::countr_zero(mask);
            if ((world.items[block.item[k]].visible & kinds) == 0) continue;
            const glm::dvec3 center(block.x[k], block.y[k], block.z[k]);
            query.solid(block.item[k], asked, [&](int i) {
                const auto inverse_a = lanes::Double::load_aligned(rays.inverse_a.data() + i);
                lanes::Intervals out;
                out.met = sphere_interval(lanes::difference(rays.origins(i), center), rays.directions(i), inverse_a,
                                          lanes::Double(block.radius[k]), out);
                return out;
            });
        }
    }

    /// Of rays that go each its own way: the spheres of the block in lanes.
    void spheres(const SphereBlock& block, RayMask mask) const
    {
        constexpr int kFewest = 5;  // to go in lanes, a sphere at a time
        if (beam != nullptr && std::popcount(mask) >= kFewest) return spheres_in_beam(block, mask);
        each_ray(mask, [&](std::size_t k) {
            alignas(64) double near[8], far[8];
            const Ray ray = rays.ray(static_cast<int>(k));
            for (std::uint32_t met = sphere_block(block, ray, near, far); met != 0; met &= met - 1) {
                const auto s = static_cast<std::size_t>(std::countr_zero(met));
                const std::uint32_t index = block.item[s];
                if (!(near[s] <= far[s]) || (world.items[index].visible & kinds) == 0) continue;
                const PartId solid = world.items[index].solid;
                const SurfaceId surface = world.store.surface(solid);
                if (near[s] >= rays.t_min[k] && near[s] <= rays.limit[k]) {
                    query.hit(index, k, {near[s], surface, solid, 0, false});
                    if (query.first_only(world.items[index])) continue;
                }
                if (far[s] >= rays.t_min[k] && far[s] <= rays.limit[k])
                    query.hit(index, k, {far[s], surface, solid, 0, false});
            }
        });
    }

    void each(std::uint32_t item, int ray) const
    {
        if ((world.items[item].visible & kinds) != 0 && !(rays.limit[static_cast<std::size_t>(ray)] < 0.0))
            query.each(item, ray);
    }
};

}  // namespace csg
