#include "csg/quadric_box.h"
#include "render/plan/extent.h"
#include "render/plan/geometry.h"
#include "render/plan/solids.h"

#include <algorithm>

namespace plan {
namespace {

/// A bound that an object's box leaves by less than this, relative to its size, was meant to hold it: what sticks out is
/// rounding, and a gate would cost time for nothing.
constexpr double kSlack = 0.01;

/// Boxes of what has no end reach to 1e10 (spec 5a, 7).
constexpr double kUnbounded = 0.99e10;

/// POV-Ray drops the bounds of all other kinds that have a box of their own (spec 5a, 9.2).
bool keeps_bounds(const scene::Object& object, const csg::Aabb& drawn)
{
    if (std::holds_alternative<scene::Csg>(object.shape) || std::holds_alternative<scene::Polynomial>(object.shape) ||
        std::holds_alternative<scene::Extrusion>(object.shape))
        return true;
    return std::holds_alternative<scene::Quadric>(object.shape) && !drawn.finite();
}

bool has_disc(const scene::Object& object)
{
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    return csg ? std::any_of(csg->operands->begin(), csg->operands->end(), has_disc) : std::holds_alternative<scene::Disc>(object.shape);
}

/// Whether a half-space with the flat box of a disc takes part in an intersection: POV-Ray shows only what its rays meet of the
/// solid on their way through that box.
bool cut_by_disc(const scene::Object& object)
{
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    return csg != nullptr && !object.inverse && (csg->op == scene::CsgOp::Intersection || csg->op == scene::CsgOp::Difference) && has_disc(object);
}

bool holds(const csg::Aabb& box, const csg::Aabb& drawn)
{
    if (!drawn.finite()) return false;
    const glm::dvec3 slack = kSlack * (drawn.upper - drawn.lower);
    return glm::all(glm::greaterThanEqual(drawn.lower + slack, box.lower)) && glm::all(glm::lessThanEqual(drawn.upper - slack, box.upper));
}

}  // namespace

/// `bounded_by` of the item that was added last, and the box that clips leave it: they decide which rays are told of it.
void GeometryCompiler::add_gate(const scene::Object& object, const Inherited& own)
{
    csg::WorldData& world = *world_;
    const csg::WorldItem& item = world.items.back();
    const csg::Aabb drawn = item.solid == csg::kNoPart
                                ? world.programs[item.program].bounds
                                : csg::with_solid(world.store, item.solid, [](const auto& solid) { return solid.bounds(); });
    const csg::Transform parent = own.to_world * object.transform.inverted();
    csg::Gate gate;
    const auto must_meet = [&](const csg::Tree& tree) {
        csg::Program program = csg::build(tree, world.store);
        if (program.nodes.empty()) return;
        if (program.bounds.finite()) gate.box = gate.box.intersected(program.bounds);
        gate.programs.push_back(static_cast<std::uint32_t>(world.programs.size()));
        world.programs.push_back(std::move(program));
    };
    if (std::holds_alternative<scene::Polynomial>(object.shape) && !object.clipped_by.empty()) {
        // What a ray cannot meet inside all clips is not worth the roots.
        csg::Tree all;
        all.op = csg::Tree::Op::Intersection;
        for (const scene::Object& clip : object.clipped_by) all.operands.push_back(clip_tree(clip, parent));
        must_meet(all);
    }
    for (const scene::Object& clip : object.clipped_by) {
        if (clip.inverse) continue;
        scene::Object moved = clip;
        moved.transform_by(parent);
        const csg::Aabb box = described_extent(moved);
        if (glm::all(glm::lessThan(glm::max(glm::abs(box.lower), glm::abs(box.upper)), glm::dvec3(kUnbounded)))) gate.box = gate.box.intersected(box);
    }
    if (cut_by_disc(object)) {
        scene::Object moved = object;
        moved.transform_by(parent);
        gate.box = gate.box.intersected(described_extent(moved));
    }
    if (std::holds_alternative<scene::Quadric>(object.shape) && gate.box.finite()) {
        // What the clips' boxes leave of an endless quadric.
        const csg::Solid whole = world_solid(object.shape, own.to_world);
        if (const auto* quadric = std::get_if<csg::Quadric>(&whole)) gate.box = csg::quadric_box(*quadric, {}, gate.box);
    }
    if (!object.bounded_by.empty() && !object.bounded_by_clip && keeps_bounds(object, drawn)) {
        for (const scene::Object& bound : object.bounded_by) must_meet(clip_tree(bound, parent));
    }
    if ((gate.programs.empty() && !gate.box.finite()) || holds(gate.box, drawn)) return;
    if (!object.bounded_by.empty() && !object.bounded_by_clip && bounds_ > 0) {
        --bounds_;
        ++gates_;
    }
    world.gate_last(std::move(gate));
}

}  // namespace plan
