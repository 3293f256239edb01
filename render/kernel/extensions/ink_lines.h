#pragma once

#include "numbers/functions/functions.h"
#include "render/kernel/context/context.h"

/// Ink lines: docs/extensions.md.
namespace trace {

/// Whether what the camera sees there is drawn as a line: next to it the view leaves the object for something farther
/// off, or the object turns by more than the angle of a crease. Four rays beside the hit's own tell.
[[gnu::noinline]] inline bool on_ink_line(Context& context, const HitPlace& hit, std::uint32_t texture)
{
    const texture::TextureSet& set = context.scene.textures;
    const texture::Texture& of = set.textures[texture];
    if (hit.state.level != 0 || of.kind != texture::Texture::Kind::Layers || of.count == 0) return false;
    const std::uint32_t index = set.finishes[set.layers[of.first + of.count - 1].finish].extension;
    if (index == texture::kNone || !(set.extensions[index].ink > 0.0)) return false;
    const texture::FinishExtension& drawn = set.extensions[index];
    const glm::dvec3 w = hit.state.ray.direction;
    const glm::dvec3 u = glm::normalize(glm::cross(w, std::abs(w.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0))),
                     v = glm::cross(w, u);
    const double aside = numbers::tan(drawn.ink);
    for (const glm::dvec3& way : {u, -u, v, -v}) {
        const csg::Ray ray{hit.state.ray.origin, glm::normalize(w + aside * way)};
        const Hit near = context.world.nearest(ray, context.scene.tolerance.hit, numbers::kInfinity,
                                               bit(hit.state.kind), context.scratch.geometry);
        if (!near.found()) return true;
        if (context.scene.surfaces[near.surface].object != hit.surface.object) {
            if (near.t > hit.met.t) return true;
            continue;  // the line belongs to what stands in front
        }
        const glm::dvec3 normal = hit_details(context, ray, near).normal;
        if (std::abs(glm::dot(normal, hit.normal)) < drawn.ink_cosine) return true;
    }
    return false;
}

}  // namespace trace
