#pragma once

#include "csg/base/hit.h"
#include "csg/base/points.h"

#include <array>
#include <span>

namespace csg {

/// Rays of a tile, coordinate by coordinate, as lanes load them. Missing ones are zeros.
class LocalRays {
public:
    static constexpr std::size_t kWide = static_cast<std::size_t>(lanes::kDoubles);

    explicit LocalRays(std::span<const Ray> rays)
    {
        for (std::size_t k = 0; k < rays.size(); ++k)
            for (std::size_t i = 0; i < 3; ++i) {
                origin_[i][k] = rays[k].origin[static_cast<glm::length_t>(i)];
                way_[i][k] = rays[k].direction[static_cast<glm::length_t>(i)];
            }
    }
    /// As many as there are lanes, from ray k on, a multiple of their number.
    lanes::Points origins(std::size_t k) const { return load(origin_, k); }
    lanes::Points ways(std::size_t k) const { return load(way_, k); }

private:
    static lanes::Points load(const std::array<std::array<double, kTileRays>, 3>& of, std::size_t k)
    {
        const auto row = [k](const auto& one) { return lanes::Double::load_aligned(one.data() + k); };
        return {row(of[0]), row(of[1]), row(of[2])};
    }

    alignas(64) std::array<std::array<double, kTileRays>, 3> origin_{}, way_{};
};

}  // namespace csg
