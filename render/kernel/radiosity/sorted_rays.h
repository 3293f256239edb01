#pragma once

#include "numbers/lanes.h"
#include "render/kernel/radiosity/samples/direction_order.h"
#include "render/kernel/radiosity/gather_scratch.h"

#include <algorithm>
#include <bit>

/// The rays of one sample in the order of their directions.
namespace trace::radiosity {

class SortedRays {
public:
    /// \param first of the sample's directions in the pool
    SortedRays(const DirectionOrder& order, std::size_t first, std::size_t count, GatherScratch& scratch)
        : order_(order), first_(first), count_(count), groups_((count + kGroup - 1) / kGroup),
          tiles_((groups_ * kGroup + csg::kTileRays - 1) / csg::kTileRays), scratch_(scratch)
    {
        const std::size_t pool = order.place.size();
        scratch_.taken.assign((pool + 63) / 64, 0);
        for (std::size_t k = 0, at = first; k < count; ++k, at = at + 1 == pool ? 0 : at + 1) {
            const std::uint32_t place = order.place[at];
            scratch_.taken[place / 64] |= std::uint64_t{1} << place % 64;
        }
        left_ = scratch_.taken[0];
    }

    /// Puts the directions of some more rays into the tile, turned into the frame, and their numbers beside it. Tiles
    /// are of nearly one size, in whole groups. False: there are no more.
    bool next(const Gathering& frame)
    {
        if (tile_ == tiles_) return false;
        ++tile_;
        const std::size_t until = std::min(count_, groups_ * tile_ / tiles_ * kGroup), pool = order_.place.size();
        csg::RayTile& rays = scratch_.rays;
        std::size_t k = 0;
        for (; made_ < until; ++made_, ++k, left_ &= left_ - 1) {
            while (left_ == 0) left_ = scratch_.taken[++word_];
            const auto place = 64 * word_ + static_cast<std::size_t>(std::countr_zero(left_));
            const auto& [way, number] = order_.entries[place];
            rays.dx[k] = way.x, rays.dy[k] = way.y, rays.dz[k] = way.z;
            scratch_.number[k] =
                static_cast<std::uint16_t>(number >= first_ ? number - first_ : number + pool - first_);
        }
        rays.count = static_cast<int>(k);
        turn(frame, k);
        return true;
    }

private:
    static constexpr std::size_t kGroup = 8;  ///< rays that are traced at a time

    void turn(const Gathering& g, std::size_t count)
    {
        using numbers::lanes::Double;
        csg::RayTile& rays = scratch_.rays;
        for (std::size_t k = 0; k < count; k += numbers::lanes::kDoubles) {
            const Double x = Double::load_aligned(rays.dx.data() + k), y = Double::load_aligned(rays.dy.data() + k),
                         z = Double::load_aligned(rays.dz.data() + k);
            const auto turned = [&](int axis) {
                return Double(g.x[axis]) * x + Double(g.y[axis]) * y + Double(g.z[axis]) * z;
            };
            turned(0).store_aligned(rays.dx.data() + k);
            turned(1).store_aligned(rays.dy.data() + k);
            turned(2).store_aligned(rays.dz.data() + k);
        }
    }

    const DirectionOrder& order_;
    std::size_t first_, count_, groups_, tiles_;
    GatherScratch& scratch_;
    std::size_t tile_ = 0, made_ = 0, word_ = 0;
    std::uint64_t left_;
};

}  // namespace trace::radiosity
