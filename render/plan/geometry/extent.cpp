#include "render/plan/geometry/extent.h"

#include "csg/freeform/freeform.h"
#include "csg/tree/boxes/quadric_box.h"
#include "render/plan/geometry/solids.h"
#include "render/scene/inside.h"

#include <algorithm>
#include <cmath>

namespace plan {
namespace {

constexpr double kFar = 1e10;            // half the edge of "everything"
constexpr double kLongestEdge = 1e6;     // longer ones of a CSG object make it infinite
constexpr double kSmallestTerm = 1e-10;  // of a quadric; smaller ones are 0
constexpr double kDiscHalfThickness = 1e-3;
constexpr double kPolygonHalfThickness = 1e-3;  // of one along the axes (spec 5b, 4)

csg::Aabb everything() { return {glm::dvec3(-kFar), glm::dvec3(kFar)}; }

csg::Aabb corners_moved(const csg::Transform& t, const csg::Aabb& box)
{
    csg::Aabb moved;
    for (int corner = 0; corner < 8; ++corner)
        moved.include(t.point({corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                               corner & 4 ? box.upper.z : box.lower.z}));
    moved.lower = glm::max(moved.lower, glm::dvec3(-kFar));
    moved.upper = glm::min(moved.upper, glm::dvec3(kFar));
    return moved;
}

csg::Aabb clamped(const csg::Aabb& box)
{
    return {glm::max(box.lower, glm::dvec3(-kFar)), glm::min(box.upper, glm::dvec3(kFar))};
}

/// A box that was turned in several steps, `t` together.
csg::Aabb turned(const csg::Transform& t, const scene::BoxGrowth& growth, const csg::Aabb& box)
{
    const glm::dvec3 middle = t.point(0.5 * (box.lower + box.upper)),
                     half = growth.edges * (0.5 * (box.upper - box.lower));
    return clamped({middle - half, middle + half});
}

/// As single precision has it. Volatile, for g++ 12 takes the three axes together and leaves the rounding out (-O2, SLP
/// vectorizer).
double in_single(double value)
{
    volatile float rounded = static_cast<float>(value);
    return static_cast<double>(rounded);
}

/// As POV-Ray keeps a box, its lower corner and its edges in single precision, and adds them.
csg::Aabb kept(const csg::Aabb& box)
{
    csg::Aabb told;
    for (int k = 0; k < 3; ++k) {
        told.lower[k] = in_single(box.lower[k]);
        told.upper[k] = in_single(told.lower[k] + in_single(box.upper[k] - box.lower[k]));
    }
    return told;
}

double volume(const csg::Aabb& box)
{
    const glm::dvec3 edge = box.upper - box.lower;
    return edge.x * edge.y * edge.z;
}

csg::Aabb unless_too_long(const csg::Aabb& box)
{
    const glm::dvec3 edge = box.upper - box.lower;
    return std::max({edge.x, edge.y, edge.z}) > kLongestEdge ? everything() : box;
}

csg::Aabb thickened(csg::Aabb box)
{
    for (int k = 0; k < 3; ++k)
        if (box.upper[k] - box.lower[k] < kPolygonHalfThickness) {
            box.lower[k] -= kPolygonHalfThickness;
            box.upper[k] += kPolygonHalfThickness;
        }
    return box;
}

csg::Aabb csg_extent(const scene::Csg& csg);
csg::Aabb quadric_extent(const scene::Quadric& quadric, const csg::Transform& t);

/// Of the shape in its statement's space, `t` applied.
struct ShapeExtent {
    const csg::Transform& t;

    csg::Aabb operator()(const scene::Sphere& s) const
    {
        if (const csg::Solid made = world_solid(s, t); const auto* sphere = std::get_if<csg::Sphere>(&made)) {
            const double r = s.radius < 0.0 ? -sphere->radius : sphere->radius;
            return {sphere->center - r, sphere->center + r};
        }
        const double r = std::abs(s.radius);
        return corners_moved(t, {s.center - r, s.center + r});
    }
    csg::Aabb operator()(const scene::Box& s) const { return corners_moved(t, {s.lower, s.upper}); }
    csg::Aabb operator()(const scene::Plane&) const { return everything(); }
    csg::Aabb operator()(const scene::Polynomial&) const { return everything(); }  // closed or not (spec 5a, 7)
    csg::Aabb operator()(const scene::Cylinder& s) const { return tube(world_solid(s, t)); }
    csg::Aabb operator()(const scene::Cone& s) const { return tube(world_solid(s, t)); }
    csg::Aabb operator()(const scene::Shared<scene::Quadric>& s) const { return quadric_extent(*s, t); }
    csg::Aabb operator()(const scene::Disc& s) const
    {
        const csg::Solid made = world_solid(s, t);
        const auto& disc = std::get<csg::Disc>(made);
        const glm::dvec3 half(disc.radius, disc.radius, kDiscHalfThickness);
        return corners_moved(disc.frame, {-half, half});
    }
    csg::Aabb operator()(const scene::Torus& s) const
    {
        if (has_spindle(s)) return corners_moved(t, spindle_torus(s).bounds());
        const glm::dvec3 half(s.major + s.minor, s.minor, s.major + s.minor);
        return corners_moved(t, {-half, half});
    }
    csg::Aabb operator()(const scene::Mesh& s) const
    {
        csg::Aabb box;
        for (const scene::MeshData::Face& face : s.data->faces)
            for (const std::uint32_t v : face.vertex) box.include(s.data->vertices[v]);
        return corners_moved(t, box);
    }
    csg::Aabb operator()(const scene::Freeform& s) const
    {
        if (const auto* patch = std::get_if<csg::BicubicPatch>(&s.shape->kind)) {
            csg::Aabb points;
            for (const auto& row : patch->input().points)
                for (const glm::dvec3& point : row) points.include(t.point(point));
            return points;
        }
        const csg::Aabb box = corners_moved({}, csg::drawn_shape(s.shape)->extent(t));
        return std::holds_alternative<csg::Polygon>(s.shape->kind) ? thickened(box) : box;
    }
    csg::Aabb operator()(const scene::Extrusion& s) const
    {
        if (s.outline->empty()) return {};
        csg::Aabb box{glm::dvec3(s.outline->lower(), s.low), glm::dvec3(s.outline->upper(), s.high)};
        if (s.bezier)
            for (const csg::OutlinePiece& p : s.outline->pieces())
                for (const glm::dvec2& control : {p.d + p.c / 3.0, p.d + (2.0 * p.c + p.b) / 3.0})
                    box.include(glm::dvec3(control, s.low));
        return corners_moved(t, box);
    }
    csg::Aabb operator()(const scene::Csg& s) const
    {
        const csg::Aabb box = csg_extent(s);
        return t.identity() && s.growth->edges == glm::dmat3(1.0) ? box : turned(t, *s.growth, box);
    }
    csg::Aabb operator()(const scene::Shared<scene::Light>&) const { return everything(); }
    /// All others: the box of the solid.
    template <class Shape>
    csg::Aabb operator()(const Shape& s) const
    {
        return solid_box(s);
    }

private:
    template <class Shape>
    csg::Aabb solid_box(const Shape& s) const
    {
        const csg::Aabb box = std::visit(
            [](const auto& solid) {
                if constexpr (requires { solid.bounds(); }) return solid.bounds();
                else return csg::Aabb::everything();
            },
            world_solid(s, t));
        return box.finite() ? box : everything();
    }
    static csg::Aabb tube(const csg::Solid& made)
    {
        if (const auto* cylinder = std::get_if<csg::Cylinder>(&made))
            return corners_moved(cylinder->frame, {{-1, -1, 0}, {1, 1, 1}});
        const auto& cone = std::get<csg::Cone>(made);
        return corners_moved(cone.frame, {{-1, -1, cone.low}, {1, 1, 1}});
    }
};

csg::Aabb extent(const scene::Object& object);

bool is_height_field(const scene::Object& object)
{
    const auto* freeform = std::get_if<scene::Freeform>(&object.shape);
    return freeform != nullptr && std::holds_alternative<csg::HeightField>(freeform->shape->kind);
}

/// A plane counts as a half-space inside an intersection, also turned round where it is subtracted.
bool half_space(const scene::Object& operand, bool turned, csg::Aabb& box)
{
    const auto* plane = std::get_if<scene::Plane>(&operand.shape);
    if (plane == nullptr) return false;
    const csg::Solid made = world_solid(*plane, *operand.transform);
    csg::Plane space = std::get<csg::Plane>(made);
    if (operand.inverse != turned) {
        space.normal_out = -space.normal_out;
        space.offset = -space.offset;
    }
    box = {glm::max(space.bounds().lower, glm::dvec3(-kFar)), glm::min(space.bounds().upper, glm::dvec3(kFar))};
    return true;
}

/// What clips leave of space: planes across an axis are half-spaces.
csg::Aabb clip_box(const std::vector<scene::Object>& clips)
{
    csg::Aabb box = everything(), cut;
    for (const scene::Object& clip : clips) {
        if (half_space(clip, false, cut)) box = box.intersected(cut);
        else if (!box_turned(clip)) box = box.intersected(extent(clip));
    }
    return box;
}

/// The quadric in the space that `t` leads to, written out there.
csg::Quadric written_out(const scene::Quadric& q, const csg::Transform& t)
{
    const glm::dvec3 m = 0.5 * q.mixed;
    const glm::dmat3 half(q.square.x, m.x, m.y, m.x, q.square.y, m.z, m.y, m.z, q.square.z);
    const glm::dmat3& back = t.inverse_linear;
    const glm::dvec3 start = t.inverse_point(glm::dvec3(0));
    const glm::dmat3 terms = glm::transpose(back) * half * back;
    const auto term = [](double value) { return std::abs(value) < kSmallestTerm ? 0.0 : value; };
    csg::Quadric made;
    made.square = {term(terms[0][0]), term(terms[1][1]), term(terms[2][2])};
    made.mixed = {term(2.0 * terms[0][1]), term(2.0 * terms[0][2]), term(2.0 * terms[1][2])};
    made.linear = glm::transpose(back) * (2.0 * half * start + q.linear);
    made.constant = glm::dot(start, half * start) + glm::dot(q.linear, start) + q.constant;
    return made;
}

/// `box` or, if that is smaller, the box of what the quadric and `within` have in common (spec 5a, 7.1). One with mixed
/// terms has none of its own.
csg::Aabb smaller_quadric_box(const csg::Aabb& box, const scene::Quadric& quadric, const csg::Transform& t,
                              const csg::Aabb& within)
{
    const csg::Quadric q = written_out(quadric, t);
    const csg::Aabb fresh = clamped(csg::quadric_box(q, {}, within));
    if (fresh.empty() || !(volume(fresh) < volume(box))) return box;
    return q.mixed == glm::dvec3(0.0) ? unless_too_long(fresh) : fresh;
}

/// A cone or a hyperboloid of one sheet along an axis, which is as wide as it is far.
bool widens(const csg::Quadric& q)
{
    const glm::dvec3& a = q.square;
    const int positive = (a.x > 0.0) + (a.y > 0.0) + (a.z > 0.0), negative = (a.x < 0.0) + (a.y < 0.0) + (a.z < 0.0);
    if (positive + negative < 3 || positive == 0 || negative == 0) return false;
    const glm::dvec3 moved = q.linear * q.linear / (4.0 * a);
    const double rest = q.constant - moved.x - moved.y - moved.z;
    return positive == 2 ? rest < kSmallestTerm : rest > -kSmallestTerm;
}

csg::Aabb quadric_extent(const scene::Quadric& quadric, const csg::Transform& t)
{
    csg::Aabb box = smaller_quadric_box(everything(), quadric, {}, everything());
    const scene::QuadricPast& past = *quadric.past;
    if (!past.first_clips) return turned(t, past.growth, box);
    const scene::FirstClips& first = *past.first_clips;
    box = turned(first.transform, first.growth, box);
    box = smaller_quadric_box(box, quadric, first.transform, clip_box(first.clips));
    return turned(t * first.transform.inverted(), past.growth, box);
}

/// Narrows an intersection's box by an operand's; what is turned inside out says nothing, planes apart, and no more do
/// height fields.
void cut_box(const scene::Object& operand, bool subtracted, csg::Aabb& box)
{
    csg::Aabb cut;
    if (!half_space(operand, subtracted, cut)) {
        if (is_height_field(operand) || box_turned(operand, subtracted)) return;
        cut = extent(operand);
        if (const scene::Quadric* const quadric = scene::quadric_of(operand))
            cut = smaller_quadric_box(cut, *quadric, *operand.transform,
                                      box.intersected(clip_box(operand.details->clipped_by)));
    }
    box = box.intersected(cut);
}

csg::Aabb csg_extent(const scene::Csg& csg)
{
    const bool joins = csg.op == scene::CsgOp::Union || csg.op == scene::CsgOp::Merge;
    csg::Aabb box = joins ? csg::Aabb{} : everything();
    // Quadrics come last: what the others leave bounds them.
    for (const bool quadrics : {false, true})
        for (std::size_t i = 0; i < csg.operands->size(); ++i) {
            const scene::Object& operand = (*csg.operands)[i];
            if ((scene::quadric_of(operand) != nullptr) != quadrics) continue;
            if (joins) box.include(extent(operand));
            else cut_box(operand, csg.op == scene::CsgOp::Difference && i > 0, box);
        }
    return kept(box.empty() ? everything() : unless_too_long(box));
}

csg::Aabb common(const std::vector<scene::Object>& bounds)
{
    csg::Aabb box = everything();
    for (const scene::Object& bound : bounds)
        if (!box_turned(bound)) box = box.intersected(extent(bound));
    return box;
}

csg::Aabb extent(const scene::Object& object)
{
    const auto* plane = std::get_if<scene::Plane>(&object.shape);
    csg::Aabb box = plane != nullptr && plane->moved_clips ? extent(object.details->clipped_by.front())
                                                           : std::visit(ShapeExtent{*object.transform}, object.shape);
    if (const scene::Quadric* const quadric = scene::quadric_of(object);
        quadric != nullptr && !quadric->past->first_clips && !object.details->clipped_by.empty())
        box = smaller_quadric_box(box, *quadric, *object.transform, clip_box(object.details->clipped_by));
    box = kept(box);
    if (object.flags.unclipped_box) return box;
    for (const std::vector<scene::Object>* set : {&object.details->bounded_by, &object.details->clipped_by})
        if (const csg::Aabb cut = common(*set); !set->empty() && !cut.empty() && volume(cut) < volume(box)) box = cut;
    return box;
}

}  // namespace

csg::Aabb described_extent(const scene::Object& object) { return extent(object); }

bool box_inside_out(const scene::Object& object)
{
    const auto* sphere = std::get_if<scene::Sphere>(&object.shape);
    return sphere != nullptr && sphere->radius < 0.0;
}

bool box_turned(const scene::Object& operand, bool subtracted)
{
    const scene::Shape& shape = operand.shape;
    const bool lone = !std::holds_alternative<scene::Csg>(shape) && !std::holds_alternative<scene::Mesh>(shape);
    if (lone && (operand.forgets_inverse || scene::is_patch(operand))) return false;
    return operand.inverse != subtracted;
}

bool finds_quadric_box(const scene::Object& object, const scene::Quadric& quadric)
{
    const auto mixed = [](const csg::Quadric& q) { return q.mixed != glm::dvec3(0.0); };
    if (const csg::Quadric q = written_out(quadric, {}); !mixed(q) && !widens(q)) return true;
    if (const auto& first = quadric.past->first_clips) return !mixed(written_out(quadric, first->transform));
    return !object.details->clipped_by.empty() && !mixed(written_out(quadric, *object.transform));
}

csg::Aabb placed_extent(const scene::Object& object, const csg::Transform& parent, const scene::BoxGrowth& growth)
{
    if (parent.identity()) return described_extent(object);
    // What it is painted and filled with has no part in its box, and would be moved with it.
    scene::Object bare;
    bare.shape = object.shape;
    bare.transform = object.transform;
    bare.inverse = object.inverse;
    bare.flags.unclipped_box = object.flags.unclipped_box;
    if (!object.details->clipped_by.empty() || !object.details->bounded_by.empty()) {
        scene::ObjectDetails& details = bare.details.edit();
        details.clipped_by = object.details->clipped_by;
        details.bounded_by = object.details->bounded_by;
    }
    bare.transform_by(parent, growth);
    return described_extent(bare);
}

}  // namespace plan
