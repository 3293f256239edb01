#pragma once

#include "numbers/functions/functions.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

/// Light of one wavelength (spec 3, 8.5).
namespace trace {

inline constexpr float kShortest = 380.0f, kSpectrum = 350.0f;  ///< nm: what samples share
inline constexpr double kMiddle = 555.0;                        ///< nm: an interior's ior is meant for it

/// The wavelength in nm of sample i of `samples`.
inline float wavelength(int i, int samples)
{
    return kShortest + kSpectrum * (static_cast<float>(i) + 0.5f) / static_cast<float>(samples);
}

/// The factor between an interface's relative index at a wavelength (nm) and that in the middle of the spectrum;
/// `dispersion`: of the interface.
inline double spectrum_power(double dispersion, float wavelength)
{
    return numbers::pow(dispersion, -(static_cast<double>(wavelength) - kMiddle) / static_cast<double>(kSpectrum));
}

/// The relative index of an interface at a wavelength (nm), from its `ratio` in the middle of the spectrum.
inline double ratio_at(double ratio, double dispersion, float wavelength)
{
    return ratio * spectrum_power(dispersion, wavelength);
}

/// ratio_at() with a small cache, since a scene has few dispersions and wavelengths and each costs a power.
class SpectrumPowers {
public:
    double ratio_at(double ratio, double dispersion, float wavelength)
    {
        // Any odd multiplier spreads them; two that share an entry only take turns.
        const std::uint64_t mixed =
            (std::bit_cast<std::uint64_t>(dispersion) ^ std::bit_cast<std::uint32_t>(wavelength)) * 0x9e3779b97f4a7c15u;
        Entry& e = entries_[mixed >> kShift];
        if (e.dispersion != dispersion || e.wavelength != wavelength)
            e = {dispersion, spectrum_power(dispersion, wavelength), wavelength};
        return ratio * e.power;
    }

private:
    static constexpr int kBits = 7, kShift = 64 - kBits;
    struct Entry {
        double dispersion = 0.0, power = 0.0;
        float wavelength = 0.0f;
    };
    std::array<Entry, std::size_t{1} << kBits> entries_;
};

/// The share of white light's red, green and blue that lies below a wavelength (nm).
inline glm::vec3 hue_up_to(float wavelength)
{
    static constexpr float kFirst = 375.0f, kStep = 5.0f;
    static constexpr std::array<std::array<float, 3>, 74> kHues = {{
#include "render/kernel/interior/spectral_hue.inc"
    }};
    const float at = std::clamp((wavelength - kFirst) / kStep, 0.0f, static_cast<float>(kHues.size() - 1));
    const std::size_t k = std::min(static_cast<std::size_t>(at), kHues.size() - 2);
    const float share = at - static_cast<float>(k);
    const auto &a = kHues[k], &b = kHues[k + 1];
    return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])};
}

/// The colour of the sample at a wavelength (nm) of `samples` in all. Their mean is nearly white.
inline glm::vec3 hue(float wavelength, int samples)
{
    const auto count = static_cast<float>(samples);
    const float half = 0.5f * kSpectrum / count;
    return count * (hue_up_to(wavelength + half) - hue_up_to(wavelength - half));
}

}  // namespace trace
