#pragma once

#include "csg/base/hit.h"
#include "csg/freeform/shared/intersection_list.h"
#include "csg/freeform/revolution/axis_ray.h"

#include <array>
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
        const auto load = [&](const auto& of) { return AxisRays::Double::load_aligned(of.data() + k); };
        return AxisRays({load(origin_[0]), load(origin_[1]), load(origin_[2])},
                        {load(way_[0]), load(way_[1]), load(way_[2])});
    }

private:
    alignas(64) std::array<std::array<double, kTileRays>, 3> origin_{}, way_{};
};

/// Asks a solid of revolution for rays in lanes. Tile(shape, local, first ray, rays, out).run() answers as many as
/// there are lanes as shape.intersect() does.
template <class Tile, class Shape>
inline void intersect_in_lanes(const Shape& shape, std::span<const Ray> rays, IntersectionList* out)
{
    constexpr std::size_t kFewest = 3;  // fewer are told sooner one by one
    const LocalRays local(rays);
    for (std::size_t at = 0; at < rays.size(); at += AxisRays::kWide) {
        const std::size_t count = std::min(AxisRays::kWide, rays.size() - at);
        if (count < kFewest)
            for (std::size_t k = at; k < at + count; ++k) shape.intersect(rays[k], out[k]);
        else Tile(shape, local, at, rays.subspan(at, count), out + at).run();
    }
}

}  // namespace csg
