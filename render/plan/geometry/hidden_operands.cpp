#include "render/plan/geometry/hidden_operands.h"

#include "render/plan/surface.h"

#include <algorithm>
#include <map>

namespace plan {
namespace {

constexpr RayKind kKinds[] = {RayKind::Image,  RayKind::Reflection,     RayKind::Shadow,
                              RayKind::Photon, RayKind::MirroredPhoton, RayKind::Gather};

bool unites(const csg::Tree& tree) { return tree.op == csg::Tree::Op::Union || tree.op == csg::Tree::Op::Merge; }

/// Kinds that go past an operand of this tree. The operands of an intersection hide nothing. What is inverted became
/// one if it unites and else a merge, and what is inverted twice a merge. A union hides from no camera ray.
std::uint8_t hidden(const csg::Tree& tree, const csg::Tree& operand, bool inverted)
{
    if (unites(tree) != (inverted == tree.inverse)) return 0;
    const bool is_union = tree.op == csg::Tree::Op::Union && !inverted;
    return static_cast<std::uint8_t>(operand.hidden_from & (is_union ? ~bit(RayKind::Image) : ~0));
}

/// Whether the operand is inverted by all that hold it.
bool inverts(const csg::Tree& tree, const csg::Tree& operand, bool inverted)
{
    const bool subtracted = tree.op == csg::Tree::Op::Difference && &operand != &tree.operands.front();
    return (inverted != tree.inverse) != subtracted;
}

/// The kinds that each operand is hidden from which is hidden from some.
void collect(const csg::Tree& tree, bool inverted, std::vector<std::uint8_t>& out)
{
    for (const csg::Tree& operand : tree.operands) {
        if (const std::uint8_t from = hidden(tree, operand, inverted); from != 0) out.push_back(from);
        collect(operand, inverts(tree, operand, inverted), out);
    }
}

/// Whether some operand of it is hidden from the kind.
bool hides(const csg::Tree& tree, std::uint8_t kind, bool inverted)
{
    return std::any_of(tree.operands.begin(), tree.operands.end(), [&](const csg::Tree& operand) {
        return (hidden(tree, operand, inverted) & kind) != 0 || hides(operand, kind, inverts(tree, operand, inverted));
    });
}

/// An operand as the intersection has it that a difference is.
csg::Tree turned(const csg::Tree& whole, const csg::Tree& operand, csg::Tree as)
{
    as.inverse ^= whole.op == csg::Tree::Op::Difference && &operand != &whole.operands.front();
    as.hidden_from = 0;
    return as;
}

/// An inverted intersection, which became a merge. What its operands hold shows in full.
std::optional<csg::Tree> seen_of_turned(const csg::Tree& tree, std::uint8_t kind, bool inverted)
{
    csg::Tree out = tree;
    out.op = csg::Tree::Op::Intersection;
    out.operands.clear();
    for (const csg::Tree& operand : tree.operands)
        if ((hidden(tree, operand, inverted) & kind) == 0) out.operands.push_back(turned(tree, operand, operand));
    if (out.operands.empty()) return std::nullopt;
    return out;
}

std::optional<csg::Tree> seen(const csg::Tree& tree, std::uint8_t kind, bool inverted)
{
    if (!hides(tree, kind, inverted)) return tree;
    if (!unites(tree) && inverted != tree.inverse) return seen_of_turned(tree, kind, inverted);
    csg::Tree out = tree;
    out.operands.clear();
    if (!unites(tree)) out.op = csg::Tree::Op::Union;
    for (const csg::Tree& operand : tree.operands) {
        if ((hidden(tree, operand, inverted) & kind) != 0) continue;
        std::optional<csg::Tree> one = seen(operand, kind, inverts(tree, operand, inverted));
        if (!one) continue;
        if (!unites(tree)) {
            one = turned(tree, operand, std::move(*one));
            for (const csg::Tree& other : tree.operands)
                if (&other != &operand) one->clips.push_back(turned(tree, other, other));
        }
        out.operands.push_back(std::move(*one));
    }
    if (out.operands.empty()) return std::nullopt;
    return out;
}

}  // namespace

bool shadowless(const scene::Object& object)
{
    if (object.flags.no_shadow) return true;
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    if (csg == nullptr || csg->op != scene::CsgOp::Union || object.inverse) return false;
    const std::vector<scene::Object>& all = *csg->operands;
    return !std::all_of(all.begin(), all.end(), scene::is_light) &&
           std::all_of(all.begin(), all.end(),
                       [](const scene::Object& one) { return scene::is_light(one) || shadowless(one); });
}

std::uint8_t hidden_from(const HidingFlags& flags)
{
    unsigned kinds = 0;
    if (flags.no_image) kinds |= bit(RayKind::Image);
    if (flags.no_reflection) kinds |= bit(RayKind::Reflection) | bit(RayKind::MirroredPhoton);
    if (flags.no_radiosity) kinds |= bit(RayKind::Gather);
    return static_cast<std::uint8_t>(kinds);
}

std::vector<std::uint8_t> views_of(const csg::Tree& tree)
{
    std::vector<std::uint8_t> hidden;
    collect(tree, false, hidden);
    if (hidden.empty()) return {0xff};  // as a rule
    std::map<std::vector<bool>, unsigned> groups;
    for (const RayKind kind : kKinds) {
        std::vector<bool> sees;
        for (const std::uint8_t from : hidden) sees.push_back((from & bit(kind)) == 0);
        groups[sees] |= bit(kind);
    }
    std::vector<std::uint8_t> out;
    for (const auto& [sees, kinds] : groups) out.push_back(static_cast<std::uint8_t>(kinds));
    return out;
}

std::optional<csg::Tree> seen_by(const csg::Tree& tree, std::uint8_t kind) { return seen(tree, kind, false); }

}  // namespace plan
