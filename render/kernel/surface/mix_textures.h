#pragma once

#include "render/kernel/context/context.h"
#include "render/kernel/context/shade_scratch.h"
#include "render/kernel/record/recorder.h"

namespace trace {

/// Calls shade(entry, slot) for the entries of a texture map that a point shows, whose colours are mixed into `out`.
template <class Shade>
void mix_textures(Context& context, const texture::Blend& blend, ColorSlot out, Shade&& of_entry)
{
    const auto shade = [&](std::uint32_t entry, ColorSlot slot) {
        tell<&Recorder::entry>(context.scratch.shade, slot, entry, true);
        of_entry(entry, slot);
    };
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

/// A node of weighted terms; their slots are asked for by slot_of() before each term's texture is gone through.
struct WeightedNode {
    RayQueue& queue;
    std::uint32_t index, first;

    WeightedNode(Context& context, ShadeNode::Kind kind, std::size_t count, ColorSlot out)
        : queue(context.scratch.shade.queue), index(static_cast<std::uint32_t>(queue.nodes.size()))
    {
        ShadeNode& node = queue.new_node(kind, out);
        node.count = static_cast<std::uint32_t>(count);
        first = node.first = queue.new_terms(count);
    }
    ColorSlot slot_of(std::size_t term, float weight)
    {
        ShadeTerm& of = queue.terms[first + term];
        of.factor = glm::vec3(weight);
        return of.slot = queue.new_slot();
    }
};

/// Calls shade(entry, slot) for every entry of an average of textures; their mean by weights goes to `out`.
template <class Shade>
void average_textures(Context& context, const texture::Texture& texture, ColorSlot out, Shade&& shade)
{
    WeightedNode node(context, ShadeNode::Kind::Mean, texture.count, out);
    float weights = 0;
    for (std::uint32_t i = 0; i < texture.count; ++i) {
        const float w = context.scene.textures.keys[texture.first + i];
        weights += w;
        shade(texture.first + i, node.slot_of(i, w));
    }
    node.queue.nodes[node.index].weights = weights;
}

}  // namespace trace
