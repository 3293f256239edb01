#include "render/plan/geometry/geometry.h"

#include "csg/mesh/mesh_edges.h"

#include <algorithm>
#include <utility>

// Objects that many statements show are compiled once, into a world of their own (docs/instances.md).
namespace plan {
namespace {

/// So many are compiled each for itself before the rest share one: fewer cost little, and a shared world is asked ray
/// by ray.
constexpr std::size_t kFewest = 256;
/// Objects of fewer solids take little more room than an instance does.
constexpr std::size_t kSmallest = 8;

/// Copies of large objects share theirs as soon as they would be so many solids: some 100 MB, and half a second.
constexpr std::size_t kMostFlat = 1u << 18;

std::size_t solids_of(const scene::Csg& csg)
{
    std::size_t count = 0;
    for (const scene::Object& operand : *csg.operands) {
        const auto* inner = std::get_if<scene::Csg>(&operand.shape);
        count += inner != nullptr ? solids_of(*inner) : is_light(operand) ? 0 : 1;
    }
    return count;
}

/// Whether some solid looks at the scene's own axes or lengths: an inside_vector does not turn with its mesh (where
/// none was written any does), and what tells crossings beside its surface does so by a length of the scene.
bool tied_to_scene(const csg::SolidStore& store)
{
    const auto& meshes = store.all<csg::Mesh>();
    const auto& freeforms = store.all<csg::Freeform>();
    return std::any_of(
               meshes.begin(), meshes.end(),
               [](const csg::Mesh& mesh) { return mesh.solid() && mesh.inside_vector != csg::kAnyInsideVector; }) ||
           std::any_of(freeforms.begin(), freeforms.end(),
                       [](const csg::Freeform& solid) { return solid.has_open_surface(); });
}

}  // namespace

bool GeometryCompiler::add_instance(const scene::Object& object, const Inherited& own)
{
    const auto& csg = std::get<scene::Csg>(object.shape);
    if (sharing_ != nullptr || object.inverse || csg.cutaway_textures || !object.details->clipped_by.empty() ||
        !object.details->bounded_by.empty())
        return false;
    if (own.photon_density > 0.0) return false;  // each of its parts may be a target of its own
    // A sphere that shows its own coordinates is stored otherwise; whether an inner texture is asked in shadows of a
    // mesh hangs on its other textures.
    if (own.uv_mapping || uv_use_.of((own.texture ? own.texture : default_texture_).texture) || own.interior_texture)
        return false;
    Shared& shared = shared_[{csg.operands.get(), static_cast<int>(csg.op)}];
    shared.operands = csg.operands;
    if (++shared.shown == 2) shared.solids = solids_of(csg);
    const bool flat = shared.shown <= kFewest && shared.shown * shared.solids <= kMostFlat;
    if (flat || shared.fails) return false;
    if (!shared.world) make_shared_world(object, shared);
    if (shared.fails) return false;
    object_ = add_object(object, own);
    const std::uint32_t first_copy = interior_copy_count_;
    interior_copy_count_ += shared.interior_copies;
    std::vector<csg::SurfaceId> surfaces;
    for (const SharedSurface& known : shared.surfaces) {
        Inherited here = own;
        const auto in_world = [&](const PlacedTexture& there) {
            return known.own.uv_mapping ? there : moved(there.texture, own.to_world);
        };
        if (known.own.texture) here.texture = in_world(known.own.texture);
        if (known.own.interior_texture) here.interior_texture = in_world(known.own.interior_texture);
        if (known.own.interior) {
            here.interior = moved(known.own.interior, own.to_world);
            here.interior_copy = first_copy + known.own.interior_copy - shared.first_interior_copy;
        }
        if (known.own.hollow) here.hollow = known.own.hollow;
        if (known.own.importance) here.importance = known.own.importance;
        here.double_illuminate |= known.own.double_illuminate;
        here.uv_mapping = known.own.uv_mapping;
        surfaces.push_back(surface(here, {in_world(known.corners[0]), in_world(known.corners[1])}));
    }
    world_->add_instance(shared.world, own.to_world, surfaces, object_, visible(own));
    add_guard(object, own);
    return true;
}

void GeometryCompiler::make_shared_world(const scene::Object& object, Shared& shared)
{
    shared.fails = shared.solids < kSmallest;
    if (shared.fails) return;
    auto world = std::make_shared<csg::WorldData>();
    csg::WorldData* const outside = std::exchange(world_, world.get());
    const OuterBounds outer_bounds = std::exchange(outer_bounds_, {});
    sharing_ = &shared;
    scene::Object bare;
    bare.shape = object.shape;
    shared.first_interior_copy = interior_copy_count_;
    add_top(bare, {});
    shared.interior_copies = interior_copy_count_ - shared.first_interior_copy;
    sharing_ = nullptr;
    world_ = outside;
    outer_bounds_ = outer_bounds;
    world->surface_opaque.assign(shared.surfaces.size(), 1);
    world->finish();
    shared.fails = shared.fails || !world->unbounded.empty() || !world->bvh.bounds.finite() ||
                   world->visible_everywhere != visible({}) || tied_to_scene(world->store);
    if (!shared.fails) shared.world = std::move(world);
}

csg::SurfaceId GeometryCompiler::shared_surface(const Inherited& own, const std::array<PlacedTexture, 2>& corners,
                                                bool has_parts)
{
    sharing_->fails |= has_parts;  // their textures are compiled already, and in one place
    const std::uint32_t flags = (own.no_shadow ? 1u : 0u) | (own.no_image ? 2u : 0u) | (own.no_reflection ? 4u : 0u) |
                                (own.no_radiosity ? 8u : 0u) | (own.double_illuminate ? 16u : 0u) |
                                (own.uv_mapping ? 32u : 0u);
    const auto [known, fresh] =
        sharing_->known.try_emplace({{own.texture, own.interior_texture, corners[0], corners[1]},
                                     own.interior.get(),
                                     own.interior_copy,
                                     own.hollow,
                                     own.importance,
                                     flags},
                                    static_cast<csg::SurfaceId>(sharing_->surfaces.size()));
    if (fresh) sharing_->surfaces.push_back({own, corners});
    // Of several the last one stays, and the order of all parts is not kept here.
    if (fresh && has_old_finish(own.texture.texture.get())) sharing_->fails |= sharing_->old_finishes++ != 0;
    return known->second;
}

}  // namespace plan
