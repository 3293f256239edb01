#pragma once

#include "numbers/functions/functions.h"
#include "render/kernel/media/media_scratch.h"
#include "render/kernel/photon/photon_tracer.h"
#include "render/kernel/context/context.h"
#include "render/kernel/tile/nearly_zero.h"

namespace trace {

/// A stretch of a photon's way.
struct PhotonStretch {
    const csg::Ray& ray;
    double length;
    const InteriorList& interiors;  ///< that it lies in
    const plan::Surface& end;       ///< what it ends at
    double depth;                   ///< way from the light to its beginning
    bool leaves;                    ///< photons may stay there
};

/// Flux of a photon of this colour that stays `depth` from its light, for photons that are `step` apart one unit from
/// the light, to a power: 2 on surfaces, 3 in media (spec 6, 3.6 and 3.8).
inline glm::vec3 photon_flux(const PhotonFlight& flight, const glm::vec3& color, double depth, int power)
{
    double share = 1.0;
    for (int i = 0; i < power; ++i) share *= flight.parallel ? flight.step : flight.step * depth;
    const light::Light& light = *flight.light;
    if (light.fades_from_start) share /= numbers::pow(depth, light.fade_power);
    else if (light.fade_power > 0.0 && std::abs(light.fade_distance) > kNearlyZero)
        share *= 2.0 / (1.0 + numbers::pow(depth / light.fade_distance, light.fade_power));
    return color * static_cast<float>(share);
}

/// Photons on their way through media of interiors (spec 6, 3.8).
class PhotonAir {
public:
    PhotonAir(const plan::CompiledScene& scene, std::vector<Photon>& stay) : scene_(scene), stay_(stay) {}

    /// Numbers that the stretch draws.
    std::uint64_t draws(const PhotonFlight& flight, const PhotonStretch& stretch);

    /// Dims `color` over the stretch; photons that stay are appended.
    void cross(const PhotonFlight& flight, const PhotonStretch& stretch, JitterStream& jitter, glm::vec3& color);

private:
    bool find_mix(const PhotonStretch& stretch);
    void cut(const PhotonStretch& stretch);
    struct Spread {
        int count;      ///< photons on a sub-interval
        double factor;  ///< what each of them stands for
    };
    Spread spread(const PhotonFlight& flight, const PhotonStretch& stretch, double length) const;
    glm::vec3 extinction(texture::Points& points);

    const plan::CompiledScene& scene_;
    std::vector<Photon>& stay_;
    MediaMix mix_;
    std::vector<MediaRange> ranges_;
    std::vector<MediaPiece> pieces_;
    MediaDensity density_;
};

}  // namespace trace
