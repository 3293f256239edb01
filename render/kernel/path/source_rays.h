#pragma once

#include "render/kernel/path/sources.h"
#include "render/kernel/path/surface.h"
#include "render/kernel/air/sky.h"
#include "render/kernel/tile/nearly_zero.h"

namespace trace::path {

/// Share of a direction's light that one of two ways to find it takes, by their densities (balance heuristic, Veach
/// 1995).
inline float mis_weight(double own, double other) { return static_cast<float>(own / (own + other)); }

/// Rays from the hits of a tile to light that paths may meet as well, with what weighs it against those.
class SourceRays {
public:
    /// \param sources null: there is nothing to aim at
    SourceRays(Context& context, const Sources* sources) : context_(context), sources_(sources) {}

    /// Whether a hit's light is asked for: then the densities below tell what its paths count. Not within bodies nor in
    /// air that dims, where paths find all of it.
    bool asks(const InteriorList& around) const { return sources_ != nullptr && around.empty() && !air_; }
    void set_air(bool dims) { air_ = dims; }

    void begin() { count_ = 0; }

    /// Hit k aims at a source. carried: what the path makes of the light.
    void ask(std::size_t k, const HitPlace& hit, const Bsdf& bsdf, const glm::vec3& carried, Draws& draws)
    {
        const double which = draws.one();
        const auto u = draws.pair();
        Asked& to = asked_[count_];
        glm::dvec3 direction;
        to.face = Emitter::kAnyFace;
        if (which < sources_->sky_chance()) {
            to.source = Sources::kNone;
            direction = sources_->sky->sample(u);
            to.pdf = sources_->sky_chance() * sources_->sky->density(direction);
        } else {
            to.source = choose((which - sources_->sky_chance()) / (1.0 - sources_->sky_chance()));
            const Emitter& body = sources_->emitters[to.source];
            to.pdf = chance(body) * body.sample(hit.point, u, direction, to.face);
        }
        if (!(to.pdf > 0.0)) return;
        const Response response = bsdf.respond(direction);
        if (black(response.value)) return;
        to.hit = k;
        to.weight = carried * response.value * (mis_weight(to.pdf, response.pdf) / static_cast<float>(to.pdf));
        rays_.set(count_, {hit.point, direction}, start_of(context_, hit, direction), numbers::kInfinity);
        ++count_;
    }

    /// give(k, light) for hits whose ray meets what it was meant for.
    template <class Give>
    void run(Give&& give)
    {
        if (count_ == 0) return;
        rays_.count = static_cast<int>(count_);
        rays_.common_origin = false;
        context_.scratch.counts.shadow += count_;
        context_.world.nearest(rays_, bit(plan::RayKind::Gather), context_.scratch.geometry, hits_);
        for (std::size_t i = 0; i < count_; ++i) {
            const Asked& of = asked_[i];
            const Hit hit = hits_.at(static_cast<int>(i));
            if (of.source == Sources::kNone) {
                if (hit.found()) continue;
                give(of.hit, of.weight * sky_color(context_, rays_.ray(static_cast<int>(i)), true).rgb());
            } else if (hit.found() && met(hit) == of.source && sources_->emitters[of.source].is(of.face, hit.face)) {
                give(of.hit, of.weight * sources_->emitters[of.source].radiance);
            }
        }
    }

    /// The emitter that was met, or kNone.
    std::uint32_t met(const Hit& hit) const
    {
        return hit.instance == Hit::kNoInstance ? sources_->find(hit.part) : Sources::kNone;
    }

    /// What light counts that a path meets which left a hit in a direction of density `pdf`; 0: no ray was sent for it.
    float weight_of_sky(double pdf, const glm::dvec3& direction) const
    {
        if (!(pdf > 0.0) || sources_->sky == nullptr) return 1.0f;
        return mis_weight(pdf, sources_->sky_chance() * sources_->sky->density(direction));
    }
    float weight_of(double pdf, const csg::Ray& ray, const Hit& hit) const
    {
        if (!(pdf > 0.0)) return 1.0f;
        const std::uint32_t source = met(hit);
        if (source == Sources::kNone) return 1.0f;
        const Emitter& body = sources_->emitters[source];
        return mis_weight(pdf, chance(body) * body.density(ray.origin, ray.direction, hit.t, hit.face));
    }

private:
    double chance(const Emitter& body) const { return (1.0 - sources_->sky_chance()) * body.chance; }
    std::uint32_t choose(double u) const
    {
        std::uint32_t i = 0;
        for (; i + 1 < sources_->emitters.size() && u >= sources_->emitters[i].chance; ++i)
            u -= sources_->emitters[i].chance;
        return i;
    }

    struct Asked {
        std::size_t hit;
        std::uint32_t source, face;
        glm::vec3 weight;
        double pdf;
    };
    Context& context_;
    const Sources* sources_;
    bool air_ = false;
    std::array<Asked, kTileRays> asked_;
    std::size_t count_ = 0;
    RayTile rays_;
    HitTile hits_;
};

}  // namespace trace::path
