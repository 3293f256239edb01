#include "render/plan/geometry/geometry.h"

#include "render/plan/geometry/hidden_operands.h"

#include "csg/freeform/freeform.h"
#include "render/plan/camera_starts.h"
#include "render/plan/geometry/extent.h"
#include "render/plan/geometry/light_stops.h"
#include "render/plan/lights.h"
#include "render/plan/compile_photons.h"
#include "render/plan/geometry/solids.h"
#include "render/scene/last_bits.h"

#include <algorithm>
#include <utility>

namespace plan {
namespace {

/// What clips the object: nothing clips a bicubic_patch (spec 5b, 1.6).
const std::vector<scene::Object>& clips_of(const scene::Object& object)
{
    static const std::vector<scene::Object> none;
    const auto* freeform = std::get_if<scene::Freeform>(&object.shape);
    return freeform && std::holds_alternative<csg::BicubicPatch>(freeform->shape->kind) ? none
                                                                                        : object.details->clipped_by;
}

csg::Tree::Op tree_op(scene::CsgOp op)
{
    switch (op) {
    case scene::CsgOp::Union: return csg::Tree::Op::Union;
    case scene::CsgOp::Intersection: return csg::Tree::Op::Intersection;
    case scene::CsgOp::Difference: return csg::Tree::Op::Difference;
    case scene::CsgOp::Merge: return csg::Tree::Op::Merge;
    }
    return csg::Tree::Op::Union;
}

/// What surfaces that look alike have in common (csg::WorldData::surface_look).
std::uint32_t look_of(const Surface& s, const texture::TextureSet& set)
{
    if (s.texture == kNone || set.textures[s.texture].kind != texture::Texture::Kind::Layers)
        return csg::WorldData::kNoLook;
    const bool plain = s.opaque && !s.blends() && s.interior_texture == kNone && !s.double_illuminate &&
                       s.importance == 1.0f && !s.uv_mapping && s.light_group == 0 && s.global_lights && s.photons == 0;
    return plain ? s.texture : csg::WorldData::kNoLook;
}

/// Whether some of its parts are hidden from some rays by themselves.
bool hides_parts(const scene::Csg& csg)
{
    return std::any_of(csg.operands->begin(), csg.operands->end(), [](const scene::Object& operand) {
        const scene::Flags& flags = operand.flags;
        const auto* inner = std::get_if<scene::Csg>(&operand.shape);
        return flags.no_shadow || flags.no_image || flags.no_reflection || (inner != nullptr && hides_parts(*inner));
    });
}

}  // namespace

GeometryCompiler::GeometryCompiler(const scene::Description& description, const Options& options,
                                   TextureCompiler& textures, MediaCompiler& media, CompiledScene& out,
                                   std::vector<scene::Unsupported>& notes)
    : description_(description), options_(options), textures_(textures), out_(out), interiors_(out.interiors, media),
      fields_(description, options, notes), starts_(camera_starts(out.camera, out.mesh_camera.get())),
      photons_(compile_photons(description, options.quality))
{
    const csg::Roundings by = scene::roundings_of(description.povray);
    if (options.last_bits || by == csg::Roundings::V38) out_.geometry.told = by;
    if (!bounding_active()) return;
    out_.geometry.test_order = std::make_shared<csg::LazyTestOrder>();
    out_.geometry.test_order->by = by;
}

void GeometryCompiler::expect(std::size_t statements)
{
    out_.objects.reserve(statements);
    out_.surfaces.reserve(statements);
    out_.geometry.items.reserve(statements);
}

void GeometryCompiler::add(const scene::Object& object)
{
    default_texture_ = {description_.default_of(object)};
    automatic_interior_.reset();
    light_groups_.clear();
    interior_copies_.clear();
    collect_lights(object, {});
    add_top(object, {});
    ++statement_;
}

void GeometryCompiler::finish(int threads)
{
    if (photons_ && !photons_->targets.empty()) out_.photons = photons_;
    if (photons_ && (!photons_->settings.load_file.empty() || !options_.lean.takes(LeanStep::Photons)))
        out_.photons = photons_;
    find_light_stops(out_);
    if (out_.geometry.test_order)
        for (const Surface& s : out_.surfaces) out_.geometry.surface_look.push_back(look_of(s, out_.textures));
    out_.geometry.drop_empty = options_.lean.takes(LeanStep::EmptyObjects);
    out_.geometry.finish(threads);
    drop_unseen_lights();
    tell_decisions();
}

void GeometryCompiler::tell_decisions()
{
    const auto tell = [&](std::uint64_t count, const char* what, const char* why, std::optional<LeanStep> step = {}) {
        if (count != 0) out_.decisions.push_back({std::to_string(count) + " " + what, why, {}, step});
    };
    tell(split_unions_, "unions split into their operands", "nothing at top level needs them as one object");
    tell(pruning_.dropped, "operands of CSG left out", "their boxes do not meet what they cut or add to",
         LeanStep::Operands);
    tell(lost_spheres_, "spheres of negative radius left out", "POV-Ray's boxes of them are inside out");
    tell(empty_programs_, "objects left out", "bounds of their operands leave nothing to draw", LeanStep::EmptyObjects);
    tell(out_.geometry.instances.size(), "copies of objects kept as such", "others before them show the same parts");
    tell(bounds_, "bounded_by left out", "the hierarchy bounds every object itself", LeanStep::Bounds);
    tell(guards_, "bounded_by kept", "they are smaller than what they bound");
    tell(black_lights_, "black lights left out", "they light nothing", LeanStep::BlackLights);
}

/// What `object` hands down to its operands and to its own surface.
GeometryCompiler::Inherited GeometryCompiler::below(const scene::Object& object, const Inherited& above)
{
    Inherited own = above;
    own.uv_mapping = object.flags.uv_mapping || (!object.texture && above.uv_mapping);
    const auto in_world = [&](const scene::TexturePtr& t) {
        return own.uv_mapping ? PlacedTexture{t} : moved(t, above.to_world);
    };
    if (object.texture) own.texture = in_world(object.texture);
    if (object.details->interior_texture) own.interior_texture = in_world(object.details->interior_texture);
    if (object.flags.hollow) own.hollow = object.flags.hollow;
    own.no_shadow = above.no_shadow || shadowless(object);
    own.no_image = above.no_image || object.flags.no_image;
    own.no_reflection = above.no_reflection || object.flags.no_reflection;
    own.no_radiosity = above.no_radiosity || object.flags.no_radiosity;
    if (object.details->radiosity_importance)
        own.importance = static_cast<float>(*object.details->radiosity_importance);
    own.double_illuminate = above.double_illuminate || object.flags.double_illuminate;
    own.to_world = is_light(object) ? above.to_world : above.to_world * *object.transform;
    if (object.details->interior) {
        own.interior = moved(object.details->interior, above.to_world);
        own.interior_copy = interior_copy(*own.interior, own.to_world);
    }
    own.parent_growth = own.growth = above.growth;
    if (const auto* csg = std::get_if<scene::Csg>(&object.shape)) {
        own.growth = *csg->growth;
        own.growth.add(above.growth);
    }
    if (const auto* csg = std::get_if<scene::Csg>(&object.shape); csg != nullptr && csg->light_group) {
        if (above.light_group == 0) own.global_lights = csg->global_lights;  // the outermost group decides
        if (above.light_group == 0 || std::any_of(csg->operands->begin(), csg->operands->end(), is_light))
            own.light_group = light_group(object, own.to_world);
    }
    if (photons_ && object.details->photons) hand_down_photons(object, own);
    return own;
}

GeometryCompiler::Inherited GeometryCompiler::within(const scene::Object& operand, const Inherited& whole)
{
    Inherited own = below(operand, whole);
    own.no_shadow = whole.no_shadow;
    take_finish(operand, own);
    return own;
}

void GeometryCompiler::take_finish(const scene::Object& object, const Inherited& own)
{
    if (sharing_ == nullptr && !clipping_ && own.texture && std::holds_alternative<scene::Csg>(object.shape))
        interior(own, own.texture);
}

std::uint32_t GeometryCompiler::light_group(const scene::Object& object, const csg::Transform& to_world)
{
    if (sharing_ != nullptr) sharing_->fails = true;  // each copy has lights of its own
    std::uint32_t& known = light_groups_(&object, to_world).value;
    if (known == 0) known = ++light_group_count_;
    return known;
}

/// Of a union that is taken apart. Of what coincides the first item is seen; of a union that POV-Ray keeps whole the
/// last operand (spec 5a, 2.2).
void GeometryCompiler::add_operands(const scene::Csg& csg, const Inherited& own)
{
    const std::size_t count = csg.operands->size();
    for (std::size_t i = 0; i < count; ++i) add_top((*csg.operands)[outer_bounds_.nested ? count - 1 - i : i], own);
}

bool GeometryCompiler::lost_in_hierarchy(const scene::Object& object, const Inherited& own) const
{
    return box_inside_out(object) && !options_.query && !outer_bounds_.nested && bounding_active() &&
           std::holds_alternative<csg::Sphere>(world_solid(object.shape, own.to_world));
}

void GeometryCompiler::add_top(const scene::Object& object, const Inherited& above)
{
    if (is_light(object)) return;
    Inherited own = below(object, above);
    take_finish(object, own);
    if (lost_in_hierarchy(object, own)) {
        ++lost_spheres_;
        return;
    }
    if (!object.details->bounded_by.empty() && !object.details->bounded_by_clip) ++bounds_;
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    const bool whole = !object.details->clipped_by.empty() || object.inverse;
    if (csg != nullptr && add_instance(object, own)) return;
    const bool bounded = csg != nullptr && !drops_bounds(object, outer_bounds_.nested);
    // POV-Ray keeps a bounded union whole, and one that is not to be split, which shows where parts are hidden and in
    // the order of what coincides (spec 3, 14; 5a, 2.2 and 11.1).
    const bool unit = bounded || (csg != nullptr && !csg->split_union);
    const bool kept = whole || (unit && hides_parts(*csg));
    if (csg != nullptr && csg->op == scene::CsgOp::Union && !kept) {
        ++split_unions_;
        const OuterBounds outer = outer_bounds_;
        if (unit) {
            if (bounded) must_meet(object, above.to_world, above.growth, outer_bounds_.guard);
            if (!outer.nested) outer_bounds_.box = plan::placed_extent(object, above.to_world, above.growth);
            outer_bounds_.nested = true;
            Inherited whole_target = own;
            aim_photons(object, whole_target);
            const std::size_t first = world_->items.size();
            add_operands(*csg, whole_target);
            if (!outer.nested) world_->test_box_since(first, outer_bounds_.box);
        } else {
            add_operands(*csg, own);
        }
        outer_bounds_ = outer;
        return;
    }
    add_alone(object, std::move(own));
}

std::uint32_t GeometryCompiler::add_object(const scene::Object& object, const Inherited& own)
{
    if (sharing_ != nullptr) return 0;
    known_surfaces_.clear();  // they name their object
    const bool shows_default = !own.texture && !std::holds_alternative<scene::Csg>(object.shape);
    out_.objects.push_back({interior(own, shows_default ? default_texture_ : own.texture), object.source, statement_});
    return static_cast<std::uint32_t>(out_.objects.size() - 1);
}

void GeometryCompiler::add_alone(const scene::Object& object, Inherited own)
{
    aim_photons(object, own);
    object_ = add_object(object, own);
    bounds_inside_ = false;
    csg::WorldData& world = *world_;
    const bool clipped = !clips_of(object).empty();
    if (const auto* mesh = std::get_if<scene::Mesh>(&object.shape); mesh != nullptr && !clipped) {
        const csg::PartId part = mesh_part(*mesh, own, object.flags.uv_mapping);
        world.add_solid(part, object.inverse && mesh_is_solid(*mesh->data), object_, visible(own));
        add_guard(object, own);
        return;
    }
    if (!std::holds_alternative<scene::Csg>(object.shape) && !std::holds_alternative<scene::Mesh>(object.shape) &&
        !clipped) {
        const csg::PartId part = world.store.add(solid(object, own), shape_surface(object, own));
        world.add_solid(part, object.inverse, object_, visible(own));
        add_guard(object, own);
        return;
    }
    csg::Tree whole = tree(object, own);
    const std::vector<std::uint8_t> views = views_of(whole);
    if (views.size() == 1) return add_tree(std::move(whole), object, own, visible(own));
    for (const std::uint8_t kinds : views) {
        const auto seeing = static_cast<std::uint8_t>(kinds & visible(own));
        std::optional<csg::Tree> seen = seen_by(whole, kinds);
        if (seeing != 0 && seen) add_tree(std::move(*seen), object, own, seeing);
    }
}

void GeometryCompiler::add_tree(csg::Tree whole, const scene::Object& object, const Inherited& own, std::uint8_t kinds)
{
    csg::WorldData& world = *world_;
    csg::Program program = csg::build(whole, world.store, &pruning_);
    if (program.nodes.empty() || (program.bounds.empty() && options_.lean.takes(LeanStep::EmptyObjects))) {
        ++empty_programs_;
        return;
    }
    world.add_program(std::move(program), object_, kinds);
    if (!clips_of(object).empty() && sharing_ == nullptr) add_unclipped(std::move(whole));
    add_guard(object, own);
}

csg::Solid GeometryCompiler::solid(const scene::Object& object, const Inherited& own)
{
    if (const auto* freeform = std::get_if<scene::Freeform>(&object.shape))
        return world_solid(scene::Freeform{fields_.linked(freeform->shape)}, own.to_world);
    const bool on_surface = std::holds_alternative<scene::Sphere>(object.shape) &&
                            (own.uv_mapping || uv_use_.of((own.texture ? own.texture : default_texture_).texture) ||
                             uv_use_.of(own.interior_texture.texture));
    return world_solid(object.shape, own.to_world, on_surface, description_.povray == scene::PovRay::V38,
                       out_.geometry.told);
}

csg::Tree GeometryCompiler::tree(const scene::Object& object, const Inherited& own)
{
    csg::Tree made;
    if (const auto* csg = std::get_if<scene::Csg>(&object.shape)) {
        made = csg_tree(*csg, own);
    } else if (const auto* mesh = std::get_if<scene::Mesh>(&object.shape)) {
        made = csg::Tree::leaf(mesh_part(*mesh, own, object.flags.uv_mapping));
    } else {
        const csg::SurfaceId id = clipping_ ? csg::kNoSurface : shape_surface(object, own);
        made = csg::Tree::leaf(world_->store.add(solid(object, own), id));
    }
    made.inverse = object.inverse;
    for (const scene::Object& clip : clips_of(object))
        made.clips.push_back(clip_tree(clip, parent_of(object, own)));  // they stand in the space of the parent
    return made;
}

csg::Tree GeometryCompiler::csg_tree(const scene::Csg& csg, const Inherited& own)
{
    csg::Tree made;
    made.op = tree_op(csg.op);
    const bool cutaway = csg.cutaway_textures && !own.texture;
    Inherited later = own;
    for (const scene::Object& operand : *csg.operands) {
        if (is_light(operand)) continue;
        const bool cuts = !made.operands.empty() && takes_cut_texture(operand, csg.op == scene::CsgOp::Difference);
        Inherited mine = within(operand, cuts ? later : own);
        aim_photons(operand, mine);
        const auto* parts = std::get_if<scene::Csg>(&operand.shape);
        const bool plain = parts != nullptr && parts->op == scene::CsgOp::Union &&
                           operand.details->clipped_by.empty() && !operand.inverse;
        if (cutaway && made.operands.empty() && csg.op == scene::CsgOp::Difference && plain && !mine.texture)
            return cut_parts(csg, *parts, operand, own, mine);
        made.operands.push_back(bounded(tree(operand, mine), operand, mine));
        made.operands.back().hidden_from = hidden_from({mine.no_image, mine.no_reflection, mine.no_radiosity});
        if (cutaway && made.operands.size() == 1) later.texture = cut_texture(operand, mine);
    }
    return made;
}

csg::Tree GeometryCompiler::clip_tree(const scene::Object& clip, const csg::Transform& to_world)
{
    Inherited none;
    none.to_world = to_world * *clip.transform;
    const bool before = std::exchange(clipping_, true);
    csg::Tree made = tree(clip, none);
    clipping_ = before;
    return made;
}

csg::SurfaceId GeometryCompiler::shape_surface(const scene::Object& object, const Inherited& own)
{
    const auto* freeform = std::get_if<scene::Freeform>(&object.shape);
    const bool in_parts = freeform != nullptr && freeform->part_textures && !freeform->part_textures->empty();
    const bool blob = freeform != nullptr && std::holds_alternative<csg::Blob>(freeform->shape->kind);
    if (!in_parts && !(blob && own.interior_texture)) return surface(own);
    Inherited outside = own;
    if (!in_parts) {
        outside.opaque_outside = opaque_outside({}, own);
        return surface(outside);
    }
    outside.interior_texture = {};  // POV-Ray shows the parts on both sides (spec 5a, 5.11)
    std::vector<std::uint32_t> parts;
    for (const scene::TexturePtr& texture : *freeform->part_textures) {
        if (texture) parts.push_back(textures_.texture(moved(texture, own.to_world)));
        else parts.push_back(textures_.texture(own.texture ? own.texture : default_texture_));
    }
    return surface(outside, {}, parts);
}

std::uint8_t GeometryCompiler::visible(const Inherited& own) const
{
    std::uint8_t bits = 0;
    if (!own.no_image) bits = static_cast<std::uint8_t>(bits | bit(RayKind::Image));
    if (!own.no_reflection) bits = static_cast<std::uint8_t>(bits | bit(RayKind::Reflection));
    if (!own.no_shadow) bits = static_cast<std::uint8_t>(bits | bit(RayKind::Shadow) | bit(RayKind::Photon));
    if (!own.no_shadow && !own.no_reflection) bits = static_cast<std::uint8_t>(bits | bit(RayKind::MirroredPhoton));
    if (!own.no_radiosity) bits = static_cast<std::uint8_t>(bits | bit(RayKind::Gather));
    return bits;
}

}  // namespace plan
