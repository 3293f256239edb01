#include "csg/tree/draft.h"

#include "csg/tree/boxes/polyhedron_box.h"
#include "csg/tree/boxes/quadric_box.h"

#include <algorithm>

namespace csg {

namespace {

bool apart(const Aabb& a, const Aabb& b) { return a.intersected(b).empty(); }

Draft leaf(PartId part, bool inverted, const SolidStore& store)
{
    Draft made{.solid = part, .inverted = inverted};
    with_solid(store, part, [&](const auto& solid) {
        using T = std::decay_t<decltype(solid)>;
        if constexpr (std::is_same_v<T, Plane>) {  // the other half-space is as good a solid
            made.half_space = inverted ? Plane{-solid.normal_out, -solid.offset} : solid;
            made.box = made.half_space->bounds();
        } else {
            made.box = solid.bounds();
            made.inside_beyond = inverted && bounds_space(solid);
        }
    });
    return made;
}

bool holds_operands(const Draft& draft) { return draft.op == Op::Intersection || draft.op == Op::Clip; }

/// Half-spaces and quadrics that hold all of an intersection, those of intersections inside of it among them.
void gather(const Draft& draft, const SolidStore& store, std::vector<Plane>& planes,
            std::vector<const Quadric*>& quadrics)
{
    for (const Draft& operand : draft.operands) {
        if (operand.half_space) planes.push_back(*operand.half_space);
        else if (operand.op == Op::Leaf && !operand.inverted && kind_of(operand.solid) == SolidKind::Quadric)
            quadrics.push_back(&store.all<Quadric>()[index_of(operand.solid)]);
        else if (holds_operands(operand)) gather(operand, store, planes, quadrics);
    }
}

/// Box of an intersection: what operands without an end leave of its operands' common box, which may be open.
Aabb closed_box(const Draft& draft, const SolidStore& store)
{
    std::vector<Plane> planes;
    std::vector<const Quadric*> quadrics;
    gather(draft, store, planes, quadrics);
    Aabb box = draft.box.finite() ? draft.box : polyhedron_box(planes, draft.box);
    for (const Quadric* quadric : quadrics) box = quadric_box(*quadric, planes, box);
    return box;
}

/// Box and what lies beyond it, from the operands'.
void enclose(Draft& draft, const SolidStore& store)
{
    if (draft.op == Op::Guard) {
        draft.box = draft.operands[0].box;
        draft.inside_beyond = draft.operands[0].inside_beyond;
        return;
    }
    const bool both = holds_operands(draft);
    Aabb hull, common = Aabb::everything();
    bool any_beyond = false, all_beyond = true;
    for (const Draft& operand : draft.operands) {
        hull.include(operand.box);
        any_beyond = any_beyond || operand.inside_beyond;
        all_beyond = all_beyond && operand.inside_beyond;
        if (!operand.inside_beyond) common = common.intersected(operand.box);
    }
    draft.inside_beyond = both ? all_beyond : any_beyond;
    draft.box = both && !all_beyond ? common : hull;
    if (both && !all_beyond && !draft.box.empty()) draft.box = closed_box(draft, store);
    if (draft.box.empty()) draft.box = Aabb{};
}

/// Operands of an intersection that hold all of it and draw nothing in it: subtrahends elsewhere.
void drop_useless(Draft& draft, Pruning& pruning)
{
    if (!pruning.on) return;
    if (draft.op == Op::Intersection && !draft.inside_beyond)
        pruning.dropped += std::erase_if(draft.operands, [&](const Draft& operand) {
            return operand.inside_beyond && apart(operand.box, draft.box);
        });
    if (draft.op == Op::Union || draft.op == Op::Merge)
        pruning.dropped += std::erase_if(
            draft.operands, [](const Draft& operand) { return !operand.inside_beyond && operand.box.empty(); });
}

void reverse(Draft& draft) { draft.reversed = !draft.reversed; }

/// Operands of the same operator join their parent. One intersection reverses what another one inside it has reversed
/// already, so all below the inner one comes in reverse: which of two coincident faces is last stays the same.
void join(Draft& draft, Draft operand)
{
    if (operand.op != draft.op || draft.op == Op::Clip || draft.op == Op::Guard || draft.op == Op::Merge) {
        draft.operands.push_back(std::move(operand));
        return;
    }
    if (draft.op == Op::Intersection) reverse(operand);
    if (operand.reversed) {
        std::reverse(operand.operands.begin(), operand.operands.end());
        for (Draft& inner : operand.operands) reverse(inner);
    }
    for (Draft& inner : operand.operands) draft.operands.push_back(std::move(inner));
}

/// How often a tree was turned inside out, its parents' turns counted.
struct Turns {
    bool inverted = false, ever = false;
    Turns flipped(bool again) const { return again ? Turns{!inverted, true} : *this; }
};

Draft draft_of(const Tree& tree, Turns turns, const SolidStore& store, Pruning& pruning);

Draft shape_of(const Tree& tree, Turns turns, const SolidStore& store, Pruning& pruning)
{
    const bool inverted = turns.inverted;
    if (tree.op == Tree::Op::Leaf) return leaf(tree.solid, inverted, store);
    Draft made;
    const bool unites = tree.op == Tree::Op::Union || tree.op == Tree::Op::Merge;
    if (unites)
        made.op = inverted                                    ? Op::Intersection
                  : tree.op == Tree::Op::Union && !turns.ever ? Op::Union
                                                              : Op::Merge;  // twice turned it has no inner surfaces
    else made.op = inverted ? Op::Merge : Op::Intersection;
    const bool clipped_union = made.op == Op::Union && !tree.clips.empty();
    for (std::size_t i = 0; i < tree.operands.size(); ++i) {
        const bool subtracted = tree.op == Tree::Op::Difference && i > 0;
        Draft operand = draft_of(tree.operands[i], turns.flipped(subtracted), store, pruning);
        if (clipped_union) reverse(operand);
        join(made, std::move(operand));
    }
    enclose(made, store);
    drop_useless(made, pruning);
    if (made.operands.size() == 1) {
        Draft only = std::move(made.operands.front());
        if (reverses(made.op)) reverse(only);
        return only;
    }
    return made;
}

/// The shape with others that do something to it and are not drawn.
Draft under(Op op, Draft shape, const std::vector<Tree>& others, const SolidStore& store, Pruning& pruning)
{
    if (others.empty()) return shape;
    Draft made{.op = op};
    made.operands.push_back(std::move(shape));
    for (const Tree& other : others) made.operands.push_back(draft_of(other, {}, store, pruning));
    enclose(made, store);
    return made;
}

Draft draft_of(const Tree& tree, Turns turns, const SolidStore& store, Pruning& pruning)
{
    Draft clipped =
        under(Op::Clip, shape_of(tree, turns.flipped(tree.inverse), store, pruning), tree.clips, store, pruning);
    return under(Op::Guard, std::move(clipped), tree.bounds, store, pruning);
}

}  // namespace

Draft draft_of(const Tree& tree, const SolidStore& store, Pruning& pruning)
{
    return draft_of(tree, {}, store, pruning);
}

}  // namespace csg
