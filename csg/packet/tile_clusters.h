#pragma once

#include "csg/base/hit.h"
#include "csg/packet/lanes/lane_interval.h"

#include <algorithm>
#include <array>
#include <utility>

namespace csg {

/// A tile's rays in parts that make slimmer beams.
class TileClusters {
public:
    /// By the octant that they point to: each is narrow enough for a beam.
    static TileClusters by_direction(const RayTile& rays)
    {
        TileClusters out;
        std::array<std::uint8_t, 8> cluster;
        cluster.fill(kNone);
        out.size_ = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); ++i) {
            const unsigned octant = (rays.dx[i] < 0.0 ? 1u : 0u) | (rays.dy[i] < 0.0 ? 2u : 0u) |
                                    (rays.dz[i] < 0.0 ? 4u : 0u);
            if (cluster[octant] == kNone) cluster[octant] = static_cast<std::uint8_t>(out.size_++);
            out.of_ray_[i] = cluster[octant];
        }
        return out;
    }

    /// Shadow rays by distance from the light, cut where there is a gap: what lies on one object makes a slimmer beam
    /// than foreground and background together.
    static TileClusters by_distance(const RayTile& rays)
    {
        TileClusters out;
        out.cut_at_gaps(rays);
        return out;
    }

    int size() const { return size_; }

    /// Copies the rays of cluster c; `index` receives where they stood.
    void part(const RayTile& rays, int c, RayTile& out, std::uint8_t (&index)[kTileRays]) const
    {
        out.count = 0;
        out.common_origin = rays.common_origin;
        for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); ++i) {
            if (of_ray_[i] != c) continue;
            const auto k = static_cast<std::size_t>(out.count++);
            index[k] = static_cast<std::uint8_t>(i);
            out.ox[k] = rays.ox[i], out.oy[k] = rays.oy[i], out.oz[k] = rays.oz[i];
            out.dx[k] = rays.dx[i], out.dy[k] = rays.dy[i], out.dz[k] = rays.dz[i];
            out.t_min[k] = rays.t_min[i];
            out.t_max[k] = rays.t_max[i];
        }
    }

private:
    void cut_at_gaps(const RayTile& rays)
    {
        if (!rays.common_origin || rays.count < kFewest) return;
        const auto count = static_cast<std::size_t>(rays.count);
        const auto [least, most] = range(rays.t_max, count);
        const double scale = kBins / (most - least);
        if (!(scale > 0.0 && scale < kInfinity)) return;
        std::array<int, kTileRays> bin;
        for (std::size_t i = 0; i < count; ++i)
            bin[i] = std::min(kBins - 1, static_cast<int>((rays.t_max[i] - least) * scale));
        std::uint32_t filled = 0;
        for (std::size_t i = 0; i < count; ++i) filled |= 1u << bin[i];
        std::array<std::uint8_t, kBins> cluster{};
        int empty = 0;
        for (std::size_t b = 0; b < kBins; ++b) {
            if ((filled >> b & 1u) == 0) {
                ++empty;
                continue;
            }
            if (empty >= kGap) ++size_;
            empty = 0;
            cluster[b] = static_cast<std::uint8_t>(size_ - 1);
        }
        if (size_ == 1) return;
        for (std::size_t i = 0; i < count; ++i) of_ray_[i] = cluster[static_cast<std::size_t>(bin[i])];
    }

    /// The least and the most of the first so many values.
    static std::pair<double, double> range(const std::array<double, kTileRays>& values, std::size_t count)
    {
        using lanes::Double;
        constexpr auto kLanes = static_cast<std::size_t>(lanes::kDoubles);
        Double low(kInfinity), high(-kInfinity);
        std::size_t i = 0;
        for (; i + kLanes <= count; i += kLanes) {
            const Double v = Double::load_aligned(values.data() + i);
            low = xsimd::min(low, v);
            high = xsimd::max(high, v);
        }
        double least = lanes::lowest(low), most = -lanes::lowest(-high);
        for (; i < count; ++i) {
            least = std::min(least, values[i]);
            most = std::max(most, values[i]);
        }
        return {least, most};
    }

    static constexpr std::uint8_t kNone = 0xff;
    static constexpr int kBins = 16, kGap = 6;  ///< of the whole range, and how many empty ones are a gap
    static constexpr int kFewest = 16;
    int size_ = 1;
    std::array<std::uint8_t, kTileRays> of_ray_{};
};

}  // namespace csg
