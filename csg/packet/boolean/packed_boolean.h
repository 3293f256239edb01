#pragma once

#include "numbers/bits.h"
#include "csg/packet/boolean/lane_boolean.h"

/// A CSG object's boolean form against some rays of a tile.
namespace csg {

/// LaneBoolean; where the rays asked of lie scattered over the tile they are packed first, so that vectors are full:
/// the form of an arch has a dozen solids, and the rays that come to it are as a rule a few of each group.
template <class Rays>
class PackedBoolean {
public:
    PackedBoolean(const SolidStore& store, const Rays& rays) : rays_(rays), whole_(store, rays), packed_(store, few_) {}

    /// As LaneBoolean::ask().
    void ask(const Program& program, RayMask mask, bool nearest_only, Scratch& scratch)
    {
        is_packed_ = scattered(mask);
        if (!is_packed_) {
            whole_.ask(program, mask, nearest_only, scratch);
            found = whole_.found;
            undecided = whole_.undecided;
            return;
        }
        pack(mask);
        packed_.rays_changed(place_.data());
        packed_.ask(program, few_.all(), nearest_only, scratch);
        found = deposited(packed_.found, mask);  // in the order of the packed rays
        undecided = deposited(packed_.undecided, mask);
    }

    /// Calls f(ray, Hit) for the crossings of the rays that were found: one of each, or all in any order.
    template <class F>
    void each_crossing(F&& f) const
    {
        if (is_packed_)
            each_ray(packed_.found, [&](std::size_t i) {
                packed_.each_crossing(i, [&](const Hit& hit) { f(std::size_t{place_[i]}, hit); });
            });
        else
            each_ray(whole_.found, [&](std::size_t k) { whole_.each_crossing(k, [&](const Hit& hit) { f(k, hit); }); });
    }

    RayMask found = 0, undecided = 0;

private:
    /// Packed rays fill fewer vectors.
    static bool scattered(RayMask mask)
    {
        int vectors = 0;
        each_vector(mask, [&](int) { ++vectors; });
        return (std::popcount(mask) + lanes::kDoubles - 1) / lanes::kDoubles < vectors;
    }

    void pack(RayMask mask)
    {
        std::size_t i = 0;
        each_ray(mask, [&](std::size_t k) { take(k, i++); });
        few_.count = static_cast<int>(i);
        few_.groups = (few_.count + kRayGroup - 1) / kRayGroup;
        const auto last = static_cast<std::size_t>(std::bit_width(mask) - 1);
        for (const auto end = static_cast<std::size_t>(few_.groups * kRayGroup); i < end; ++i) {
            take(last, i);
            few_.limit[i] = -kInfinity;
        }
        few_.places = few_.groups * kRayGroup;
        few_.turned.forget();
    }
    void take(std::size_t k, std::size_t i)
    {
        place_[i] = static_cast<std::uint8_t>(k);
        const glm::dvec3 origin = rays_.origin_of(k);
        few_.ox[i] = origin.x, few_.oy[i] = origin.y, few_.oz[i] = origin.z;
        few_.dx[i] = rays_.dx[k], few_.dy[i] = rays_.dy[k], few_.dz[i] = rays_.dz[k];
        few_.inverse_x[i] = rays_.inverse_x[k];
        few_.inverse_y[i] = rays_.inverse_y[k];
        few_.inverse_z[i] = rays_.inverse_z[k];
        few_.inverse_a[i] = rays_.inverse_a[k];
        few_.t_min[i] = rays_.t_min[k];
        few_.limit[i] = rays_.limit[k];
    }

    const Rays& rays_;
    bool is_packed_ = false;
    TileRays<OwnOrigins> few_;                   ///< the packed rays
    std::array<std::uint8_t, kTileRays> place_;  ///< theirs in the tile
    LaneBoolean<Rays> whole_;
    LaneBoolean<TileRays<OwnOrigins>> packed_;
};

}  // namespace csg
