#pragma once

#include "render/kernel/path/lamp_faces.h"
#include "render/kernel/path/lamps.h"
#include "render/kernel/light/shadow_filter.h"

#include <algorithm>

namespace trace::path {

/// Shadow rays from the hits of a tile, each to a lamp of its own.
class LampRays {
public:
    /// \param faces of lamps that paths meet where light is bent: shadow rays to those end there
    LampRays(Context& context, const LampFaces& faces) : context_(context), faces_(faces) {}

    void begin() { asked_ = count_ = 0; }

    /// Hit k asks for a lamp. carried: what the path makes of the light.
    void ask(std::size_t k, const HitPlace& hit, const Bsdf& bsdf, const glm::vec3& carried, Draws& draws)
    {
        if (context_.lights.lights.empty()) return;
        const LampSample sample = sample_lamp(context_, hit, bsdf, chances_, draws);
        if (sample.light == nullptr) return;
        Asked& to = asked_rays_[asked_++];
        to = {k,
              sample.lit,
              sample.weight * carried,
              hit.point,
              context_.scene.tolerance.shadow_from(hit.point, hit.met.t),
              &hit.state.interiors,
              sample.light};
        const double end = sample.lit.distance - to.tolerance;
        to.ray = kNone;
        if ((sample.light->shadowless && !sample.light->projector) || end <= to.tolerance) return;
        rays_.set(count_, {hit.point, sample.lit.direction}, to.tolerance, end);
        to.ray = count_++;
    }

    /// give(k, light) for hits that a lamp reaches.
    template <class Give>
    void run(Give&& give)
    {
        if (asked_ == 0) return;
        if (count_ > 0) {
            rays_.count = static_cast<int>(count_);
            rays_.common_origin = false;
            context_.scratch.counts.shadow += count_;
            context_.world.shadow(rays_, context_.scratch.geometry, endings_.data());
        }
        for (std::size_t i = 0; i < asked_; ++i) {
            const Asked& of = asked_rays_[i];
            if (of.ray != kNone && endings_[of.ray] == Shadow::Blocked) continue;
            const bool clear = of.ray == kNone || endings_[of.ray] == Shadow::Clear;
            glm::vec3 color = of.lit.color;
            if (of.ray != kNone && (!clear || of.light->atmosphere)) {
                color = filtered_light(context_, of.point, of.tolerance, *of.interiors, of.lit, color,
                                       {of.light->atmosphere});
                if (!clear && bent() && faces_.has(*of.light)) continue;
            }
            give(of.hit, of.weight * color);
        }
    }

private:
    /// Whether the shadow ray that was filtered last crosses what bends light.
    bool bent() const
    {
        const plan::CompiledScene& scene = context_.scene;
        const auto& met = context_.scratch.crossings;
        return std::any_of(met.begin(), met.end(),
                           [&](const Hit& hit) { return bends(scene, scene.surfaces[hit.surface]); });
    }

    static constexpr std::size_t kNone = ~std::size_t{0};
    struct Asked {
        std::size_t hit;
        light::Illumination lit;
        glm::vec3 weight;
        glm::dvec3 point;
        double tolerance;
        const InteriorList* interiors;
        const light::Light* light;
        std::size_t ray = 0;
    };
    Context& context_;
    const LampFaces& faces_;
    std::vector<double> chances_;
    std::array<Asked, kTileRays> asked_rays_;
    std::size_t asked_ = 0, count_ = 0;
    RayTile rays_;
    std::array<Shadow, kTileRays> endings_;
};

}  // namespace trace::path
