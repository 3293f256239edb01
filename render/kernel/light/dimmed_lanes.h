#pragma once

#include "numbers/functions/lane_functions.h"
#include "render/kernel/tile/hit_mask.h"
#include "render/kernel/tile/tile_lanes.h"

#include <cmath>

/// What cones and distance leave of a light at one place, in vector lanes. The
/// operations are those of light::color_at in the same order.
namespace trace {

class DimmedLanes {
public:
    /// Not a light whose rays are parallel.
    static bool serve(const light::Light& light)
    {
        return light.kind != light::Light::Kind::Cylinder && !light.parallel;
    }
    explicit DimmedLanes(const light::Light& light)
        : light_(light), spot_(light.kind == light::Light::Kind::Spot), cone_(spot_ && light.cos_radius > 0.0),
          fades_(light.fade_power > 0.0 && std::abs(light.fade_distance) > light::kLeastFadeDistance)
    {}

    /// The light's share at the hits of `which`, seen so; others have any.
    void find(HitMask which, const TileLight& seen, TileLanes& share) const
    {
        constexpr HitMask kVector = (HitMask{1} << csg::lanes::kDoubles) - 1;
        for (std::size_t i = 0; i < csg::kTileRays; i += csg::lanes::kDoubles) {
            const auto in = static_cast<std::uint32_t>(which >> i & kVector);
            if (in == 0) continue;
            Double factor(1.0);
            if (spot_) factor = of_cone(in, seen, i);
            if (fades_) {
                const Double ways = load(seen.distance, i) / Double(light_.fade_distance);
                const Double left = factor * (Double(2.0) / (Double(1.0) + raised(in, ways, light_.fade_power)));
                factor = xsimd::select(factor > Double(0.0), left, factor);
            }
            factor.store_aligned(share.data() + i);
        }
    }

private:
    using Double = csg::lanes::Double;

    static Double load(const TileLanes& lanes, std::size_t i) { return Double::load_aligned(lanes.data() + i); }

    Double of_cone(std::uint32_t in, const TileLight& seen, std::size_t i) const
    {
        const Double one(1.0), zero(0.0);
        const Double u = -(Double(light_.axis.x) * load(seen.x, i) + Double(light_.axis.y) * load(seen.y, i) +
                           Double(light_.axis.z) * load(seen.z, i));
        const Double behind = xsimd::select(load(seen.distance, i) <= zero, -u, u);
        Double factor = light_.tightness == 0.0 ? one : raised(in, behind, light_.tightness);
        if (cone_) {
            const Double low(light_.cos_falloff), high(light_.cos_radius);
            const Double t = (behind - low) / (high - low);
            const Double step = xsimd::select(behind < low, zero, t * t * (Double(3.0) - Double(2.0) * t));
            factor = xsimd::select(behind < high, factor * step, factor);
        }
        return xsimd::select(behind <= zero, zero, factor);
    }

    static Double raised(std::uint32_t in, const Double& v, double power)
    {
        if (power == 1.0) return v;
        if (power == 2.0) return v * v;
        return numbers::pow(xsimd::select(csg::lanes::lanes_of(in), v, Double(1.0)), Double(power));
    }

    const light::Light& light_;
    bool spot_, cone_, fades_;
};

}  // namespace trace
