#pragma once

#include "csg/base/hit.h"
#include "csg/base/points.h"
#include "csg/freeform/shared/intersection_list.h"
#include "csg/freeform/revolution/axis_ray.h"

#include <array>
#include <bit>
#include <span>

namespace csg {

/// Several rays, a ray a lane.
class AxisRays : public AxisRayOf<lanes::Double> {
public:
    using Double = lanes::Double;
    using Bool = lanes::Bool;
    using Mask = std::uint32_t;
    static constexpr std::size_t kWide = static_cast<std::size_t>(lanes::kDoubles);

    using AxisRayOf::AxisRayOf;
};

/// Rays by coordinates.
class LocalRays {
public:
    explicit LocalRays(std::span<const Ray> rays)
    {
        for (std::size_t k = 0; k < rays.size(); ++k)
            for (std::size_t i = 0; i < 3; ++i) {
                origin_[i][k] = rays[k].origin[static_cast<glm::length_t>(i)];
                way_[i][k] = rays[k].direction[static_cast<glm::length_t>(i)];
            }
    }
    AxisRays at(std::size_t k) const
    {
        const auto [x, y, z] = origins(k);
        const auto [dx, dy, dz] = ways(k);
        return AxisRays({x, y, z}, {dx, dy, dz});
    }
    /// As many as there are lanes, from ray k on, a multiple of their number.
    lanes::Points origins(std::size_t k) const { return load(origin_, k); }
    lanes::Points ways(std::size_t k) const { return load(way_, k); }

private:
    static lanes::Points load(const std::array<std::array<double, kTileRays>, 3>& of, std::size_t k)
    {
        const auto row = [k](const auto& one) { return AxisRays::Double::load_aligned(one.data() + k); };
        return {row(of[0]), row(of[1]), row(of[2])};
    }

    alignas(64) std::array<std::array<double, kTileRays>, 3> origin_{}, way_{};
};

/// Asks a solid of revolution for rays in lanes: tile(rays as their axis sees them, those to be answered, rays, out)
/// for as many as there are lanes. Level ones are asked one by one.
template <class Shape, class Tile>
inline void intersect_in_lanes(const Shape& shape, std::span<const Ray> rays, IntersectionList* out, Tile&& tile)
{
    constexpr std::size_t kFewest = 3;  // fewer are told sooner one by one
    const LocalRays local(rays);
    for (std::size_t at = 0; at < rays.size(); at += AxisRays::kWide) {
        const std::size_t count = std::min(AxisRays::kWide, rays.size() - at);
        AxisRays::Mask alone = (1u << count) - 1u;
        if (count >= kFewest) {
            const AxisRays several = local.at(at);
            const AxisRays::Mask known = lanes::mask(several.valid()) & alone;
            alone = known & lanes::mask(several.level());
            if (known != alone) tile(several, known & ~alone, rays.subspan(at, count), out + at);
        }
        for (; alone != 0; alone &= alone - 1) {
            const std::size_t k = at + static_cast<std::size_t>(std::countr_zero(alone));
            shape.intersect(rays[k], out[k]);
        }
    }
}

}  // namespace csg
