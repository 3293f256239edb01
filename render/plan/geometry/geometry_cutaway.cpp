#include "render/plan/geometry/geometry.h"

#include <utility>

namespace plan {
namespace {

scene::TexturePtr average(const scene::TexturePtr& a, const scene::TexturePtr& b)
{
    scene::PatternedTexture both;
    both.pattern.name = "average";
    both.map = {{1.0, a}, {1.0, b}};
    return std::make_shared<scene::Texture>(scene::Texture{scene::Shared(std::move(both)), a->source});
}

}  // namespace

/// Only parts of what is an intersection once inversion is pushed down stay without texture; others get the default.
bool takes_cut_texture(const scene::Object& operand, bool subtracted)
{
    const auto* csg = std::get_if<scene::Csg>(&operand.shape);
    if (csg == nullptr) return true;
    const bool unites = csg->op == scene::CsgOp::Union || csg->op == scene::CsgOp::Merge;
    return unites == (subtracted != operand.inverse);
}

/// A difference from a union is the union of the differences from its parts, so that each cut shows its own part. Two
/// parts that overlap are followed by what they share: there the cut shows the average, being the last of equal
/// crossings.
csg::Tree GeometryCompiler::cut_parts(const scene::Csg& csg, const scene::Csg& parts, const scene::Object& whole,
                                      const Inherited& own, const Inherited& of_whole)
{
    csg::Tree made;
    made.op = csg::Tree::Op::Union;
    const auto cut = [&](csg::Tree from, const PlacedTexture& texture) {
        csg::Tree difference;
        difference.op = csg::Tree::Op::Difference;
        difference.operands.push_back(std::move(from));
        Inherited later = own;
        later.texture = texture;
        for (const scene::Object& cutter : *csg.operands)
            if (&cutter != &whole && !is_light(cutter))
                difference.operands.push_back(
                    tree(cutter, within(cutter, takes_cut_texture(cutter, true) ? later : own)));
        made.operands.push_back(std::move(difference));
    };
    std::vector<std::pair<csg::Tree, PlacedTexture>> known;
    for (const scene::Object& part : *parts.operands) {
        if (is_light(part)) continue;
        const Inherited mine = within(part, of_whole);
        known.emplace_back(tree(part, mine), cut_texture(part, mine));
        cut(known.back().first, known.back().second);
    }
    for (std::size_t i = 0; i < known.size(); ++i)
        for (std::size_t k = i + 1; k < known.size(); ++k) {
            const auto& [a, a_texture] = known[i];
            const auto& [b, b_texture] = known[k];
            if (!a_texture || !b_texture || a_texture == b_texture) continue;
            csg::Tree both;
            both.op = csg::Tree::Op::Intersection;
            both.operands = {a, b};
            cut(std::move(both), {average(written_there(a_texture), written_there(b_texture))});
        }
    return made;
}

/// What a cut through `object` shows under cutaway_textures (spec 5a, 8.3), as far as one texture can say it: its own
/// or the first that its operands have.
PlacedTexture GeometryCompiler::cut_texture(const scene::Object& object, const Inherited& own)
{
    if (own.texture) return own.texture;
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    if (csg == nullptr) return {};
    for (const scene::Object& operand : *csg->operands) {
        if (is_light(operand)) continue;
        const PlacedTexture found = cut_texture(operand, below(operand, own));
        if (found || csg->op == scene::CsgOp::Difference) return found;
    }
    return {};
}

}  // namespace plan
