#include "csg/world/world.h"

#include "csg/items/spawn_epsilon.h"
#include "csg/items/last_bits.h"
#include "csg/items/depth_range.h"
#include "csg/packet/tile_crossings.h"
#include "csg/bvh/traverse.h"
#include "csg/items/instance_ray.h"
#include "csg/items/world_item.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace csg {
namespace {

/// What a leaf block means to a query: calls each(item index) for the members that must be asked one by one, and
/// sphere(item index, near, far) for spheres already intersected.
template <class Each, class EachSphere>
inline void open_block(const WorldData& world, ChildWord leaf, const Ray& ray, Each&& each, EachSphere&& sphere)
{
    switch (leaf.kind()) {
    case LeafKind::Item: each(leaf.index()); return;
    case LeafKind::Triangles:
        for (std::uint32_t k = world.bvh.triangle_first[leaf.index()]; k < world.bvh.triangle_first[leaf.index() + 1];
             ++k) {
            const std::uint32_t item = world.bvh.triangle_members[k];
            double t = 0.0;
            if (world.store.all<Triangle>()[index_of(world.items[item].solid)].crossing(ray, t)) each(item);
        }
        return;
    case LeafKind::Spheres: {
        alignas(64) double near[8], far[8];
        const SphereBlock& block = world.spheres[leaf.index()];
        for (std::uint32_t mask = sphere_block(block, ray, near, far); mask != 0; mask &= mask - 1) {
            const int k = std::countr_zero(mask);
            if (near[k] <= far[k]) sphere(block.item[k], near[k], far[k]);
        }
        return;
    }
    }
}

/// One shadow ray: how it ends, and keep(hit) for every crossing of a transparent surface until an opaque one is met.
template <class Keep>
inline Shadow shadow_walk(const WorldData& world, const Ray& ray, double t_min, double t_max, Scratch& scratch,
                          Keep&& keep)
{
    scratch.cancel.look();
    Shadow found = Shadow::Clear;
    const RaySlabs slabs(ray);
    const auto take = [&](const Hit& hit) {
        if (world.faithful && !depth_range_of(world, hit).holds(hit.t)) return;
        if (world.surface_opaque[hit.surface] != 0) {
            found = Shadow::Blocked;
        } else {
            if (found == Shadow::Clear) found = Shadow::Filtered;
            keep(hit);
        }
    };
    const auto each = [&](std::uint32_t i) {
        const WorldItem& item = world.items[i];
        if ((item.visible & world.shadow_kinds) == 0) return;
        if (world.faithful) return item_crossings(world, item, ray, t_min, t_max, scratch, &slabs, take);
        item_in_the_way(
            world, item, ray, t_min, t_max, scratch, &slabs, [&] { found = Shadow::Blocked; }, take);
    };
    const auto sphere = [&](std::uint32_t i, double near, double far) {
        const WorldItem& item = world.items[i];
        if ((item.visible & world.shadow_kinds) == 0) return;
        const SurfaceId surface = world.store.surface(item.solid);
        if (near >= t_min && near <= t_max) take({near, surface, item.solid, 0, false});
        if (far >= t_min && far <= t_max) take({far, surface, item.solid, 0, false});
    };
    for (const std::uint32_t i : world.unbounded) {
        each(i);
        if (found == Shadow::Blocked) return found;
    }
    traverse(world.bvh, slabs, t_min, t_max, world.shadow_kinds, [&](ChildWord leaf) {
        open_block(world, leaf, ray, each, sphere);
        return found == Shadow::Blocked ? -1.0 : t_max;
    });
    return found;
}

/// As its own world knows it, at the start of the ray.
Hit alone(const Hit& hit)
{
    Hit own = hit;
    own.t = 0.0;
    own.instance = Hit::kNoInstance;
    return own;
}

/// Offers `best` the spheres of blocks, and asks each(item) for all other items that the ray comes near.
template <class Each>
inline void walk_nearest(const WorldData& world, const Ray& ray, const RaySlabs& slabs, double t_min,
                         std::uint8_t kind_bit, Nearest& best, Each&& each)
{
    const auto sphere = [&](std::uint32_t i, double near, double far) {
        const WorldItem& item = world.items[i];
        const double t = near >= t_min ? near : far;
        if (t < t_min || t > best.limit || (item.visible & kind_bit) == 0) return;
        best.offer({t, world.store.surface(item.solid), item.solid, 0, false}, i);
    };
    for (const std::uint32_t i : world.unbounded) each(i);
    traverse(world.bvh, slabs, t_min, best.limit, kind_bit, [&](ChildWord leaf) {
        open_block(world, leaf, ray, each, sphere);
        return best.limit;
    });
}

/// drawn_bounds(), of spheres without what keeps rounding off: as large as POV-Ray's box of one.
Aabb unpadded_bounds(const WorldData& world, const WorldItem& item)
{
    if (item.solid == kNoPart || kind_of(item.solid) != SolidKind::Sphere) return drawn_bounds(world, item);
    const Sphere& sphere = world.store.all<Sphere>()[index_of(item.solid)];
    return {sphere.center - glm::dvec3(sphere.radius), sphere.center + glm::dvec3(sphere.radius)};
}

/// Whether it can't be seen which of the hits is shown: balls and cylinders that make up a surface meet all along it.
bool look_alike(const WorldData& world, const std::vector<Hit>& hits, const glm::dvec3& point)
{
    constexpr double kTurned = 1e-12;
    const auto look = [&](const Hit& hit) {
        return hit.surface < world.surface_look.size() ? world.surface_look[hit.surface] : WorldData::kNoLook;
    };
    const auto normal = [&](const Hit& hit) { return normal_at(world.store, hit.part, hit.face, hit.inverted, point); };
    const std::uint32_t first = look(hits[0]);
    const auto own = [](const Hit& hit) { return hit.instance == Hit::kNoInstance; };
    if (first == WorldData::kNoLook || !std::all_of(hits.begin(), hits.end(), own)) return false;
    const glm::dvec3 n = normal(hits[0]);
    return std::all_of(hits.begin() + 1, hits.end(),
                       [&](const Hit& hit) { return look(hit) == first && glm::dot(normal(hit), n) > 1.0 - kTurned; });
}

}  // namespace

Hit instance_nearest(const WorldData& world, const WorldItem& item, const Ray& ray, double t_min, double t_max,
                     Scratch& scratch)
{
    const Instance& one = world.instances[item.instance];
    const LocalRay local(one, ray);
    const Hit hit = World(*one.world).nearest(local.ray, t_min * local.length, t_max * local.length, 0xff, scratch);
    return hit.found() ? here(world, item, local.length, hit, t_min, t_max) : hit;
}

void instance_crossings(const WorldData& world, const WorldItem& item, const Ray& ray, double t_min, double t_max,
                        Scratch& scratch, std::vector<Hit>& out)
{
    const Instance& one = world.instances[item.instance];
    const LocalRay local(one, ray);
    const double from = t_min * local.length, to = t_max * local.length;
    const RaySlabs slabs(local.ray);
    const auto keep = [&](const Hit& hit) { out.push_back(here(world, item, local.length, hit, t_min, t_max)); };
    const auto each = [&](std::uint32_t i) {
        item_crossings(*one.world, one.world->items[i], local.ray, from, to, scratch, &slabs, keep);
    };
    const auto sphere = [&](std::uint32_t i, double near, double far) {
        const PartId solid = one.world->items[i].solid;
        for (const double t : {near, far})
            if (t >= from && t <= to) keep({t, one.world->store.surface(solid), solid, 0, false});
    };
    traverse(one.world->bvh, slabs, from, to, 0xff, [&](ChildWord leaf) {
        open_block(*one.world, leaf, local.ray, each, sphere);
        return to;
    });
}

Hit World::nearest(const Ray& ray, double t_min, double t_max, std::uint8_t kind_bit, Scratch& scratch) const
{
    const Hit hit = first(ray, t_min, t_max, kind_bit, scratch);
    if (data_->faithful && hit.found() && !depth_range_of(*data_, hit).holds(hit.t))
        return first_in_reach(ray, t_min, t_max, kind_bit, scratch);
    return hit;
}

/// Of all crossings those that count, as none before them does.
Hit World::first_in_reach(const Ray& ray, double t_min, double t_max, std::uint8_t kind_bit, Scratch& scratch) const
{
    const WorldData& world = *data_;
    const RaySlabs slabs(ray);
    Nearest best(ray, t_max);
    const auto offer = [&](const Hit& hit, std::uint32_t i) {
        if (depth_range_of(world, hit).holds(hit.t)) best.offer(hit, i);
    };
    const auto each = [&](std::uint32_t i) {
        const WorldItem& item = world.items[i];
        if ((item.visible & kind_bit) != 0)
            item_crossings(world, item, ray, t_min, best.limit, scratch, &slabs,
                           [&](const Hit& hit) { offer(hit, i); });
    };
    const auto sphere = [&](std::uint32_t i, double near, double far) {
        const WorldItem& item = world.items[i];
        if ((item.visible & kind_bit) == 0) return;
        for (const double t : {near, far})
            if (t >= t_min) offer({t, world.store.surface(item.solid), item.solid, 0, false}, i);
    };
    for (const std::uint32_t i : world.unbounded) each(i);
    traverse(world.bvh, slabs, t_min, best.limit, kind_bit, [&](ChildWord leaf) {
        open_block(world, leaf, ray, each, sphere);
        return best.limit;
    });
    return best.hit;
}

/// As first(), but items with ordered guards are asked after all others, in the order of their boxes along the ray, up
/// to the nearest hit.
Hit World::first_in_order(const Ray& ray, double t_min, double t_max, std::uint8_t kind_bit, Scratch& scratch) const
{
    const WorldData& world = *data_;
    const RaySlabs slabs(ray);
    Nearest best(ray, t_max);
    const auto ask = [&](std::uint32_t i) {
        best.offer(item_nearest(world, world.items[i], ray, t_min, best.limit, scratch, &slabs), i);
    };
    const auto each = [&](std::uint32_t i) {
        const WorldItem& item = world.items[i];
        if ((item.visible & kind_bit) != 0 && !(item.guard != WorldItem::kNoGuard && world.guards[item.guard].ordered))
            ask(i);
    };
    walk_nearest(world, ray, slabs, t_min, kind_bit, best, each);
    std::vector<OrderedItem> waiting =
        std::exchange(scratch.ordered_items(), {});  // an instance's world wants one, too
    waiting.clear();
    for (const std::uint32_t i : world.ordered)
        if (const double entry = box_entry(world.guards[world.items[i].guard], ray, t_min);
            (world.items[i].visible & kind_bit) != 0 && entry <= best.limit)
            waiting.push_back({entry, i});
    std::sort(waiting.begin(), waiting.end(), [](const OrderedItem& a, const OrderedItem& b) {
        return a.entry != b.entry ? a.entry < b.entry : a.item < b.item;
    });
    std::vector<std::uint32_t> together;
    for (auto next = waiting.begin(); next != waiting.end() && next->entry <= best.limit;) {
        const double entry = next->entry;
        together.clear();
        for (; next != waiting.end() && next->entry == entry; ++next) together.push_back(next->item);
        if (together.size() > 1 && world.test_order) test_order().arrange(ray, together);
        for (const std::uint32_t i : together)
            if (entry <= best.limit) ask(i);
    }
    scratch.ordered_items() = std::move(waiting);
    return best.hit;
}

Hit World::first(const Ray& ray, double t_min, double t_max, std::uint8_t kind_bit, Scratch& scratch) const
{
    const WorldData& world = *data_;
    scratch.cancel.look();
    const RaySlabs slabs(ray);
    Nearest best(ray, t_max);
    const auto each = [&](std::uint32_t i) {
        const WorldItem& item = world.items[i];
        if ((item.visible & kind_bit) != 0)
            best.offer(item_nearest(world, item, ray, t_min, best.limit, scratch, &slabs), i);
    };
    walk_nearest(world, ray, slabs, t_min, kind_bit, best, each);
    if (!world.ordered.empty() && best.hit.found() && before_box(world, best.item, ray, t_min, best.hit.t))
        return first_in_order(ray, t_min, t_max, kind_bit, scratch);
    if (best.tied && world.test_order)
        return first_tested(ray, t_min, kind_bit, scratch, best.hit, {best.item, best.other});
    return best.hit;
}

/// The order of a world that has one.
const TestOrder& World::test_order() const
{
    return data_->test_order->made([this] {
        const LazyTestOrder& told = *data_->test_order;
        std::vector<TestOrder::Box> boxes;
        std::vector<std::uint32_t> whole(data_->items.size());
        auto known = told.boxes.begin();
        auto many = told.wholes.begin();
        for (std::uint32_t i = 0; i < whole.size();) {
            const bool several = many != told.wholes.end() && many->first == i;
            const std::uint32_t end = several ? many->end : i + 1;
            TestOrder::Box box;
            if (several) box = many++->box;
            else if (known != told.boxes.end() && known->first == i) box = known->second;
            else box = TestOrder::Box::of(unpadded_bounds(*data_, data_->items[i]));
            while (known != told.boxes.end() && known->first < end) ++known;
            for (; i < end; ++i) whole[i] = static_cast<std::uint32_t>(boxes.size());
            boxes.push_back(box);
        }
        return TestOrder(boxes, told.by, std::move(whole));
    });
}

/// Of all that lies in the place of the nearest hit, what POV-Ray asks first.
Hit World::first_tested(const Ray& ray, double t_min, std::uint8_t kind_bit, Scratch& scratch, const Hit& nearest,
                        const Tie& tie) const
{
    const WorldData& world = *data_;
    const RaySlabs slabs(ray);
    const double room = Tolerance::same_place(nearest.t, Nearest::reach_of(ray.origin)), limit = nearest.t + room;
    std::vector<std::uint32_t>& items = scratch.tied_items();
    std::vector<Hit>& hits = scratch.tied_hits();
    items.clear();
    hits.clear();
    const auto offer = [&](const Hit& hit, std::uint32_t i) {
        if (!hit.found() || hit.t < nearest.t - room || hit.t > limit) return;
        items.push_back(i);
        hits.push_back(hit);
    };
    const auto each = [&](std::uint32_t i) {
        if ((world.items[i].visible & kind_bit) != 0)
            offer(item_nearest(world, world.items[i], ray, t_min, limit, scratch, &slabs), i);
    };
    const auto sphere = [&](std::uint32_t i, double near, double far) {
        const WorldItem& item = world.items[i];
        if ((item.visible & kind_bit) != 0)
            offer({near >= t_min ? near : far, world.store.surface(item.solid), item.solid, 0, false}, i);
    };
    if (tie.other != Tie::kSeveral) {
        offer(nearest, tie.item);
        each(tie.other);
    } else {
        for (const std::uint32_t i : world.unbounded) each(i);
        traverse(world.bvh, slabs, t_min, limit, kind_bit, [&](ChildWord leaf) {
            open_block(world, leaf, ray, each, sphere);
            return limit;
        });
    }
    if (items.size() < 2 || look_alike(world, hits, ray.at(nearest.t))) return nearest;
    const std::uint32_t first = test_order().first(ray, items);
    return hits[static_cast<std::size_t>(std::find(items.begin(), items.end(), first) - items.begin())];
}

bool World::too_far(const Hit& hit) const { return hit.t > depth_range_of(*data_, hit).to; }

HitDetails World::details(const Ray& ray, const Hit& hit, bool with_uv) const
{
    HitDetails out;
    out.point = ray.at(told_depth(data_->store, ray, hit, data_->told));
    if (hit.instance != Hit::kNoInstance) {
        const Instance& one = data_->instances[hit.instance];
        const glm::dvec3 p = one.frame.inverse_point(out.point);
        const HitDetails local = World(*one.world).details({p, glm::dvec3(0.0)}, alone(hit), false);
        out.normal = unit_or_x(one.frame.normal(local.normal));
        out.weights = local.weights;
        if (with_uv) out.uv = uv_at(one.world->store, hit.part, hit.face, p, out.point);
        return out;
    }
    out.normal = told_normal(data_->store, hit, out.point, data_->told);
    if (with_uv) out.uv = uv_at(data_->store, hit.part, hit.face, out.point, out.point);
    if (kind_of(hit.part) == SolidKind::Mesh) {
        const Mesh& mesh = data_->store.all<Mesh>()[index_of(hit.part)];
        if (mesh.blends) out.weights = glm::vec3(mesh.weights(out.point, hit.face));
    }
    return out;
}

double World::spawn_distance(const Ray& ray, const Hit& hit, double incidence, bool inward, double usual) const
{
    if (data_->faithful) return usual;
    if (hit.instance != Hit::kNoInstance) {
        const Instance& one = data_->instances[hit.instance];
        const LocalRay local(one, ray);
        Hit own = alone(hit);
        own.t = hit.t * local.length;
        return World(*one.world).spawn_distance(local.ray, own, incidence, inward, usual * local.length) / local.length;
    }
    return with_solid(data_->store, hit.part,
                      [&](const auto& solid) { return spawn_epsilon(solid, ray, hit.t, incidence, inward, usual); });
}

void World::shares(const Hit& hit, const glm::dvec3& point, std::vector<Share>& out) const
{
    if (hit.instance != Hit::kNoInstance) {
        const Instance& one = data_->instances[hit.instance];
        return World(*one.world).shares(alone(hit), one.frame.inverse_point(point), out);
    }
    if (kind_of(hit.part) == SolidKind::Freeform) data_->store.all<Freeform>()[index_of(hit.part)].shares(point, out);
}

Shadow World::shadow(const Ray& ray, double t_min, double t_max, Scratch& scratch) const
{
    return shadow_walk(*data_, ray, t_min, t_max, scratch, [](const Hit&) {});
}

Shadow World::shadow_crossings(const Ray& ray, double t_min, double t_max, Scratch& scratch,
                               std::vector<Hit>& out) const
{
    out.clear();
    const Shadow found = shadow_walk(*data_, ray, t_min, t_max, scratch, [&](const Hit& hit) { out.push_back(hit); });
    if (found != Shadow::Filtered) return found;
    sort_crossings(out.data(), out.size());
    return found;
}

bool World::seen_by_all(std::uint8_t kinds) const { return (data_->visible_everywhere & kinds) == kinds; }

}  // namespace csg
