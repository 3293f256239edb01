#pragma once

#include "csg/solids/shared/slab.h"
#include "csg/tree/front.h"
#include "csg/base/hit.h"
#include "numbers/lanes.h"
#include "csg/solids/solid_crossings.h"
#include "csg/base/tolerance.h"
#include "csg/items/world_data.h"

/// One item against one ray.
namespace csg {

inline Hit hit_of(const SolidStore& store, const Crossing& c)
{
    return {c.t, store.surface(c.part, c.face), c.part, c.face, c.inverted};
}

/// Of the solid that a part is.
template <class F>
inline void solid_crossings(const SolidStore& store, PartId part, const Ray& ray, double t_min, double t_max,
                            bool nearest_only, F&& f)
{
    with_solid(store, part, [&](const auto& solid) { solid_crossings(solid, ray, t_min, t_max, nearest_only, f); });
}

/// Whether an inverted solid's normal is turned: a quadric's is negated twice (spec 5a, 2.5), a patch ignores inversion
/// (spec 5b, 1.1; meshes do not).
inline bool normal_flipped(const WorldData& world, const WorldItem& item)
{
    if (!item.inverted || kind_of(item.solid) == SolidKind::Quadric || kind_of(item.solid) == SolidKind::Triangle)
        return false;
    return kind_of(item.solid) != SolidKind::Freeform || !world.store.all<Freeform>()[index_of(item.solid)].surface();
}

/// The nearest face of a mesh in [t_min, t_max].
inline Hit mesh_nearest(const SolidStore& store, PartId part, const Ray& ray, double t_min, double t_max)
{
    const Mesh& mesh = store.all<Mesh>()[index_of(part)];
    Hit best;
    mesh_crossings(*mesh.shape, local_ray(mesh.frame, ray), t_min, t_max, [&](double t, std::uint32_t face) {
        if (face_comes_first(t, face, best.t, best.face)) {
            best.t = t;
            best.face = face;
        }
        return best.t;
    });
    if (!(best.t < kInfinity)) return {};
    best.part = part;
    best.surface = mesh.surface(best.face);
    return best;
}

/// Whether a bound is a convex solid whose inside the ray meets between t_min and end.
inline bool surely_met(const Program& bound, const SolidStore& store, const Ray& ray, double t_min, double end)
{
    if (bound.nodes.size() != 1 || bound.nodes[0].inverted) return false;
    return with_solid(store, bound.nodes[0].solid, [&](const auto& solid) {
        Interval in;
        if constexpr (requires { solid.interval(ray, in); })
            return solid.interval(ray, in) && in.exit >= t_min && in.entry <= end;
        else return false;
    });
}

/// Whether a ray is let through to an item: it meets every bound at or beyond t_min, or starts inside. `end`: infinite,
/// for a ray meets them however far off; a shadow ray's own end, for it may come from the light or go there.
inline bool passes(const WorldData& world, const WorldItem& item, const Ray& ray, double t_min, double end,
                   Scratch& scratch)
{
    if (item.guard == WorldItem::kNoGuard) return true;
    const BoundingGuard& guard = world.guards[item.guard];
    if (guard.shadows_pass && end < kInfinity) return true;
    Interval in_box{t_min, end};
    if (!narrow(in_box, ray, guard.box.lower, guard.box.upper)) return false;
    for (const std::uint32_t p : guard.programs) {
        const Program& bound = world.programs[p];
        if (surely_met(bound, world.store, ray, t_min, end)) continue;
        bool met = false;
        for (const Span& span : inside_spans(bound, world.store, ray, scratch))
            met = met || (span.out.t >= t_min && span.in.t <= end);
        // Where there is no inside, it is drawn all the same.
        if (!met && nearest_visible(bound, world.store, ray, t_min, end, scratch).part == kNoPart) return false;
    }
    return true;
}

/// How far a ray goes before it is in the guard's box; infinite if it never is.
inline double box_entry(const BoundingGuard& guard, const Ray& ray, double t_min)
{
    Interval in_box{t_min, kInfinity};
    return narrow(in_box, ray, guard.box.lower, guard.box.upper) ? in_box.entry : kInfinity;
}

/// Whether a hit of an item lies before the box of its ordered guard: what is between may hide it
/// (World::first_in_order).
inline bool before_box(const WorldData& world, std::uint32_t item, const Ray& ray, double t_min, double t)
{
    const std::uint32_t guard = world.items[item].guard;
    return guard != WorldItem::kNoGuard && world.guards[guard].ordered &&
           t < box_entry(world.guards[guard], ray, t_min);
}

/// The same two questions of an instance (world.cpp). Those of a tile (world_tiles.cpp) turn its rays into the
/// instance's space; the second is for instances whose surfaces are opaque, all of them.
void instance_nearest(const WorldData& world, const WorldItem& item, RayTile& rays, Scratch& scratch, HitTile& out);
void instance_shadow(const WorldData& world, const WorldItem& item, RayTile& rays, Scratch& scratch, Shadow* out);
Hit instance_nearest(const WorldData& world, const WorldItem& item, const Ray& ray, double t_min, double t_max,
                     Scratch& scratch);
void instance_crossings(const WorldData& world, const WorldItem& item, const Ray& ray, double t_min, double t_max,
                        Scratch& scratch, std::vector<Hit>& out);

/// The nearest crossing of an item in [t_min, t_max]; at equal t the last generated (spec 5a, 2.1). `slabs` of the ray,
/// if they are known. `end`: as of passes().
inline Hit item_nearest(const WorldData& world, const WorldItem& item, const Ray& ray, double t_min, double t_max,
                        Scratch& scratch, const RaySlabs* slabs = nullptr, double end = kInfinity)
{
    if (!passes(world, item, ray, t_min, end, scratch)) return {};
    if (item.instance != Hit::kNoInstance) return instance_nearest(world, item, ray, t_min, t_max, scratch);
    if (item.solid == kNoPart) {
        const Crossing c =
            nearest_visible(world.programs[item.program], world.store, ray, t_min, t_max, scratch, slabs);
        if (c.part == kNoPart || !(c.t <= t_max)) return {};
        return hit_of(world.store, c);
    }
    if (kind_of(item.solid) == SolidKind::Mesh) {
        Hit hit = mesh_nearest(world.store, item.solid, ray, t_min, t_max);
        hit.inverted = item.inverted;
        return hit;
    }
    double nearest = kInfinity, limit = t_max;
    std::uint32_t side = 0;
    solid_crossings(world.store, item.solid, ray, t_min, t_max, true, [&](double t, std::uint32_t face) {
        if (t > limit) return;
        nearest = limit = t;
        side = face;
    });
    if (!(nearest <= t_max && nearest < kInfinity)) return {};
    return {nearest, world.store.surface(item.solid), item.solid, side, normal_flipped(world, item)};
}

/// All crossings of an item in [t_min, t_max], a shadow ray's whole range, in any order: f(Hit).
template <class F>
inline void item_crossings(const WorldData& world, const WorldItem& item, const Ray& ray, double t_min, double t_max,
                           Scratch& scratch, const RaySlabs* slabs, F&& f)
{
    if (!passes(world, item, ray, t_min, t_max, scratch)) return;
    if (item.instance != Hit::kNoInstance) {
        std::vector<Hit>& hits = scratch.instance_hits();  // instances hold none
        hits.clear();
        instance_crossings(world, item, ray, t_min, t_max, scratch, hits);
        for (const Hit& hit : hits) f(hit);
        return;
    }
    if (item.solid == kNoPart) {
        each_crossing(world.programs[item.program], world.store, ray, t_min, t_max, scratch, slabs,
                      [&](const Crossing& c) { f(hit_of(world.store, c)); });
        return;
    }
    solid_crossings(world.store, item.solid, ray, t_min, t_max, false, [&](double t, std::uint32_t face) {
        f(Hit{t, world.store.surface(item.solid, face), item.solid, face, normal_flipped(world, item)});
    });
}

/// What an item has in a shadow ray's way: blocked() if it is opaque all over and met, else f(Hit) of each crossing.
template <class Blocked, class F>
inline void item_in_the_way(const WorldData& world, const WorldItem& item, const Ray& ray, double t_min, double t_max,
                            Scratch& scratch, const RaySlabs* slabs, Blocked&& blocked, F&& f)
{
    if (!item.all_opaque) return item_crossings(world, item, ray, t_min, t_max, scratch, slabs, f);
    if (item_nearest(world, item, ray, t_min, t_max, scratch, slabs, t_max).found()) blocked();
}

/// Items that a ray meets in one place: the first in order, and another.
struct Tie {
    std::uint32_t item, other;
    static constexpr std::uint32_t kSeveral = 0xffffffffu;  ///< there is more than one other
};

/// What a ray keeps while it meets items: the nearest so far, and in the same place the first in order.
struct Nearest {
    Hit hit;
    std::uint32_t item = 0xffffffffu;
    double limit = kInfinity;   ///< nothing beyond matters
    double nearer = kInfinity;  ///< before this nothing is in the same place
    double reach = 0.0;         ///< of the ray's origin
    bool tied = false;          ///< something else lies in the same place,
    std::uint32_t other = 0;    ///< this item (Tie)

    Nearest(const Ray& ray, double t_max) : limit(t_max), reach(reach_of(ray.origin)) {}

    static double reach_of(const glm::dvec3& origin)
    {
        const glm::dvec3 size = glm::abs(origin);
        return std::max(size.x, std::max(size.y, size.z));
    }
    void offer(const Hit& found, std::uint32_t from)
    {
        if (!found.found() || found.t > limit) return;
        const bool beside = !(found.t < nearer);
        if (beside) other = tied ? Tie::kSeveral : std::max(from, item);
        tied = beside;
        if (!beside || from < item) {
            hit = found;
            item = from;
            const double room = Tolerance::same_place(found.t, reach);
            limit = std::min(limit, found.t + room);
            nearer = found.t - room;
        }
    }
};

/// Entry and exit of a ray and the spheres of a block, eight at a time. A bit per sphere that is met; misses leave
/// anything in `near` and `far`.
inline std::uint32_t sphere_block(const SphereBlock& block, const Ray& ray, double* near, double* far)
{
    using lanes::Double;
    const lanes::Directions direction{Double(ray.direction.x), Double(ray.direction.y), Double(ray.direction.z)};
    const Double inverse(1.0 / glm::dot(ray.direction, ray.direction));
    std::uint32_t mask = 0;
    for (int at = 0; at < 8; at += lanes::kDoubles) {
        const auto load = [at](const double* from) { return Double::load_aligned(from + at); };
        const lanes::Points center{load(block.x), load(block.y), load(block.z)};
        const Double radius = load(block.radius);
        EndsOf<Double> ends;
        const auto met = sphere_interval(lanes::difference(ray.origin, center), direction, inverse, radius, ends);
        ends.entry.store_aligned(near + at);
        ends.exit.store_aligned(far + at);
        mask |= lanes::mask(met & (radius > Double(0.0))) << at;
    }
    return mask;
}

}  // namespace csg
