#pragma once

#include "numbers/functions/functions.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace trace {

/// A photon as it is kept and written to files: POV-Ray's 20 bytes (spec 6, 3.6).
struct Photon {
    float x, y, z;
    std::uint8_t red, green, blue, exponent;  ///< flux: mantissas under one exponent
    std::uint8_t axis;                        ///< that its node of the tree divides
    std::int8_t latitude, azimuth;            ///< of the way back to where it came from
    std::uint8_t unused;

    glm::vec3 place() const { return {x, y, z}; }
};
static_assert(sizeof(Photon) == 20, "files hold them as they are");

/// Linear RGB; not a number, and what is darker than 1e-32, becomes black.
inline void set_flux(Photon& photon, const glm::vec3& flux)
{
    constexpr float kBlack = 1e-32f;
    constexpr int kBias = 250;
    photon.red = photon.green = photon.blue = photon.exponent = 0;
    const float most = std::max({flux.x, flux.y, flux.z});
    if (!(most >= kBlack && std::isfinite(most))) return;
    int exponent = 0;
    std::frexp(most, &exponent);
    const auto mantissa = [exponent](float channel) {
        return static_cast<std::uint8_t>(std::clamp(std::ldexp(channel, 8 - exponent), 0.0f, 255.0f));
    };
    photon.red = mantissa(flux.x);
    photon.green = mantissa(flux.y);
    photon.blue = mantissa(flux.z);
    photon.exponent = static_cast<std::uint8_t>(exponent + kBias);
}

/// back: unit, to where it came from.
inline Photon make_photon(const glm::dvec3& place, const glm::vec3& flux, const glm::dvec3& back)
{
    Photon out{
        static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.z), 0, 0, 0, 0, 0, 0, 0, 0};
    set_flux(out, flux);
    constexpr double kSteps = 127.0 / std::numbers::pi;
    const double flat = std::sqrt(back.x * back.x + back.z * back.z);
    const auto step = [](double angle, double sign) {
        return static_cast<std::int8_t>((sign < 0.0 ? -angle : angle) * kSteps);
    };
    out.latitude = step(numbers::acos(std::min(flat, 1.0)), back.y);
    if (flat > 0.0) out.azimuth = step(numbers::acos(std::clamp(back.x / flat, -1.0, 1.0)), back.z);
    return out;
}

/// The light that a photon carries, linear RGB.
inline glm::vec3 flux_of(const Photon& photon)
{
    if (photon.exponent == 0) return glm::vec3(0);
    constexpr int kBias = 258;
    const float unit = std::ldexp(1.0f, photon.exponent - kBias);
    return unit * glm::vec3(photon.red, photon.green, photon.blue);
}

/// The unit direction to where a photon came from, as exact as its two bytes.
inline glm::vec3 back_of(const Photon& photon)
{
    constexpr double kStep = std::numbers::pi / 127.0;
    const double latitude = photon.latitude * kStep, azimuth = photon.azimuth * kStep;
    return {numbers::cos(latitude) * numbers::cos(azimuth), numbers::sin(latitude),
            numbers::cos(latitude) * numbers::sin(azimuth)};
}

}  // namespace trace
