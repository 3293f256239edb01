#include "render/plan/geometry/hidden_operands.h"

#include "render/plan/surface.h"

#include <algorithm>
#include <map>

namespace plan {
namespace {

constexpr RayKind kKinds[] = {RayKind::Image,  RayKind::Reflection,     RayKind::Shadow,
                              RayKind::Photon, RayKind::MirroredPhoton, RayKind::Gather};

/// Whether each kind sees each operand that is hidden from some, a bit for one after the other.
void collect(const csg::Tree& tree, std::vector<std::uint8_t>& hidden)
{
    if (tree.hidden_from != 0) hidden.push_back(tree.hidden_from);
    for (const csg::Tree& operand : tree.operands) collect(operand, hidden);
}

/// Whether some operand of it is hidden from the kind.
bool hides(const csg::Tree& tree, std::uint8_t kind)
{
    return std::any_of(tree.operands.begin(), tree.operands.end(), [kind](const csg::Tree& operand) {
        return (operand.hidden_from & kind) != 0 || hides(operand, kind);
    });
}

/// An operand as the intersection has it that a difference is.
csg::Tree turned(const csg::Tree& whole, const csg::Tree& operand, csg::Tree as)
{
    as.inverse ^= whole.op == csg::Tree::Op::Difference && &operand != &whole.operands.front();
    as.hidden_from = 0;
    return as;
}

}  // namespace

bool shadowless(const scene::Object& object)
{
    if (object.flags.no_shadow) return true;
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    if (csg == nullptr || csg->op != scene::CsgOp::Union) return false;
    const std::vector<scene::Object>& all = *csg->operands;
    return !std::all_of(all.begin(), all.end(), scene::is_light) &&
           std::all_of(all.begin(), all.end(),
                       [](const scene::Object& one) { return scene::is_light(one) || shadowless(one); });
}

std::uint8_t hidden_from(const scene::Object& operand, scene::CsgOp in)
{
    if (in != scene::CsgOp::Union && in != scene::CsgOp::Merge) return 0;
    unsigned kinds = 0;
    if (operand.flags.no_image && in == scene::CsgOp::Merge) kinds |= bit(RayKind::Image);
    if (operand.flags.no_reflection) kinds |= bit(RayKind::Reflection) | bit(RayKind::MirroredPhoton);
    if (operand.flags.no_radiosity) kinds |= bit(RayKind::Gather);
    return static_cast<std::uint8_t>(kinds);
}

std::vector<std::uint8_t> views_of(const csg::Tree& tree)
{
    std::vector<std::uint8_t> hidden;
    collect(tree, hidden);
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

std::optional<csg::Tree> seen_by(const csg::Tree& tree, std::uint8_t kind)
{
    if ((tree.hidden_from & kind) != 0) return std::nullopt;
    if (!hides(tree, kind)) return tree;
    csg::Tree seen = tree;
    seen.operands.clear();
    seen.op = csg::Tree::Op::Union;
    const bool unites = tree.op == csg::Tree::Op::Union || tree.op == csg::Tree::Op::Merge;
    if (unites) seen.op = tree.op;
    else seen.inverse = false;
    for (const csg::Tree& operand : tree.operands) {
        std::optional<csg::Tree> one = seen_by(operand, kind);
        if (!one) continue;
        if (!unites) {
            one = turned(tree, operand, std::move(*one));
            one->inverse ^= tree.inverse;
            for (const csg::Tree& other : tree.operands)
                if (&other != &operand) one->clips.push_back(turned(tree, other, other));
        }
        seen.operands.push_back(std::move(*one));
    }
    if (seen.operands.empty()) return std::nullopt;
    return seen;
}

}  // namespace plan
