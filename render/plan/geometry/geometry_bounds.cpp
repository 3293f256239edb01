#include "csg/tree/held.h"
#include "csg/tree/boxes/quadric_box.h"
#include "csg/world/world.h"
#include "render/plan/geometry/extent.h"
#include "render/plan/geometry/geometry.h"
#include "render/plan/geometry/solids.h"

#include <algorithm>

namespace plan {
namespace {

/// Boxes of what has no end reach to 1e10 (spec 5a, 7).
constexpr double kUnbounded = 0.99e10;
/// A bounded union is taken apart only where all its parts are smaller (spec 5a, 11.1).
constexpr double kFiniteVolume = 2e10;
/// What an object's box leaves another by less than this, relative to its size, is rounding, and a guard would cost
/// time for nothing.
constexpr double kSlack = 0.01;

/// POV-Ray drops the bounds of all other kinds that have a box of their own, where they stand at top level (spec
/// 5a, 9.2).
bool keeps_bounds(const scene::Object& object)
{
    if (std::holds_alternative<scene::Csg>(object.shape) || std::holds_alternative<scene::Polynomial>(object.shape) ||
        std::holds_alternative<scene::Extrusion>(object.shape))
        return true;
    const scene::Quadric* const quadric = scene::quadric_of(object);
    return quadric != nullptr && !finds_quadric_box(object, *quadric);
}

bool has_disc(const scene::Object& object)
{
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    return csg ? std::any_of(csg->operands->begin(), csg->operands->end(), has_disc)
               : std::holds_alternative<scene::Disc>(object.shape);
}

/// Whether a half-space with the flat box of a disc takes part in an intersection: POV-Ray shows only what its rays
/// meet of the solid on their way through that box.
bool cut_by_disc(const scene::Object& object)
{
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    return csg != nullptr && !object.inverse &&
           (csg->op == scene::CsgOp::Intersection || csg->op == scene::CsgOp::Difference) && has_disc(object);
}

/// Whether the box has no end to any side.
bool everywhere(const csg::Aabb& box)
{
    return glm::all(glm::lessThan(box.lower, glm::dvec3(-kUnbounded))) &&
           glm::all(glm::greaterThan(box.upper, glm::dvec3(kUnbounded)));
}

bool holds(const csg::Aabb& box, const csg::Aabb& drawn)
{
    if (!drawn.finite()) return false;
    const glm::dvec3 slack = kSlack * (drawn.upper - drawn.lower);
    return glm::all(glm::greaterThanEqual(drawn.lower + slack, box.lower)) &&
           glm::all(glm::lessThanEqual(drawn.upper - slack, box.upper));
}

/// Whether POV-Ray asks the object's own box even where it has no hierarchy (spec 5a, 11.4).
bool has_own_box(const scene::Object& object)
{
    const scene::Shape& shape = object.shape;
    return !(std::holds_alternative<scene::Sphere>(shape) || std::holds_alternative<scene::Box>(shape) ||
             std::holds_alternative<scene::Plane>(shape) || std::holds_alternative<scene::Triangle>(shape) ||
             std::holds_alternative<scene::Shared<scene::SmoothTriangle>>(shape));
}

bool finite(const scene::Object& part)
{
    if (is_light(part)) return true;
    const csg::Aabb box = described_extent(part);
    const glm::dvec3 edge = box.upper - box.lower;
    return edge.x * edge.y * edge.z <= kFiniteVolume;
}

/// Whether POV-Ray's box may not be around all that is drawn: an operand or a clip, however deep, or the box of one, is
/// turned inside out.
bool turns_operand(const scene::Object& object)
{
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    for (std::size_t i = 0; csg != nullptr && i < csg->operands->size(); ++i) {
        const scene::Object& part = (*csg->operands)[i];
        const bool subtracted = csg->op == scene::CsgOp::Difference && i > 0;
        if (part.inverse || (subtracted && !box_turned(part, true)) || box_inside_out(part) || turns_operand(part))
            return true;
    }
    const std::vector<scene::Object>& clips = object.details->clipped_by;
    return std::any_of(clips.begin(), clips.end(),
                       [](const scene::Object& clip) { return clip.inverse || turns_operand(clip); });
}

/// Whether POV-Ray's box of a CSG object may hold less than what is drawn of it: rays that miss the box are told of
/// nothing, where it stands at top level; its operands' own boxes are not asked.
bool ends_at_box(const scene::Object& object)
{
    return std::holds_alternative<scene::Csg>(object.shape) && (object.inverse || turns_operand(object));
}

/// A lone solid as a program, to ask it the same questions.
csg::Program alone(const csg::WorldItem& item, const csg::SolidStore& store)
{
    csg::Tree leaf = csg::Tree::leaf(item.solid);
    leaf.inverse = item.inverted;
    return csg::build(leaf, store);
}

}  // namespace

csg::Transform GeometryCompiler::parent_of(const scene::Object& object, const Inherited& own)
{
    return own.to_world * object.transform->inverted();
}

csg::Aabb GeometryCompiler::placed_extent(const scene::Object& object, const Inherited& own)
{
    return plan::placed_extent(object, parent_of(object, own), own.parent_growth);
}

/// Whether an object's bounds are not asked: there are none, they are its clips, or +SU takes the union apart.
bool GeometryCompiler::drops_bounds(const scene::Object& object, bool inside_csg) const
{
    if (object.details->bounded_by.empty() || object.details->bounded_by_clip) return true;
    if (!options_.split_unions || inside_csg) return false;
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    return csg != nullptr && csg->op == scene::CsgOp::Union && csg->split_union &&
           std::all_of(csg->operands->begin(), csg->operands->end(), finite);
}

/// Whether POV-Ray tests boxes of all objects: with less than 3 at top level it does not (spec 5a, 11.2).
bool GeometryCompiler::bounding_active() const
{
    constexpr std::size_t kFewest = 3;
    std::size_t count = 0;
    const auto add = [&](const auto& self, const scene::Object& object) -> void {
        const auto* csg = std::get_if<scene::Csg>(&object.shape);
        const bool split = csg != nullptr && csg->op == scene::CsgOp::Union && csg->split_union &&
                           object.details->clipped_by.empty() && object.details->bounded_by.empty() && !object.inverse;
        if (!split) ++count;
        else
            for (std::size_t i = 0; i < csg->operands->size() && count < kFewest; ++i) self(self, (*csg->operands)[i]);
    };
    for (std::size_t i = 0; i < description_.objects.size() && count < kFewest; ++i) add(add, description_.objects[i]);
    return count >= kFewest;
}

/// Adds an object's bounds to what a ray must meet to be told of it, and the box that they make of it. `parent`: of the
/// space that they stand in.
void GeometryCompiler::must_meet(const scene::Object& object, const csg::Transform& parent,
                                 const scene::BoxGrowth& growth, csg::BoundingGuard& guard)
{
    for (const scene::Object& bound : object.details->bounded_by) {
        csg::Program program = csg::build(clip_tree(bound, parent), world_->store);
        if (program.nodes.empty()) continue;
        guard.programs.push_back(static_cast<std::uint32_t>(world_->programs.size()));
        world_->programs.push_back(std::move(program));
    }
    guard.box = guard.box.intersected(plan::placed_extent(object, parent, growth));
}

/// An operand of a CSG object, whatever its kind, behind those of its bounds that do not hold it.
csg::Tree GeometryCompiler::bounded(csg::Tree made, const scene::Object& operand, const Inherited& own)
{
    if (clipping_ || drops_bounds(operand, true)) return made;
    const csg::Program drawn = csg::build(made, world_->store);
    const csg::Transform parent = parent_of(operand, own);
    for (const scene::Object& bound : operand.details->bounded_by) {
        csg::Tree tree = clip_tree(bound, parent);
        const csg::Program program = csg::build(tree, world_->store);
        if (!program.nodes.empty() && (!options_.lean.takes(LeanStep::Bounds) || !held(operand, drawn, program)))
            made.bounds.push_back(std::move(tree));
    }
    bounds_inside_ |= !made.bounds.empty();
    return made;
}

/// The box that clips leave an object, and what a polynomial's clips hold.
csg::BoundingGuard GeometryCompiler::clip_guard(const scene::Object& object, const Inherited& own)
{
    csg::WorldData& world = *world_;
    csg::BoundingGuard guard;
    csg::Transform parent;
    if (!object.details->clipped_by.empty()) parent = parent_of(object, own);
    if (std::holds_alternative<scene::Polynomial>(object.shape) && !object.details->clipped_by.empty()) {
        // What a ray cannot meet inside all clips is not worth the roots.
        csg::Tree all;
        all.op = csg::Tree::Op::Intersection;
        for (const scene::Object& clip : object.details->clipped_by) all.operands.push_back(clip_tree(clip, parent));
        csg::Program program = csg::build(all, world.store);
        if (!program.nodes.empty()) {
            guard.box = guard.box.intersected(program.bounds);
            guard.programs.push_back(static_cast<std::uint32_t>(world.programs.size()));
            world.programs.push_back(std::move(program));
        }
    }
    for (const scene::Object& clip : object.details->clipped_by) {
        if (box_turned(clip) || (turns_operand(clip) && !has_own_box(object) && !bounding_active())) continue;
        const csg::Aabb box = plan::placed_extent(clip, parent, own.parent_growth);
        if (glm::all(glm::lessThan(glm::max(glm::abs(box.lower), glm::abs(box.upper)), glm::dvec3(kUnbounded))))
            guard.box = guard.box.intersected(box);
    }
    const auto* plane = std::get_if<scene::Plane>(&object.shape);
    if (cut_by_disc(object) || ends_at_box(object) ||
        (plane != nullptr && !object.details->clipped_by.empty() && bounding_active())) {
        const csg::Aabb box = placed_extent(object, own);
        if (!everywhere(box)) guard.box = guard.box.intersected(box);
    }
    if (scene::quadric_of(object) != nullptr && guard.box.finite()) {
        // What the clips' boxes leave of an endless quadric.
        const csg::Solid whole = world_solid(object.shape, own.to_world);
        if (const auto* quadric = std::get_if<csg::Quadric>(&whole))
            guard.box = csg::quadric_box(*quadric, {}, guard.box);
    }
    return guard;
}

/// As csg::held_by. Copies of an object are as a rule bounded alike: what was told of the first is looked over with a
/// few rays.
bool GeometryCompiler::held(const scene::Object& object, const csg::Program& drawn, const csg::Program& bound)
{
    constexpr std::uint32_t kFewRays = 12;
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    if (csg == nullptr) return csg::held_by(drawn, bound, world_->store);
    const auto [known, first] = held_.try_emplace({csg->operands.get(), bound.nodes.size()}, false);
    if (first) known->second = csg::held_by(drawn, bound, world_->store);
    else if (known->second) return csg::held_by(drawn, bound, world_->store, kFewRays);
    return known->second;
}

void GeometryCompiler::add_unclipped(csg::Tree whole)
{
    whole.clips.clear();
    csg::Program program = csg::build(whole, world_->store);
    if (program.nodes.empty() || (!program.inside_beyond && program.bounds.intersected(starts_).empty())) return;
    world_->items.back().unclipped = static_cast<std::uint32_t>(world_->programs.size());
    world_->programs.push_back(std::move(program));
}

void GeometryCompiler::limit_starts(const scene::Object& object, const Inherited& own)
{
    if (sharing_ != nullptr) return;
    const auto item = static_cast<std::uint32_t>(world_->items.size() - 1);
    if (world_->items[item].instance != csg::Hit::kNoInstance) {
        // Not all parts of every copy are asked.
        const csg::Aabb drawn = csg::drawn_bounds(*world_, world_->items[item]);
        if (drawn.intersected(starts_).empty()) {
            out_.objects[object_].holds_starts = drawn;
            return;
        }
    }
    if (!csg::World(*world_).item_may_hold(item, starts_)) return;
    out_.objects[object_].holds_starts = outer_bounds_.nested ? outer_bounds_.box : placed_extent(object, own);
}

/// `bounded_by` of the item that was added last, and the box that clips leave it: they decide which rays are told of
/// it.
void GeometryCompiler::add_guard(const scene::Object& object, const Inherited& own)
{
    csg::WorldData& world = *world_;
    const csg::WorldItem item = world.items.back();
    const csg::Aabb drawn = csg::drawn_bounds(world, item);
    limit_starts(object, own);
    if (world.last_has_test_box()) world.test_box_of_last(placed_extent(object, own));
    csg::BoundingGuard guard = clip_guard(object, own);
    if (bounds_inside_) guard.box = guard.box.intersected(placed_extent(object, own));
    const bool lean = options_.lean.takes(LeanStep::Bounds);
    if (lean && holds(guard.box, drawn)) guard = {};
    csg::BoundingGuard bounds = outer_bounds_.guard;
    if (item.instance == csg::Hit::kNoInstance && !drops_bounds(object, outer_bounds_.nested)) {
        if (outer_bounds_.nested || keeps_bounds(object))
            must_meet(object, parent_of(object, own), own.parent_growth, bounds);
        else if (has_own_box(object) || bounding_active())
            bounds.box = bounds.box.intersected(placed_extent(object, own));
    }
    if (!lean || !holds(bounds.box, drawn)) guard.box = guard.box.intersected(bounds.box);
    if (!bounds.programs.empty()) {
        const csg::Program lone = item.solid != csg::kNoPart ? alone(item, world.store) : csg::Program{};
        for (const std::uint32_t b : bounds.programs) {
            const csg::Program& bound = world.programs[b];
            const bool within =
                item.instance != csg::Hit::kNoInstance
                    ? csg::held_by(drawn, bound, world.store)
                    : held(object, item.solid != csg::kNoPart ? lone : world.programs[item.program], bound);
            if (!within || !options_.lean.takes(LeanStep::Bounds)) guard.programs.push_back(b);
        }
    }
    if (guard.programs.empty() && !guard.box.finite()) return;
    if (!object.details->bounded_by.empty() && !object.details->bounded_by_clip && bounds_ > 0) {
        --bounds_;
        ++guards_;
    }
    // What POV-Ray takes for infinite is asked before all boxes.
    const glm::dvec3 edge = guard.box.upper - guard.box.lower;
    guard.ordered = guard.box.finite() && edge.x * edge.y * edge.z <= kFiniteVolume && bounding_active();
    guard.shadows_pass = guard.programs.empty() && !has_own_box(object);
    world.guard_last(std::move(guard));
}

}  // namespace plan
