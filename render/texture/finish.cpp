#include "render/texture/finish.h"

#include "numbers/functions/functions.h"
#include "render/texture/points/angle.h"
#include "render/texture/fresnel.h"
#include "render/texture/metallic.h"

#include <algorithm>
#include <cmath>

namespace texture {

float opacity(const scene::Color& c, bool legacy)
{
    if (!legacy) return 1.0f - c.filter - c.transmit;
    return 1.0f - (c.filter * std::max({c.red, c.green, c.blue}) + c.transmit);
}

namespace {

/// A cosine to a normal longer than 1 may be larger than 1, and its power larger than a float holds. POV-Ray goes on
/// with what a double holds as with a number, and so do we.
double highlight_power(double c, double n)
{
    constexpr double kMost = 1e30;  // white whatever it is multiplied by, and far from what a float holds at most
    if (highlight_vanishes(c, n)) return 0.0;
    const double power = numbers::pow(c, n);
    return power > kMost && std::isfinite(power) ? kMost : power;
}

}  // namespace

double phong(const Finish& finish, const glm::dvec3& d, const glm::dvec3& n, const glm::dvec3& l)
{
    const double c = phong_cosine(d, n, l);
    if (phong_vanishes(finish, c)) return 0.0;
    return static_cast<double>(finish.phong) * highlight_power(c, static_cast<double>(finish.phong_size));
}

double specular(const Finish& finish, const glm::dvec3& d, const glm::dvec3& n, const glm::dvec3& l)
{
    const double c = specular_cosine(d, n, l);
    if (!(c > 0.0)) return 0.0;  // nor for a light behind the surface that the ray comes from: no number
    return static_cast<double>(finish.specular) * highlight_power(c, static_cast<double>(finish.specular_exponent));
}

glm::vec3 metallic_tint(float amount, double cosine, const scene::Color& pigment)
{
    const auto share = static_cast<float>(metallic_share(static_cast<double>(amount), cosine));
    return glm::vec3(1.0f) + share * (pigment.rgb() - 1.0f);
}

glm::vec3 highlight_color(const Finish& finish, const glm::vec3& light, const scene::Color& pigment,
                          const glm::dvec3& d, const glm::dvec3& n, const glm::dvec3& l)
{
    if (!(finish.metallic > 0.0f)) return light;
    const auto by_normal = [&] { return metallic_tint(finish.metallic, glm::dot(n, l), pigment); };
    if (!finish.tint_by_half) return light * by_normal();
    const glm::vec3 by_half = metallic_tint(finish.metallic, halfway_cosine(d, l), pigment);
    const double broad = finish.phong > 0.0f ? phong(finish, d, n, l) : 0.0;
    if (broad == 0.0) return light * by_half;
    const auto share = static_cast<float>(broad / (broad + specular(finish, d, n, l)));
    return light * (share * by_normal() + (1.0f - share) * by_half);
}

double seen_share(const Finish& finish, const glm::dvec3& d, const glm::dvec3& n, double eta)
{
    const auto share = static_cast<double>(finish.own_fresnel);
    return share == 0.0 ? 1.0 : 1.0 - share * fresnel_share(eta, -glm::dot(d, n));
}

Finish met_by_light(const Finish& finish, double opacity, const glm::dvec3& d, const glm::dvec3& n, const glm::dvec3& l,
                    double eta)
{
    Finish met = finish;
    if (finish.use_alpha) {
        met.phong *= static_cast<float>(opacity);
        met.specular *= static_cast<float>(opacity);
    }
    if (finish.own_fresnel == 0.0f) return met;
    const auto share = static_cast<double>(finish.own_fresnel);
    const double toward_light = fresnel_share(eta, glm::dot(n, l));  // 1 from behind
    const glm::dvec3 half = l - d;
    const double toward_half = fresnel_share(eta, -glm::dot(half, d) / glm::length(half));
    const auto inward = static_cast<float>((1.0 - share * toward_light) * seen_share(finish, d, n, eta));
    met.diffuse *= inward;
    met.diffuse_back *= inward;
    met.phong *= static_cast<float>(share * toward_light);
    met.specular *= static_cast<float>(share * toward_half);
    return met;
}

namespace {

/// What mirroring is left of where opacity dims it.
glm::vec3 dimmed(const Finish& finish, const scene::Color& pigment, const glm::vec3& reflectivity)
{
    return finish.use_alpha ? reflectivity * opacity(pigment, finish.legacy_opacity) : reflectivity;
}

/// Schlick, "An inexpensive BRDF model for physically-based rendering" (1994): no critical angle, no polarisation.
/// Hardly ever asked, and not to make reflectivity() too long to be inlined.
[[gnu::noinline]] double schlick_share(double eta, double c)
{
    const double head_on = (eta - 1.0) / (eta + 1.0), least = head_on * head_on;
    const double away = 1.0 - std::clamp(c, 0.0, 1.0), square = away * away;
    return least + (1.0 - least) * square * square * away;
}

}  // namespace

glm::vec3 reflectivity(const Finish& finish, const scene::Color& pigment, double c, double eta)
{
    glm::vec3 r = finish.reflection_max;
    if (finish.reflection_min != finish.reflection_max) {
        const double s = finish.fresnel ? (finish.schlick ? schlick_share(eta, c) : fresnel_share(eta, c))
                         : finish.reflection_falloff == 1.0f
                             ? 1.0 - c
                             : numbers::pow(1.0 - c, static_cast<double>(finish.reflection_falloff));
        return reflectivity_at(finish, pigment, c, static_cast<float>(s));
    }
    if (finish.reflection_metallic != 0.0f) r *= metallic_tint(finish.reflection_metallic, c, pigment);
    return dimmed(finish, pigment, r);
}

glm::vec3 reflectivity_at(const Finish& finish, const scene::Color& pigment, double c, float share)
{
    glm::vec3 r = share * finish.reflection_max + (1.0f - share) * finish.reflection_min;
    if (finish.reflection_metallic != 0.0f) r *= metallic_tint(finish.reflection_metallic, c, pigment);
    return dimmed(finish, pigment, r);
}

glm::vec3 film(const Finish& finish, double h, double cos_light, double cos_view, const glm::vec3& wavelength)
{
    glm::vec3 out;
    for (int k = 0; k < 3; ++k)
        out[k] = static_cast<float>(
            1.0 + static_cast<double>(finish.irid) *
                      numbers::cos(kTau * h * (cos_light + cos_view) / static_cast<double>(wavelength[k])));
    return out;
}

}  // namespace texture
