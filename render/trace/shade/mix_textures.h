#pragma once

#include "render/trace/shade/shade_context.h"
#include "render/trace/shade/shade_scratch.h"

namespace trace {

/// The hit goes through the textures of a map from here on. It stays there: normals of neighbours that are looked at
/// later go through its transformations too, as in POV-Ray.
inline void enclose(HitContext& hit, std::uint32_t map)
{
    if (hit.enclosing_count < hit.enclosing.size()) hit.enclosing[hit.enclosing_count++] = map;
}

/// Calls shade(entry, slot) for the entries of a texture map that a point shows, whose colours are mixed into `out`.
template <class Shade>
void mix_textures(Context& context, const texture::Blend& blend, ColorSlot out, Shade&& shade)
{
    if (blend.lower == blend.upper) return shade(blend.upper, out);
    RayQueue& queue = context.scratch.shade.queue;
    const ColorSlot upper = queue.new_slot(), lower = queue.new_slot();
    const std::uint32_t term = queue.new_terms(1);
    queue.terms[term].slot = upper;
    ShadeNode& node = queue.new_node(ShadeNode::Kind::Mix, out);
    node.through = lower;
    node.first = term;
    node.count = 1;
    node.share = blend.share;
    // The upper one first: a slope in the lower one sees the normal that it leaves (spec 4, 15.1).
    shade(blend.upper, upper);
    shade(blend.lower, lower);
}

}  // namespace trace
