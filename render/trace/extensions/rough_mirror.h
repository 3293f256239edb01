#pragma once

#include "numbers/random.h"
#include "render/trace/sampling/sobol.h"
#include "render/trace/shade/refraction.h"

#include <cmath>
#include <numbers>

/// Rough mirrors: docs/extensions.md. Compiled once per instruction set.
namespace trace {

/// Directions around a mirrored one, as dense as a power of the cosine to it.
class RoughLobe {
public:
    RoughLobe(const texture::FinishExtension& rough, const glm::dvec3& mirrored, const glm::dvec3& normal)
        : exponent_(static_cast<double>(rough.gloss_exponent)), w_(mirrored), normal_(normal),
          u_(glm::normalize(glm::cross(w_, std::abs(w_.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)))),
          v_(glm::cross(w_, u_))
    {}

    /// \param at both in [0, 1)
    glm::dvec3 direction(const std::array<double, 2>& at) const
    {
        constexpr double kTurn = 2.0 * std::numbers::pi;
        const auto [a, b] = at;
        const double cosine = std::pow(1.0 - a, 1.0 / (exponent_ + 1.0)),
                     sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
        glm::dvec3 d = cosine * w_ + sine * (std::cos(kTurn * b) * u_ + std::sin(kTurn * b) * v_);
        const double away = glm::dot(d, normal_);
        if (away < 0.0) d -= 2.0 * away * normal_;  // folded back out, as a bent normal's mirrored ray is
        return glm::normalize(d);
    }

private:
    double exponent_;
    glm::dvec3 w_, normal_, u_, v_;
};

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
    const auto seed = static_cast<std::uint32_t>(random_seed(hit.point, sharp.ray.direction));
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
