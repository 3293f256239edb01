#pragma once

#include "render/texture/texture_set.h"

/// The terms of a finish as formulas (spec 3, section 7). Unit vectors throughout; `d` is the ray's direction,
/// `n` the layer's normal, `l` the direction to the light.
namespace texture {

/// Share of a layer that is its own colour rather than what shines through (7.2).
float opacity(const scene::Color& c, bool legacy);

/// What a pigment lets through of white light.
inline glm::vec3 passed(const scene::Color& c) { return c.filter * c.rgb() + c.transmit; }

/// What a layer leaves of light that those above it let through: its pigment's share, less what a finish that keeps
/// energy mirrors.
inline glm::vec3 past_layer(glm::vec3 light, const scene::Color& c, const Finish& finish, const glm::vec3& reflectivity)
{
    light *= passed(c);
    if (finish.conserve_energy) light *= glm::min(glm::vec3(1.0f), 1.0f - reflectivity);
    return light;
}

/// c^n for a cosine is below 1e-13, and no picture shows it: c^n <= exp(-n (1 - c)).
inline constexpr double kVanishes = 30.0;
inline bool highlight_vanishes(double c, double n) { return n * (1.0 - c) > kVanishes; }

/// No Phong highlight at this cosine. POV-Ray skips powers that would vanish anyway.
inline bool phong_vanishes(const Finish& finish, double c)
{
    return !(c > 0.0) || (finish.phong_size >= 60.0f && c <= 0.0008);
}

/// Cosines that the highlights are powers of: of the mirrored ray to the light, and of the halfway vector to the
/// normal.
inline double phong_cosine(const glm::dvec3& d, const glm::dvec3& n, const glm::dvec3& l)
{
    const glm::dvec3 mirrored = d - 2.0 * glm::dot(d, n) * n;
    return glm::dot(mirrored, l);
}
inline double specular_cosine(const glm::dvec3& d, const glm::dvec3& n, const glm::dvec3& l)
{
    const glm::dvec3 half = l - d;
    return glm::dot(half, n) / glm::length(half);
}

/// Phong term for one light, without the light's colour (7.7).
double phong(const Finish& finish, const glm::dvec3& d, const glm::dvec3& n, const glm::dvec3& l);

/// Specular term for one light, without the light's colour (7.7).
double specular(const Finish& finish, const glm::dvec3& d, const glm::dvec3& n, const glm::dvec3& l);

/// Cosine of the halfway vector with the light, and with the viewer as well.
inline double halfway_cosine(const glm::dvec3& d, const glm::dvec3& l)
{
    const glm::dvec3 half = l - d;
    return glm::dot(half, l) / glm::length(half);
}

/// What a metallic finish does to white light mirrored at this angle (7.8).
glm::vec3 metallic_tint(float amount, double cosine, const scene::Color& pigment);

/// Colour of the highlights together: the light's, tinted by a metallic finish (7.8; spec 7d, 7).
glm::vec3 highlight_color(const Finish& finish, const glm::vec3& light, const scene::Color& pigment,
                          const glm::dvec3& d, const glm::dvec3& n, const glm::dvec3& l);

/// What is left of a finish's own light on the way to the viewer, by Fresnel's law (spec 7b, 1). eta: relative index.
double seen_share(const Finish& finish, const glm::dvec3& d, const glm::dvec3& n, double eta);

/// A finish with `fresnel` or `use_alpha` as one light meets it: its own sizes of diffuse light and highlights.
/// \param opacity  of the layer
Finish met_by_light(const Finish& finish, double opacity, const glm::dvec3& d, const glm::dvec3& n, const glm::dvec3& l,
                    double eta);

/// Reflectivity per channel (7.9). cosine: of the ray that comes back with the normal; eta: relative index, read by a
/// fresnel finish only.
glm::vec3 reflectivity(const Finish& finish, const scene::Color& pigment, double cosine, double eta);
inline glm::vec3 reflectivity(const Finish& finish, const scene::Color& pigment, const glm::dvec3& d,
                              const glm::dvec3& n, double eta)
{
    return reflectivity(finish, pigment, -glm::dot(d, n), eta);
}

/// The same where the share of the most that it mirrors is known.
glm::vec3 reflectivity_at(const Finish& finish, const scene::Color& pigment, double cosine, float share);

/// Iridescence per channel (7.11) for a film of thickness h.
glm::vec3 film(const Finish& finish, double h, double cos_light, double cos_view, const glm::vec3& wavelength);

}  // namespace texture
