#include "render/kernel/photon/photon_tracer.h"

#include "render/kernel/interior/interior_fade.h"
#include "render/kernel/context/side_textures.h"
#include "render/kernel/extensions/rough_mirror.h"
#include "render/kernel/photon/photon_air.h"
#include "render/kernel/photon/photon_forest.h"
#include "render/kernel/scatter/refraction.h"
#include "render/kernel/tile/nearly_zero.h"
#include "numbers/random.h"
#include "render/kernel/tile/sobol.h"
#include "render/kernel/surface/shade_surface.h"

#include <algorithm>

namespace trace {
class PhotonTracer::Impl {
public:
    Impl(const plan::CompiledScene& scene, const std::atomic<bool>* cancel)
        : scene_(scene), plan_(*scene.photons), world_(scene.world()), context_(scene, scratch_, nullptr)
    {
        scratch_.geometry.cancel = csg::CancelWatch(cancel);
    }

    void follow(const PhotonFlight& flight, std::span<const Emission> photons, const JitterStream& jitter,
                PhotonYield& out)
    {
        fly(flight, photons, &jitter, &out);
        out.surface.clear();
        out.media.clear();
        out.surface_end.clear();
        out.media_end.clear();
        out.hit.clear();
        for (std::size_t i = 0; i < photons.size(); ++i) {
            if (has(dispersed_, i)) steps_.filter_samples(static_cast<std::uint32_t>(i), stay_);
            steps_.in_order(static_cast<std::uint32_t>(i), [&](std::uint32_t s) {
                const PhotonStep& step = steps_[s];
                const auto first = stay_.begin() + static_cast<std::ptrdiff_t>(step.media);
                out.media.insert(out.media.end(), first, first + static_cast<std::ptrdiff_t>(step.media_count));
                if (step.stays) out.surface.push_back(step.photon);
            });
            out.surface_end.push_back(static_cast<std::uint32_t>(out.surface.size()));
            out.media_end.push_back(static_cast<std::uint32_t>(out.media.size()));
            out.hit.push_back(has(hits_, i) ? 1 : 0);
        }
    }

    void count(const PhotonFlight& flight, std::span<const Emission> photons, PhotonYield& out)
    {
        fly(flight, photons, nullptr, nullptr);
        out.draws_end.clear();
        out.draws_before.assign(steps_.size(), 0);
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < photons.size(); ++i) {
            steps_.in_order(static_cast<std::uint32_t>(i), [&](std::uint32_t s) {
                out.draws_before[s] = sum;
                sum += steps_[s].draws;
            });
            out.draws_end.push_back(sum);
        }
    }

private:
    /// A photon between two surfaces.
    struct Flying {
        RayState state;
        glm::vec3 color;
        double depth;         ///< way from the light to the ray's origin
        std::uint32_t step;   ///< index among the tile's steps
        std::uint32_t root;   ///< which of the tile's photons it comes from
        bool seeking = true;  ///< for its target: all it has met was to be passed through
        bool passed = false;  ///< the surface before was passed through
        bool dispersed = false;
    };

    /// All ways of the photons. jitter, known: null to count draws; else PhotonYield::draws_before tells where each
    /// step's begin.
    void fly(const PhotonFlight& flight, std::span<const Emission> photons, const JitterStream* jitter,
             const PhotonYield* known)
    {
        flight_ = &flight;
        jitter_ = jitter;
        known_ = known;
        steps_.begin(photons.size());
        stay_.clear();
        flying_.clear();
        hits_ = dispersed_ = 0;
        Flying start{{}, glm::vec3(0.0f), 0.0, 0, 0};
        start.state.start = scene_.tolerance.hit;
        start.state.kind = plan::RayKind::Photon;
        for (const std::uint32_t interior : flight_->interiors) start.state.interiors.append(interior);
        for (std::size_t i = 0; i < photons.size(); ++i) {
            Flying& photon = flying_.emplace_back(start);
            photon.state.ray = {photons[i].origin, photons[i].direction};
            photon.color = photons[i].color;
            photon.depth = photons[i].depth;
            photon.step = photon.root = static_cast<std::uint32_t>(i);
        }
        while (!flying_.empty()) trace_some();
    }

    /// The photons that wait last, up to a tile of them that see the same.
    void trace_some()
    {
        const auto bits = [](const Flying& photon) { return bit(photon.state.kind); };
        const std::uint8_t both =
            static_cast<std::uint8_t>(bit(plan::RayKind::Photon) | bit(plan::RayKind::MirroredPhoton));
        const bool alike = world_.seen_by_all(both);
        std::size_t count = 1;
        while (count < std::min<std::size_t>(flying_.size(), kTileRays) &&
               (alike || bits(flying_[flying_.size() - 1 - count]) == bits(flying_.back())))
            ++count;
        const std::size_t first = flying_.size() - count;
        if (first == 0) {
            tracing_.swap(flying_);
            flying_.clear();
        } else {
            tracing_.assign(flying_.begin() + static_cast<std::ptrdiff_t>(first), flying_.end());
            flying_.resize(first);
        }
        rays_.count = static_cast<int>(count);
        rays_.common_origin = false;
        for (std::size_t i = 0; i < count; ++i)
            rays_.set(i, tracing_[i].state.ray, tracing_[i].state.start, numbers::kInfinity);
        world_.nearest(rays_, bits(tracing_[0]), scratch_.geometry, met_);
        for (std::size_t i = 0; i < count; ++i) {
            const Hit hit = met_.at(static_cast<int>(i));
            if (hit.found()) take_hit(tracing_[i], hit);
        }
    }

    /// The photon has met a surface.
    void take_hit(Flying& photon, const Hit& hit)
    {
        const plan::Surface& surface = scene_.surfaces[hit.surface];
        const plan::PhotonSurface& rules = plan_.surfaces[surface.photons];
        // On its way to the target through empty air it ends at all else.
        if (photon.seeking && rules.target != flight_->target && !rules.pass_through && photon.state.interiors.empty())
            return;
        const bool goes_on = sends_photons(hit.surface, rules), seeks_on = photon.seeking && rules.pass_through;
        HitDetails details{photon.state.ray.at(hit.t), glm::dvec3(0.0)};
        if (goes_on || seeks_on || photon.dispersed) details = hit_details(context_, photon.state.ray, hit);
        const bool inside = from_inside(details, photon.state.ray.direction);
        const HitPlace place{
            photon.state,           hit,   surface, details.point, inside ? -details.normal : details.normal,
            photon.state.level + 1, inside};
        cross_media(photon, place);
        photon.depth += hit.t;
        fade(photon, place);
        if (photon.seeking) {
            if (rules.target != flight_->target) {
                if (rules.pass_through) pass(photon, place, details);
                return;
            }
            hits_ |= HitMask{1} << photon.root;
        }
        if (place.level > 1 && !photon.passed && rules.collect) stay(photon, place);
        if (goes_on) go_on(photon, place, details, rules);
        else if (photon.dispersed) filter_of(photon, place, details);
    }

    /// Whether the surface may mirror this flight's photons or let them through.
    bool sends_photons(csg::SurfaceId surface, const plan::PhotonSurface& rules) const
    {
        if (!agree(rules.refraction, flight_->refraction) && !agree(rules.reflection, flight_->reflection))
            return false;
        const plan::SurfaceTraits& traits = context_.traits.surfaces[surface];
        const auto ends = [](const plan::SingleLayer& single) {
            return single.index != plan::kNone && !single.goes_on;
        };
        return !ends(traits.outer) || !ends(traits.inner);
    }

    /// Interior media on the way to a surface.
    void cross_media(Flying& photon, const HitPlace& place)
    {
        if (photon.state.interiors.empty()) return;
        const bool leaves = place.level > 1 && !photon.passed && plan_.settings.media_steps > 0;
        const PhotonStretch stretch{photon.state.ray, place.met.t,  photon.state.interiors,
                                    place.surface,    photon.depth, leaves};
        PhotonStep& step = steps_[photon.step];
        if (jitter_ == nullptr) {
            step.draws = air_.draws(*flight_, stretch);
            return;
        }
        JitterStream jitter = *jitter_;
        if (!known_->draws_before.empty()) jitter.skip(known_->draws_before[photon.step]);
        step.media = stay_.size();
        air_.cross(*flight_, stretch, jitter, photon.color);
        step.media_count = stay_.size() - step.media;
    }

    /// Light fades inside of the surface's own interior.
    void fade(Flying& photon, const HitPlace& place) const
    {
        const std::uint32_t interior = place.surface.interior;
        if (interior == plan::kNone || !photon.state.interiors.holds(interior)) return;
        photon.color *= interior_fade(scene_.interiors[interior], place.met.t, true);
    }

    /// Straight on through what is to be passed through.
    void pass(const Flying& photon, const HitPlace& place, const HitDetails& details)
    {
        const glm::vec3 filter = filter_of(photon, place, details);
        Flying next = photon;
        next.color *= filter;
        next.passed = true;
        next.state.ray.origin = place.point;
        next.state.start = start_of(context_, place, photon.state.ray.direction);
        next.state.level = place.level;
        next.state.weight *= largest(filter);
        const std::uint32_t interior = place.surface.interior;
        if (interior != plan::kNone) {
            if (next.state.interiors.holds(interior)) next.state.interiors.remove_first(interior);
            else next.state.interiors.append(interior);
        }
        send(std::move(next), photon);
    }

    /// What the surface lets through.
    glm::vec3 filter_of(const Flying& photon, const HitPlace& place, const HitDetails& details)
    {
        glm::vec3 filter(place.surface.texture_of(place.from_inside) == plan::kNone ? 1.0f : 0.0f);
        each_layers(place, details,
                    [&](HitContext&, const LayerStack& stack, float share) { filter += share * stack.filter; });
        steps_[photon.step].filter.met = filter;
        return filter;
    }

    void stay(const Flying& photon, const HitPlace& place)
    {
        PhotonStep& step = steps_[photon.step];
        step.stays = true;
        step.flux = photon_flux(*flight_, photon.color, photon.depth, 2);
        step.photon = make_photon(place.point, step.flux, -photon.state.ray.direction);
    }

    /// What a texture's layers send on.
    void go_on(const Flying& photon, const HitPlace& place, const HitDetails& details, const plan::PhotonSurface& rules)
    {
        const bool refracts = agree(rules.refraction, flight_->refraction),
                   reflects = agree(rules.reflection, flight_->reflection);
        each_layers(place, details, [&](HitContext& hit, const LayerStack& stack, float share) {
            if (stack.filter != glm::vec3(0.0f)) steps_[photon.step].filter.met = stack.filter;
            Refracted next;
            const float weight = photon.state.weight * largest(glm::abs(stack.filter));
            const bool through = refracts && stack.residual > static_cast<float>(plan_.adc_bailout) &&
                                 refract(context_, hit, stack.top_normal, weight, next);
            if (through) transmit(photon, hit, stack, next, share);
            if (reflects && !(through && next.total)) mirror(photon, hit, stack, share);
        });
    }

    /// f(hit, layers, share) for all plain textures that the hit shows.
    template <class F>
    void each_layers(const HitPlace& place, const HitDetails& details, F&& f)
    {
        HitContext hit(place, 0);
        hit.surround(details.point, details.uv);
        SideTextures(scene_, world_, place.met, details, place.from_inside, scratch_.shade.shares)
            .each_layers(place.surface.pattern_point(details.point, details.uv), hit.around, hit.enclosing,
                         [&](const texture::Texture& layers, const glm::dvec3& p, float share) {
                             f(hit, layer_stack(context_, hit, layers, p), share);
                         });
    }

    /// Through the surface, or back where nothing gets through.
    void transmit(const Flying& photon, const HitContext& hit, const LayerStack& stack, const Refracted& next,
                  float share)
    {
        const glm::vec3 filter = next.samples == 0 ? stack.filter : DispersedFilters::carried(stack.filter),
                        passed = photon.color * filter * scene_.interiors[hit.surface.interior].transmission * share;
        if (next.samples == 0) {
            send(sent(photon, next.ray, next.total ? photon.color * share : passed), photon);
            return;
        }
        for (int i = 0; i < next.samples; ++i) {
            RayState ray;
            const bool through = disperse(context_, hit, stack.top_normal, next, i, ray);
            const glm::vec3 part = hue(wavelength(i, next.samples), next.samples) / static_cast<float>(next.samples);
            Flying on = sent(photon, ray, part * (through ? passed : photon.color * share));
            on.dispersed = true;
            if (!send(std::move(on), photon) || !through) continue;
            dispersed_ |= HitMask{1} << photon.root;
            using Sample = DispersedFilters::Part::Sample;
            steps_.last().filter = {i == 0 ? Sample::First : Sample::Later, stack.filter};
        }
    }

    /// One photon for each layer that mirrors, all about the normal of the last one. POV-Ray weighs it by the square of
    /// what is mirrored.
    void mirror(const Flying& photon, const HitContext& hit, const LayerStack& stack, float share)
    {
        for (std::size_t i = 0; i < stack.mirrors.size(); ++i) {
            const Mirror& of = stack.mirrors[i];
            if (black(of.reflectivity)) continue;
            RayState ray = mirrored(context_, hit, stack.mirrors.back().normal,
                                    photon.state.weight * largest(of.reflectivity) * largest(of.reflectivity));
            if (of.finish->extension != texture::kNone) roughen(hit, *of.finish, ray);
            const glm::vec3 color = raised(scene::Color::of(photon.color), of.finish->reflection_power);
            send(sent(photon, ray, color * of.reflectivity * share), photon);
        }
    }

    /// Off a rough mirror: one direction of those that a ray would be the mean of, by where the photon comes from.
    void roughen(const HitPlace& hit, const texture::Finish& finish, RayState& ray) const
    {
        const texture::FinishExtension& rough = scene_.textures.extensions[finish.extension];
        if (!(rough.gloss_exponent > 0.0f)) return;
        const auto seed = static_cast<std::uint32_t>(numbers::random_seed(hit.point, ray.ray.direction));
        ray.ray.direction = RoughLobe(rough, ray.ray.direction, hit.normal).direction(sobol_point(seed, 0));
        ray.start = start_of(context_, hit, ray.ray.direction);
    }

    static Flying sent(const Flying& from, const RayState& ray, const glm::vec3& color)
    {
        Flying out{ray, color, from.depth, 0, from.root, false, false, from.dispersed};
        if (ray.kind == plan::RayKind::Reflection) out.state.kind = plan::RayKind::MirroredPhoton;
        return out;
    }

    /// False: it ends here.
    bool send(Flying&& photon, const Flying& from)
    {
        if (photon.state.level >= plan_.max_trace_level || static_cast<double>(photon.state.weight) < plan_.adc_bailout)
            return false;
        photon.step = steps_.add(from.step);
        flying_.push_back(std::move(photon));
        return true;
    }

    const plan::CompiledScene& scene_;
    const plan::PhotonPlan& plan_;
    csg::World world_;
    Scratch scratch_;
    Context context_;
    const PhotonFlight* flight_ = nullptr;
    std::vector<Flying> flying_, tracing_;
    PhotonForest steps_;
    std::vector<Photon> stay_;  ///< in media
    PhotonAir air_{scene_, stay_};
    const JitterStream* jitter_ = nullptr;
    const PhotonYield* known_ = nullptr;
    HitMask hits_ = 0, dispersed_ = 0;  ///< by photon
    RayTile rays_;
    HitTile met_;
};

PhotonTracer::PhotonTracer(const plan::CompiledScene& scene, const std::atomic<bool>* cancel)
    : impl_(std::make_unique<Impl>(scene, cancel))
{}
PhotonTracer::~PhotonTracer() = default;

bool PhotonTracer::follow(const PhotonFlight& flight, std::span<const Emission> photons, const JitterStream& jitter,
                          PhotonYield& out)
{
    try {
        impl_->follow(flight, photons, jitter, out);
    } catch (const csg::Cancelled&) {
        return false;
    }
    return true;
}

bool PhotonTracer::count(const PhotonFlight& flight, std::span<const Emission> photons, PhotonYield& out)
{
    try {
        impl_->count(flight, photons, out);
    } catch (const csg::Cancelled&) {
        return false;
    }
    return true;
}

}  // namespace trace
