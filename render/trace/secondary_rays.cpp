#include "render/texture/finish.h"
#include "render/texture/noise.h"
#include "render/trace/shade_context.h"

#include <cmath>

namespace trace {
namespace {

/// How an interface turns a ray, and what the ray is inside of afterwards (spec 3, 8.2).
struct Crossing {
    double ratio = 1, dispersion = 1;   ///< incoming over outgoing
    InteriorList list;
};

Crossing cross(const Context& context, const InteriorList& list, std::uint32_t own)
{
    const auto& interiors = context.scene.interiors;
    const auto ior = [&](std::uint32_t i) { return static_cast<double>(interiors[i].ior); };
    const auto dispersion = [&](std::uint32_t i) { return static_cast<double>(interiors[i].dispersion); };
    Crossing out{1, 1, list};
    if (list.empty()) {
        out.ratio = 1.0 / ior(own);
        out.dispersion = 1.0 / dispersion(own);
        out.list.append(own);
    } else if (list.last() == own) {
        // Leaving the body entered last; remove_first would take an earlier entry of the same body.
        InteriorList left;
        for (std::size_t i = 0; i + 1 < list.size(); ++i) left.append(list[i]);
        out.list = left;
        out.ratio = left.empty() ? ior(own) : ior(own) / ior(left.last());
        out.dispersion = left.empty() ? dispersion(own) : dispersion(own) / dispersion(left.last());
    } else if (list.holds(own)) {
        out.list.remove_first(own);
    } else {
        out.ratio = ior(list.last()) / ior(own);
        out.dispersion = dispersion(list.last()) / dispersion(own);
        out.list.append(own);
    }
    return out;
}

}  // namespace

glm::vec3 interior_fade(const plan::Interior& interior, double distance, bool shadow)
{
    const auto reach = static_cast<double>(interior.fade_distance), power = static_cast<double>(interior.fade_power);
    if (!(std::abs(reach) > kNearlyZero) || (shadow && !(power > 0.0))) return glm::vec3(1.0f);
    constexpr double kExponential = 1000.0;  // from this power on the law is exponential
    if (power >= kExponential) {
        glm::vec3 out;
        for (int k = 0; k < 3; ++k)
            out[k] = static_cast<float>(std::exp(-(1.0 - static_cast<double>(interior.fade_color[k])) * distance / reach));
        return out;
    }
    const auto share = static_cast<float>(1.0 / (1.0 + std::pow(distance / reach, power)));
    return interior.fade_color + (1.0f - interior.fade_color) * share;
}

double fresnel_index(const Context& context, const HitContext& hit)
{
    const auto& interiors = context.scene.interiors;
    const InteriorList& list = hit.state.interiors;
    if (hit.surface.interior == plan::kNone) return 1.0;
    const auto own = static_cast<double>(interiors[hit.surface.interior].ior);
    if (list.empty()) return own;
    const auto outer = static_cast<double>(interiors[list.last()].ior);
    if (!list.holds(hit.surface.interior)) return own / outer;
    return list.size() == 1 ? 1.0 / own : outer / own;
}

scene::Color reflected(Context& context, const HitContext& hit, const glm::dvec3& normal, float weight,
                       glm::dvec3& direction)
{
    const glm::dvec3& d = hit.state.ray.direction;
    glm::dvec3 r = d - 2.0 * glm::dot(d, normal) * normal;
    const double out = glm::dot(r, hit.normal);
    if (out < 0.0) {
        // Into the surface: mirror about the raw normal, or fold back out.
        if (glm::dot(r, normal) < 0.0)
            r = d - 2.0 * glm::dot(d, hit.normal) * hit.normal;
        else
            r -= 2.0 * out * hit.normal;
    }
    direction = glm::normalize(r);
    RayState next{{hit.point, direction}, weight, hit.level, plan::RayKind::Reflection, hit.state.interiors};
    ++context.scratch.counts.reflected;
    return trace_ray(context, next, false);
}

scene::Color transmitted(Context& context, const HitContext& hit, const glm::dvec3& top_normal, float weight,
                         const texture::Finish& top_finish, bool& total)
{
    total = false;
    if (hit.surface.interior == plan::kNone) return {};
    const plan::Interior& interior = context.scene.interiors[hit.surface.interior];
    const glm::dvec3& d = hit.state.ray.direction;
    glm::vec3 fade(interior.transmission);
    if (hit.state.interiors.holds(hit.surface.interior)) fade *= interior_fade(interior, hit.distance, false);

    const Crossing crossing = cross(context, hit.state.interiors, hit.surface.interior);
    RayState next{{hit.point, d}, weight, hit.level, hit.state.kind, crossing.list};
    bool straight = true;
    if (std::abs(crossing.ratio - 1.0) >= kNearlyZero || std::abs(crossing.dispersion - 1.0) >= kNearlyZero) {
        straight = false;
        const double facing = glm::dot(d, top_normal);
        const glm::dvec3 n = facing <= 0.0 ? top_normal : -top_normal;
        const double r = crossing.ratio, c = std::abs(facing);
        const double k = 1.0 + r * r * (c * c - 1.0);
        if (k < 0.0) {
            total = true;
            glm::dvec3 direction;
            scene::Color mirror = reflected(context, hit, top_normal, weight, direction);
            glm::vec3 light = mirror.rgb();
            if (top_finish.irid > 0.0f) light *= film_color(context, hit, top_finish, top_normal, direction);
            return scene::Color::of(light * fade);
        }
        // A unit vector already, up to rounding; World wants unit directions, so it is made exact.
        next.ray.direction = glm::normalize(r * d + (r * c - std::sqrt(k)) * n);
    }
    ++context.scratch.counts.refracted;
    const scene::Color behind = trace_ray(context, next, straight);
    scene::Color out = scene::Color::of(behind.rgb() * fade);
    out.transmit = behind.transmit * scene::grey(fade);
    return out;
}

glm::vec3 film_color(const Context& context, const HitContext& hit, const texture::Finish& finish,
                     const glm::dvec3& normal, const glm::dvec3& l)
{
    const auto& set = context.scene.textures;
    auto h = static_cast<double>(finish.irid_thickness);
    if (finish.irid_turbulence != 0.0f) {
        const double b = texture::scalar_turbulence(hit.point, 5, 2.0, 0.5, set.noise_generator);
        h *= 1.0 + static_cast<double>(finish.irid_turbulence) * (2.0 * b - 1.0);
    }
    const double cos_view = std::abs(glm::dot(normal, hit.state.ray.direction));
    return texture::film(finish, h, std::abs(glm::dot(normal, l)), cos_view, set.irid_wavelength);
}

}  // namespace trace
