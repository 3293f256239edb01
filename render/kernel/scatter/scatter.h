#pragma once

#include "render/kernel/context/context.h"
#include "render/texture/finish.h"
#include "render/kernel/tile/nearly_zero.h"

/// From the layers of a texture to the rays that go on.
namespace trace {

/// How much layers let through, at most 1.
inline float residual_of(const glm::vec3& filter) { return std::min(1.0f, std::abs(scene::grey(filter))); }

/// Weight of the ray off a mirror that reflects; residual: of the layers above.
inline float mirror_weight(float weight, float residual, const texture::Finish& finish, const glm::vec3& reflectivity)
{
    const float strength = finish.fresnel ? largest(reflectivity)
                                          : std::max(largest(finish.reflection_max), largest(finish.reflection_min));
    return weight * residual * std::max(0.0f, strength);
}

/// What the layers of a texture leave to the rays that go on.
struct LayerStack {
    explicit LayerStack(std::vector<Mirror>& reused) : mirrors(reused) { mirrors.clear(); }

    glm::vec3 filter{1};  ///< what they let through
    float residual = 1;   ///< how much that is, at most 1
    glm::dvec3 top_normal{0};
    std::vector<Mirror>& mirrors;  ///< of the layers so far, the top layer's first

    /// One layer more: its pigment lets light through, its finish mirrors some.
    void pass(const scene::Color& c, const texture::Finish& finish, const glm::vec3& reflectivity)
    {
        filter = texture::past_layer(filter, c, finish, reflectivity);
        residual = residual_of(filter);
    }
};

/// A layer's mirror at a hit; residual: of the layers above.
void find_mirror(const Context& context, const HitPlace& hit, const texture::Finish& finish, const scene::Color& c,
                 const glm::dvec3& normal, float residual, Mirror& mirror);

/// The node of a texture's layers, whose own light is still to come, with the rays that go on from it. Its index in the
/// queue.
std::uint32_t scatter(Context& context, const HitPlace& hit, const LayerStack& stack, ColorSlot out);

/// A ray that goes on from a hit: in `queue`, if it is worth tracing. The slot of its colour.
/// \param straight  it is not bent and uses no level (spec 3, section 2)
ColorSlot queue_ray(Context& context, std::vector<QueuedRay>& queue, const RayState& state, bool straight);

}  // namespace trace
