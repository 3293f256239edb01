#pragma once

#include "numbers/lane_power.h"
#include "render/plan/subsurface.h"
#include "render/texture/fresnel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

/// What a material does to light below its surface, per channel (spec 6, 5.2 and 5.3). Lengths are in mm. T is double
/// or numbers::lanes::Double: the same bits for both.
namespace trace {

/// The cosine beyond an interface.
template <class T>
inline T bent_cosine(const T& cosine, const T& eta)
{
    const T zero(0.0), one(1.0), squared = one - (one - cosine * cosine) / (eta * eta);
    return numbers::lanes::root_of(numbers::lanes::choose(squared > zero, squared, zero));
}

/// What is left of light after a depth; nothing that counts, but not 0, of what is too deep.
template <class T>
inline T left_at(const T& optical_depth)
{
    const T deepest(700.0);
    return numbers::lanes::exponential(T(0.0) -
                                       numbers::lanes::choose(optical_depth < deepest, optical_depth, deepest));
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

    /// Light that comes out where it went in so far away, of one channel: a dipole. squared: that distance squared.
    template <class T>
    T dipole(int c, const T& squared) const
    {
        const auto pole = [&](double z) {
            const T d = numbers::lanes::root_of(T(z * z) + squared), over = T(1.0) / d;
            return T(z) * (T(effective[c]) + over) * left_at(T(effective[c]) * d) * (over * over);
        };
        return T(albedo[c] / (4.0 * std::numbers::pi)) * (pole(depth[c]) + pole(height[c]));
    }
};

/// Light of one channel that is scattered once on its way to the viewer.
template <class T>
struct ScatteredOnce {
    T eta, extinction;
    T outer;  ///< cosine of the viewer's ray below the surface
    T scale;  ///< what does not depend on where the light comes from

    /// passed: of the light that leaves for the viewer; left: of it, after the way below the surface
    static ScatteredOnce of(const Scattering& matter, int c, double cos_out, double passed, double left)
    {
        return {matter.eta, matter.extinction[c], bent_cosine(cos_out, matter.eta),
                0.25 * matter.scattered[c] / matter.extinction[c] * passed * left};
    }
    /// way_in: below the surface, as if the light were not bent there
    T share(const T& cos_in, const T& way_in) const
    {
        const T inner = bent_cosine(cos_in, eta), geometry = numbers::lanes::size_of(outer / inner);
        return cos_in * (T(1.0) - texture::fresnel_share(eta, cos_in)) * scale / (T(1.0) + geometry) *
               left_at(way_in * cos_in / inner * extinction);
    }
};

}  // namespace trace
