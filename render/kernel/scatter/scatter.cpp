#include "render/texture/finish.h"
#include "render/texture/noise/noise.h"
#include "render/kernel/scatter/glossy.h"
#include "render/kernel/interior/interface.h"
#include "render/kernel/scatter/refraction.h"
#include "render/kernel/scatter/turned.h"
#include "render/kernel/tile/nearly_zero.h"
#include "render/kernel/light/direct_light.h"
#include "render/kernel/scatter/scatter.h"

#include <algorithm>
#include <cmath>

namespace trace {

bool bend(const glm::dvec3& d, const glm::dvec3& normal, double ratio, RayState& out)
{
    bool total;
    out.ray.direction = bent_behind(d, normal, ratio, out.stretch, total);
    return !total;
}

namespace {

// Once for scatter() itself, where they are part of every hit on glass and mirrors, and once for photons.
[[gnu::always_inline]] inline double start_here(const Context& context, const HitPlace& hit,
                                                const glm::dvec3& direction)
{
    const double incidence = glm::dot(hit.normal, direction);
    const bool inward = (incidence > 0.0) == (hit.from_inside != hit.met.inverted);
    return context.world.spawn_distance({hit.point, direction}, hit.met, incidence, inward,
                                        context.scene.tolerance.hit_from(hit.point, hit.met.t));
}

}  // namespace

double start_of(const Context& context, const HitPlace& hit, const glm::dvec3& direction)
{
    return start_here(context, hit, direction);
}

namespace {

/// Writes the mirrored ray in place: a copy of what was just written in smaller pieces would stall on store forwarding.
[[gnu::always_inline]] inline void mirror_into(const Context& context, const HitPlace& hit, const glm::dvec3& normal,
                                               float weight, RayState& out)
{
    const glm::dvec3& d = hit.state.ray.direction;
    glm::dvec3 r = mirrored_about(d, normal, glm::dot(d, normal));
    const double outward = glm::dot(r, hit.normal);
    if (outward < 0.0) {
        // Into the surface: mirror about the raw normal, or fold back out.
        if (glm::dot(r, normal) < 0.0) r = mirrored_about(d, hit.normal, glm::dot(d, hit.normal));
        else r = mirrored_about(r, hit.normal, outward);
    }
    r = mirrored_unit(r, context.scene.camera.povray);
    leave(hit.state, hit.level, hit.state.root, {hit.point, r}, weight, out);
    be_mirrored(hit.state.interiors, out);
    out.start = start_here(context, hit, r);
}

/// ray: of Refracted.
[[gnu::always_inline]] inline bool refract_here(const Context& context, const HitPlace& hit,
                                                const glm::dvec3& top_normal, float weight, Refraction& out,
                                                RayState& ray)
{
    if (hit.surface.interior == plan::kNone) return false;
    const plan::Interior& interior = context.scene.interiors[hit.surface.interior];
    const glm::dvec3& d = hit.state.ray.direction;
    out.fade = fade_behind(interior, hit.state.interiors, hit.surface.interior, hit.met.t);
    out.straight = true;
    out.total = false;
    const Crossing crossing = crossing_of(context.scene.interiors, hit.state.interiors, hit.surface.interior);
    cross(context.scene.interiors, hit.state.interiors, hit.surface.interior, crossing.way, ray.interiors);
    context.cross(interior);
    leave(hit.state, hit.level, hit.state.root, {hit.point, d}, weight, ray);
    ray.kind = hit.state.kind;
    ray.stretch = hit.state.stretch;
    if (!crossing.bends()) {
        ray.start = start_here(context, hit, d);
        return true;
    }
    out.straight = false;
    out.ratio = crossing.ratio;
    out.dispersion = crossing.dispersion;
    const bool disperses = crossing.disperses();
    if (disperses && !(hit.state.wavelength > 0.0f)) {
        out.samples = crossing.samples;
        return true;
    }
    const double ratio =
        disperses ? context.scratch.shade.spectrum.ratio_at(crossing.ratio, crossing.dispersion, hit.state.wavelength)
                  : crossing.ratio;
    if (bend(hit.state.stretch * d, top_normal, ratio, ray)) {
        ray.start = start_here(context, hit, ray.ray.direction);
        return true;
    }
    out.total = true;
    mirror_into(context, hit, top_normal, weight, ray);
    return true;
}

}  // namespace

RayState mirrored(const Context& context, const HitPlace& hit, const glm::dvec3& normal, float weight)
{
    RayState out;
    mirror_into(context, hit, normal, weight, out);
    return out;
}

bool refract(const Context& context, const HitPlace& hit, const glm::dvec3& top_normal, float weight, Refracted& out)
{
    return refract_here(context, hit, top_normal, weight, out, out.ray);
}

bool disperse(const Context& context, const HitPlace& hit, const glm::dvec3& top_normal, const Refracted& refracted,
              int i, RayState& out)
{
    out = refracted.ray;
    const float nm = wavelength(i, refracted.samples);
    if (!bend(hit.state.stretch * hit.state.ray.direction, top_normal,
              context.scratch.shade.spectrum.ratio_at(refracted.ratio, refracted.dispersion, nm), out)) {
        out = mirrored(context, hit, top_normal, refracted.ray.weight);
        return false;
    }
    out.start = start_of(context, hit, out.ray.direction);
    out.wavelength = nm;
    return true;
}

namespace {

/// The rays of all wavelengths beyond a surface (spec 3, 8.5); those that are mirrored within take on the iridescence
/// of the top layer.
ColorSlot spectrum(Context& context, const HitPlace& hit, const glm::dvec3& top_normal,
                   const texture::Finish& top_finish, const Refracted& refracted)
{
    RayQueue& queue = context.scratch.shade.queue;
    const ColorSlot out = queue.new_slot();
    ShadeNode& node = queue.new_node(ShadeNode::Kind::Spectrum, out);
    node.count = static_cast<std::uint32_t>(refracted.samples);
    node.first = queue.new_terms(node.count);
    const std::uint32_t first = node.first;
    for (int i = 0; i < refracted.samples; ++i) {
        RayState ray;
        ShadeTerm& term = queue.terms[first + static_cast<std::uint32_t>(i)];
        term.factor = hue(wavelength(i, refracted.samples), refracted.samples);
        const bool within = !disperse(context, hit, top_normal, refracted, i, ray);
        if (!within) {
            ++context.scratch.counts.refracted;
        } else {
            ++context.scratch.counts.reflected;
            if (top_finish.irid > 0.0f) term.film = film_color(context, hit, top_finish, top_normal, ray.ray.direction);
        }
        term.slot = queue_ray(context, within ? queue.mirrors : queue.rays, ray, false);
    }
    return out;
}

/// The ray behind the surface, or the one that is mirrored where none gets through.
void transmit(Context& context, const HitPlace& hit, const LayerStack& stack, std::uint32_t index)
{
    RayQueue& queue = context.scratch.shade.queue;
    const texture::Finish& top_finish = *stack.mirrors.front().finish;
    if (hit.surface.interior == plan::kNone) return;
    const float weight = hit.state.weight * largest(glm::abs(stack.filter));
    Refraction next;
    QueuedRay& ray = queue.rays.emplace_back();  // made where it waits as a rule
    refract_here(context, hit, stack.top_normal, weight, next, ray.state);
    queue.nodes[index].fade = next.fade;
    if (next.samples > 0) {
        const Refracted refracted{next, ray.state};
        queue.rays.pop_back();
        const ColorSlot seen = spectrum(context, hit, stack.top_normal, top_finish, refracted);
        queue.nodes[index].through = seen;
        return;
    }
    ShadeNode& node = queue.nodes[index];
    node.total = next.total;
    if (next.total) {
        ++context.scratch.counts.reflected;
        if (top_finish.irid > 0.0f)
            node.film = film_color(context, hit, top_finish, stack.top_normal, ray.state.ray.direction);
        node.through = queue_ray(context, queue.mirrors, ray.state, next.straight);
        queue.rays.pop_back();
        return;
    }
    ++context.scratch.counts.refracted;
    if (worth_tracing(context, hit.level, weight)) node.through = queue.keep(ray, next.straight);
    else queue.rays.pop_back();
}

/// The ray off a mirror, if it is worth tracing.
[[gnu::always_inline]] inline ColorSlot queue_mirrored(Context& context, const HitPlace& hit, const Mirror& mirror)
{
    RayQueue& queue = context.scratch.shade.queue;
    if (!worth_tracing(context, hit.level, mirror.weight)) return kNoSlot;
    QueuedRay& ray = queue.mirrors.emplace_back();
    mirror_into(context, hit, mirror.normal, mirror.weight, ray.state);
    return queue.keep(ray, false);
}

/// A mirror that total reflection has already sent a ray for.
bool sent(const ShadeNode& node, const LayerStack& stack, const Mirror& mirror)
{
    const glm::dvec3 off = glm::abs(mirror.normal - stack.top_normal);
    return node.total && off.x <= kNearlyZero && off.y <= kNearlyZero && off.z <= kNearlyZero;
}

bool is_rough(const Context& context, const Mirror& mirror)
{
    return mirror.finish->extension != texture::kNone &&
           context.scene.textures.extensions[mirror.finish->extension].gloss_exponent > 0.0f;
}

/// The mirrors of a stack some of which are rough. Their terms lie in one piece before those of the rays in between.
[[gnu::noinline]] void rough_mirrors(Context& context, const HitPlace& hit, const LayerStack& stack,
                                     std::uint32_t index)
{
    RayQueue& queue = context.scratch.shade.queue;
    const std::uint32_t first = queue.new_terms(stack.mirrors.size());
    std::uint32_t count = 0;
    for (const Mirror& mirror : stack.mirrors) {
        if (black(mirror.reflectivity) || sent(queue.nodes[index], stack, mirror)) continue;
        const RayState ray = mirrored(context, hit, mirror.normal, mirror.weight);
        const bool rough = is_rough(context, mirror);
        if (!rough) ++context.scratch.counts.reflected;
        const ColorSlot seen =
            rough ? glossy(context, hit, context.scene.textures.extensions[mirror.finish->extension], ray)
                  : queue_ray(context, queue.mirrors, ray, false);
        ShadeTerm& term = queue.terms[first + count++];
        term = ShadeTerm(seen, mirror.reflectivity, mirror.finish->reflection_power);
        if (mirror.finish->irid > 0.0f)
            term.film = film_color(context, hit, *mirror.finish, mirror.normal, ray.ray.direction);
    }
    queue.nodes[index].first = first;
    queue.nodes[index].count = count;
}

}  // namespace

void find_mirror(const Context& context, const HitPlace& hit, const texture::Finish& finish, const scene::Color& c,
                 const glm::dvec3& normal, float residual, Mirror& mirror)
{
    mirror.reflectivity = glm::vec3(0);
    mirror.normal = normal;
    mirror.weight = 0.0f;
    mirror.finish = &finish;
    if (!finish.reflects()) return;
    const double eta =
        finish.fresnel ? fresnel_index(context.scene.interiors, hit.state.interiors, hit.surface.interior) : 1.0;
    mirror.reflectivity = texture::reflectivity(finish, c, hit.state.ray.direction, normal, eta);
    mirror.weight = mirror_weight(hit.state.weight, residual, finish, mirror.reflectivity);
}

std::uint32_t scatter(Context& context, const HitPlace& hit, const LayerStack& stack, ColorSlot out)
{
    RayQueue& queue = context.scratch.shade.queue;
    const plan::Settings& settings = context.scene.settings;
    const auto index = static_cast<std::uint32_t>(queue.nodes.size());
    ShadeNode& node = queue.new_node(ShadeNode::Kind::Surface, out);
    node.filter = stack.filter;
    node.residual = stack.residual;
    if (stack.residual > static_cast<float>(context.adc_bailout) && settings.quality.transmission)
        transmit(context, hit, stack, index);
    if (!settings.quality.reflection) return index;
    if (!context.scene.textures.extensions.empty() &&
        std::any_of(stack.mirrors.begin(), stack.mirrors.end(),
                    [&](const Mirror& mirror) { return is_rough(context, mirror); })) [[unlikely]] {
        rough_mirrors(context, hit, stack, index);
        return index;
    }
    std::uint32_t count = 0;
    for (const Mirror& mirror : stack.mirrors) {
        if (black(mirror.reflectivity) || sent(queue.nodes[index], stack, mirror)) continue;
        ++context.scratch.counts.reflected;
        const ColorSlot seen = queue_mirrored(context, hit, mirror);
        if (count++ == 0) queue.nodes[index].first = static_cast<std::uint32_t>(queue.terms.size());
        ShadeTerm& term = queue.terms.emplace_back(seen, mirror.reflectivity, mirror.finish->reflection_power);
        if (mirror.finish->irid > 0.0f && seen != kNoSlot)
            term.film =
                film_color(context, hit, *mirror.finish, mirror.normal, queue.mirrors.back().state.ray.direction);
    }
    queue.nodes[index].count = count;
    return index;
}

ColorSlot queue_ray(Context& context, std::vector<QueuedRay>& queue, const RayState& state, bool straight)
{
    if (!worth_tracing(context, state.level, state.weight)) return kNoSlot;
    const ColorSlot slot = context.scratch.shade.queue.new_slot();
    queue.emplace_back(state, slot, straight ? state.level : state.level + 1);
    return slot;
}

}  // namespace trace
