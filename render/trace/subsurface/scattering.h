#pragma once

#include "render/plan/subsurface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

/// What a material does to light below its surface, per channel (spec 6, 5.2 and 5.3). Lengths are in mm.
namespace trace {

/// Share of light that passes an interface at a cosine, by Fresnel's equations. eta: relative index.
inline double fresnel_passed(double cosine, double eta)
{
    const double q = eta * eta + cosine * cosine - 1.0;
    if (q < 0.0) return 0.0;
    const double g = std::sqrt(q);
    const double a = (g - cosine) / (g + cosine);
    const double b = (cosine * (g + cosine) - 1.0) / (cosine * (g - cosine) + 1.0);
    return 1.0 - std::clamp(0.5 * a * a * (1.0 + b * b), 0.0, 1.0);
}

/// The cosine beyond an interface.
inline double bent_cosine(double cosine, double eta)
{
    return std::sqrt(std::max(0.0, 1.0 - (1.0 - cosine * cosine) / (eta * eta)));
}

struct Scattering {
    double eta = 1;
    glm::dvec3 albedo{0}, scattered{0}, extinction{0};  ///< per mm
    glm::dvec3 effective{0};                            ///< sigma_tr: how soon scattered light dies away, per mm
    glm::dvec3 depth{0}, height{0};                     ///< z_r and z_v: of the two poles

    /// \param reflectance   of the surface as it is to be seen, per channel, 0 to 1
    /// \param translucency  mm
    Scattering(const glm::vec3& reflectance, const glm::vec3& translucency, double relative_index,
               const plan::AlbedoTable& table)
        : eta(relative_index)
    {
        const double a = plan::internal_reflection(eta);
        for (int c = 0; c < 3; ++c) {
            albedo[c] = table(static_cast<double>(reflectance[c]));
            scattered[c] = 1.0 / static_cast<double>(translucency[c]);
            extinction[c] = scattered[c] / albedo[c];
            const double absorbed = extinction[c] - scattered[c];
            effective[c] = std::sqrt(3.0 * absorbed * extinction[c]);
            depth[c] = 1.0 / extinction[c];
            height[c] = depth[c] * (1.0 + 4.0 * a / 3.0);
        }
    }

    /// The way that light goes on average. 0: some channel lets none through, and POV-Ray leaves out all that is
    /// diffuse.
    double mean_way() const
    {
        const double mean = 0.297 * extinction.x + 0.589 * extinction.y + 0.114 * extinction.z;
        return std::isfinite(mean) && mean > 0.0 ? 1.0 / mean : 0.0;
    }

    /// Light that comes out at a distance from where it went in, of one channel: a dipole.
    double dipole(int c, double distance) const
    {
        const auto pole = [&](double z) {
            const double d2 = z * z + distance * distance, d = std::sqrt(d2);
            return z * (effective[c] + 1.0 / d) * std::exp(-effective[c] * d) / d2;
        };
        return albedo[c] / (4.0 * std::numbers::pi) * (pole(depth[c]) + pole(height[c]));
    }

    /// Light scattered once, of one channel. in: what passes where it comes in; out: of where it comes out.
    double single(int c, double cos_in, double cos_out, double way_in, double way_out) const
    {
        const double inner = bent_cosine(cos_in, eta), outer = bent_cosine(cos_out, eta);
        const double geometry = std::abs(outer / inner);
        return cos_in * scattered[c] * fresnel_passed(cos_in, eta) * fresnel_passed(cos_out, eta) * 0.25 /
               (extinction[c] * (1.0 + geometry)) * std::exp(-way_in * cos_in / inner * extinction[c]) *
               std::exp(-way_out * extinction[c]);
    }
};

}  // namespace trace
