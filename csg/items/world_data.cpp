#include "csg/items/world_data.h"

#include "csg/tree/sphere_bounds.h"

#include <algorithm>
#include <utility>

namespace csg {

Aabb drawn_bounds(const WorldData& world, const WorldItem& item)
{
    if (item.instance != Hit::kNoInstance) {
        const Instance& one = world.instances[item.instance];
        return transformed_box(one.frame, one.world->bvh.bounds);
    }
    if (item.solid == kNoPart) return lens_bounds(world.programs[item.program], world.store);
    if (kind_of(item.solid) == SolidKind::Disc) return world.store.all<Disc>()[index_of(item.solid)].drawn_bounds();
    if (kind_of(item.solid) == SolidKind::Mesh) return world.store.all<Mesh>()[index_of(item.solid)].drawn_bounds();
    if (kind_of(item.solid) == SolidKind::Freeform)
        return world.store.all<Freeform>()[index_of(item.solid)].drawn_bounds();
    return with_solid(world.store, item.solid, [](const auto& solid) { return solid.bounds(); });
}

namespace {

LeafKind leaf_kind(const WorldItem& item)
{
    if (item.solid == kNoPart || item.inverted || item.guard != WorldItem::kNoGuard)
        return LeafKind::Item;  // of an instance too
    switch (kind_of(item.solid)) {
    case SolidKind::Sphere: return LeafKind::Spheres;
    case SolidKind::Triangle: return LeafKind::Triangles;
    default: return LeafKind::Item;
    }
}

bool all_opaque(const WorldData& world, const WorldItem& item)
{
    const auto stops = [&](SurfaceId surface) {
        return surface < world.surface_opaque.size() && world.surface_opaque[surface] != 0;
    };
    const auto opaque = [&](PartId part) {
        if (kind_of(part) != SolidKind::Mesh) return stops(world.store.surface(part));
        const auto& surfaces = world.store.all<Mesh>()[index_of(part)].surfaces;
        return std::all_of(surfaces.begin(), surfaces.end(), stops);
    };
    // Clips have no surface and are not drawn.
    const auto drawn = [&](PartId part) {
        return kind_of(part) == SolidKind::Mesh || world.store.surface(part) != kNoSurface;
    };
    if (item.instance != Hit::kNoInstance) {
        const Instance& one = world.instances[item.instance];
        const auto first = world.instance_surfaces.begin() + one.first_surface;
        return std::all_of(first, first + static_cast<std::ptrdiff_t>(one.world->surface_opaque.size()),
                           [&](SurfaceId surface) { return world.surface_opaque[surface] != 0; });
    }
    if (item.solid != kNoPart) return opaque(item.solid);
    for (const Node& node : world.programs[item.program].nodes)
        if (node.op == Op::Leaf && drawn(node.solid) && !opaque(node.solid)) return false;
    return true;
}

/// Whether some solid of the item answers many rays faster together than one by one.
bool many(const WorldData& world, const WorldItem& item)
{
    const auto solid = [&](PartId part) {
        return part != kNoPart && kind_of(part) == SolidKind::Freeform &&
               world.store.all<Freeform>()[index_of(part)].intersects_many();
    };
    if (item.instance != Hit::kNoInstance) return false;
    if (item.solid != kNoPart) return solid(item.solid) || kind_of(item.solid) == SolidKind::Extrusion;
    const auto& nodes = world.programs[item.program].nodes;
    return std::any_of(nodes.begin(), nodes.end(),
                       [&](const Node& node) { return node.op == Op::Leaf && solid(node.solid); });
}

/// Whether a test of the item is cheap: it then comes before costlier items, which may turn out to lie behind it.
bool quick(const WorldItem& item)
{
    if (item.solid == kNoPart || item.guard != WorldItem::kNoGuard) return false;
    const SolidKind kind = kind_of(item.solid);
    return kind == SolidKind::Box || kind == SolidKind::OrientedBox;
}

void fill_spheres(WorldData& world)
{
    const auto& first = world.bvh.sphere_first;
    for (std::size_t b = 0; b + 1 < first.size(); ++b) {
        SphereBlock block{};
        for (std::uint32_t k = 0; k < 8; ++k) {
            block.radius[k] = -1.0;
            block.item[k] = 0;
            const std::uint32_t member = first[b] + k;
            if (member >= first[b + 1]) continue;
            const std::uint32_t item = world.bvh.sphere_members[member];
            const Sphere& sphere = world.store.all<Sphere>()[index_of(world.items[item].solid)];
            block.x[k] = sphere.center.x;
            block.y[k] = sphere.center.y;
            block.z[k] = sphere.center.z;
            block.radius[k] = sphere.radius;
            block.item[k] = item;
        }
        world.spheres.push_back(block);
    }
}

/// Whether rays that come near a cut of a simple form would go their own way, and the boolean form has lanes for it.
bool cut_by_quadric(const Program& program)
{
    constexpr std::uint32_t kMostCuts = 8;  // the boolean form asks all of them of every ray
    const SumOfProducts& form = program.products;
    const ProductTerm& term = form.terms[0];
    if (!program.boolean.usable() || term.cut_last - term.cut_first > kMostCuts) return false;
    return std::any_of(form.cuts.begin() + term.cut_first, form.cuts.begin() + term.cut_last,
                       [&](const ProductCut& cut) {
                           return cut.count == 1 && kind_of(form.leaves[cut.first].solid) == SolidKind::Quadric;
                       });
}

}  // namespace

void WorldData::add_solid(PartId solid, bool inverted, std::uint32_t object, std::uint8_t visible)
{
    items.push_back({.solid = solid, .object = object, .visible = visible, .inverted = inverted});
}

void WorldData::add_program(Program program, std::uint32_t object, std::uint8_t visible)
{
    items.push_back({.program = static_cast<std::uint32_t>(programs.size()), .object = object, .visible = visible});
    programs.push_back(std::move(program));
}

void WorldData::add_instance(std::shared_ptr<const WorldData> shared, const Transform& frame,
                             const std::vector<SurfaceId>& surfaces, std::uint32_t object, std::uint8_t visible)
{
    items.push_back({.object = object, .visible = visible, .instance = static_cast<std::uint32_t>(instances.size())});
    instances.push_back({std::move(shared), frame, static_cast<std::uint32_t>(instance_surfaces.size())});
    instance_surfaces.insert(instance_surfaces.end(), surfaces.begin(), surfaces.end());
}

/// Only items whose box in POV-Ray may be larger than what is drawn have one; a sphere or triangle about fills its box.
bool WorldData::last_has_test_box()
{
    if (items.size() > LazyTestOrder::kMostItems) test_order = nullptr;
    const WorldItem& item = items.back();
    if (!test_order || item.instance != Hit::kNoInstance) return false;
    return item.solid == kNoPart ||
           (kind_of(item.solid) != SolidKind::Sphere && kind_of(item.solid) != SolidKind::Triangle);
}

void WorldData::test_box_of_last(const Aabb& box)
{
    test_order->boxes.emplace_back(static_cast<std::uint32_t>(items.size() - 1), TestOrder::Box::of(box));
}

void WorldData::test_box_since(std::size_t first, const Aabb& box)
{
    if (!test_order || items.size() == first) return;
    test_order->wholes.push_back(
        {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(items.size()), TestOrder::Box::of(box)});
}

void WorldData::guard_last(BoundingGuard guard)
{
    items.back().guard = static_cast<std::uint32_t>(guards.size());
    guards.push_back(std::move(guard));
}

void WorldData::finish(int threads)
{
    std::vector<BvhInput> inputs;
    for (std::uint32_t i = 0; i < items.size(); ++i) {
        WorldItem& item = items[i];
        item.all_opaque = all_opaque(*this, item);
        item.simple = item.solid == kNoPart && item.instance == Hit::kNoInstance &&
                      programs[item.program].products.simple() && !cut_by_quadric(programs[item.program]);
        item.plain = item.simple && programs[item.program].products.terms[0].plain();
        item.boolean = item.solid == kNoPart && item.instance == Hit::kNoInstance && !item.simple &&
                       programs[item.program].boolean.usable();
        item.many = many(*this, item);
        const bool weighs = item.many && (item.solid == kNoPart || kind_of(item.solid) == SolidKind::Freeform);
        costly = costly || weighs;
        visible_everywhere &= item.visible;
        if (item.guard != WorldItem::kNoGuard) {
            guards[item.guard].shadows_pass &= item.all_opaque;
            if (guards[item.guard].ordered) ordered.push_back(i);
        }
        const Aabb box = drawn_bounds(*this, item);
        if (box.empty() && drop_empty) continue;
        if (weighs) costly_bounds.include(box);
        if (fits_hierarchy(box)) inputs.push_back({box, leaf_kind(item), i, item.visible, quick(item)});
        else unbounded.push_back(i);
    }
    bvh = build_bvh(std::move(inputs), threads);
    fill_spheres(*this);
}

}  // namespace csg
