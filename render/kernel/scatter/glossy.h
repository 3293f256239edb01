#pragma once

#include "render/kernel/extensions/rough_mirror.h"
#include "render/kernel/scatter/refraction.h"
#include "render/kernel/scatter/scatter.h"
#include "numbers/random.h"
#include "render/kernel/tile/sobol.h"

namespace trace {

/// The mean of rays around a mirrored one, for a rough mirror: directions by a power of the cosine to it, from a set
/// that is scrambled anew for each hit. Rays off a rough mirror already are many: each has one.
[[gnu::noinline]] inline ColorSlot glossy(Context& context, const HitPlace& hit, const texture::FinishExtension& rough,
                                          const RayState& sharp)
{
    RayQueue& queue = context.scratch.shade.queue;
    const int samples = hit.state.scattered ? 1 : rough.gloss_samples;
    const ColorSlot out = queue.new_slot();
    const std::uint32_t first = queue.new_terms(static_cast<std::size_t>(samples));
    ShadeNode& node = queue.new_node(ShadeNode::Kind::Mean, out);
    node.first = first;
    node.count = static_cast<std::uint32_t>(samples);
    node.weights = static_cast<float>(samples);
    const auto seed = static_cast<std::uint32_t>(numbers::random_seed(hit.point, sharp.ray.direction));
    const RoughLobe lobe(rough, sharp.ray.direction, hit.normal);
    for (int i = 0; i < samples; ++i) {
        RayState ray = sharp;
        ray.scattered = true;
        ray.ray.direction = lobe.direction(sobol_point(seed, static_cast<std::uint32_t>(i)));
        ray.start = start_of(context, hit, ray.ray.direction);
        ++context.scratch.counts.reflected;
        const ColorSlot seen = queue_ray(context, queue.mirrors, ray, false);
        ShadeTerm& term = queue.terms[first + static_cast<std::uint32_t>(i)];
        term.slot = seen;
        term.factor = glm::vec3(1);
    }
    return out;
}

}  // namespace trace
