#pragma once

#include "csg/packet/lanes/tile_rays.h"
#include "render/kernel/tile/hit_mask.h"
#include "numbers/random.h"
#include "render/kernel/tile/tile_lanes.h"
#include "render/kernel/subsurface/subsurface_scratch.h"
#include "render/kernel/tile/nearly_zero.h"

#include <array>

/// Where light goes in below a surface, for the rays of a tile, in vector lanes.
namespace trace {

/// Of a surface that a ray of so many mm stands for, mm^2. facing: how far the surface looks at it.
template <class T>
inline T entry_area(const T& mm, const T& facing)
{
    const T flattest(0.01);
    return T(4.0 * std::numbers::pi) * mm * mm / numbers::lanes::choose(facing > flattest, facing, flattest);
}

/// A tile whose rays have met places where light goes in.
struct EntryTile {
    const RayTile& rays;
    const csg::HitTile& met;
    const csg::ShadingPoints& places;
    double mm_per_unit;

    using Double = numbers::lanes::Double;

    static Double load(const std::array<double, csg::kTileRays>& lanes, int i)
    {
        return Double::load_aligned(lanes.data() + i);
    }
    /// Of normals and directions to a light.
    Double cosine(const TileLight& light, int i) const
    {
        return xsimd::abs(load(places.nx, i) * load(light.x, i) + load(places.ny, i) * load(light.y, i) +
                          load(places.nz, i) * load(light.z, i));
    }
    Double way(int i) const { return load(met.t, i) * Double(mm_per_unit); }
    Double area(int i) const
    {
        const Double facing = load(places.nx, i) * load(rays.dx, i) + load(places.ny, i) * load(rays.dy, i) +
                              load(places.nz, i) * load(rays.dz, i);
        return entry_area(way(i), xsimd::abs(facing));
    }
    /// From a point, mm^2.
    Double apart(const glm::dvec3& from, int i) const
    {
        const Double x = load(places.x, i) - Double(from.x), y = load(places.y, i) - Double(from.y),
                     z = load(places.z, i) - Double(from.z);
        return (x * x + y * y + z * z) * Double(mm_per_unit * mm_per_unit);
    }
};

/// Which sites have sent the rays of a tile, one after the other.
class SentRays {
public:
    void clear() { count_ = 0; }
    void add(std::size_t site, std::size_t k)
    {
        if (count_ == 0 || sent_[count_ - 1].site != site) sent_[count_++] = {site, 0};
        sent_[count_ - 1].rays |= HitMask{1} << k;
    }
    bool of_one_site() const { return count_ == 1; }
    /// f(site, its rays) for the sites that have sent rays of the mask.
    template <class F>
    void each(HitMask rays, F&& f) const
    {
        for (std::size_t i = 0; i < count_; ++i)
            if (const HitMask which = rays & sent_[i].rays) f(sent_[i].site, which);
    }

private:
    struct Sent {
        std::size_t site;
        HitMask rays;
    };
    std::array<Sent, csg::kTileRays> sent_;
    std::size_t count_ = 0;
};

/// How deep light is scattered on the viewer's way, by optical depth.
struct DrawnDepths {
    alignas(64) TileLanes left{};  ///< of light, from there
    alignas(64) TileLanes drawn;

    /// Samples first <= i < first + count of a site.
    void draw(std::uint64_t seed, std::uint32_t first, std::uint32_t count)
    {
        using numbers::lanes::Double;
        for (std::uint32_t i = 0; i < count; ++i) left[i] = 1.0 - numbers::random_of(seed, 0, first + i);
        for (std::uint32_t i = 0; i < count; i += numbers::lanes::kDoubles)
            (Double(0.0) - numbers::lanes::logarithm(Double::load_aligned(left.data() + i)))
                .store_aligned(drawn.data() + i);
    }
};

/// Light that is scattered many times between where it goes in and where it comes out (spec 6, 5.3).
class DiffuseEntries {
public:
    /// Forgets the rays of the tile before.
    void begin() { known_ = 0; }

    /// Light that arrives at the hits of `which`, whose rays are the site's, from a lamp. color(k): of each.
    template <class Color>
    void add(const EntryTile& tile, SubsurfaceSite& site, HitMask which, const TileLight& light, Color&& color)
    {
        const numbers::lanes::Double least(kNearlyZero), eta(site.matter.eta), zero(0.0), one(1.0);
        csg::each_vector(which, [&](int i) {
            const numbers::lanes::Double cosine = tile.cosine(light, i);
            numbers::lanes::choose(cosine >= least, cosine * (one - texture::fresnel_share(eta, cosine)), zero)
                .store_aligned(arriving_.data() + i);
        });
        sum(tile, site, which, color);
    }
    /// The same from all around.
    template <class Color>
    void add_around(const EntryTile& tile, SubsurfaceSite& site, HitMask which, Color&& color)
    {
        arriving_.fill(1.0 - texture::fresnel_share(site.matter.eta, 1.0));
        sum(tile, site, which, color);
    }

private:
    template <class Color>
    void sum(const EntryTile& tile, SubsurfaceSite& site, HitMask which, Color&& color)
    {
        if (const HitMask fresh = which & ~known_) find(tile, site, fresh);
        for_each_hit(which, [&](std::size_t k) {
            const glm::dvec3 light(color(k));
            for (int c = 0; c < 3; ++c)
                site.diffuse[c] += arriving_[k] * share_[static_cast<std::size_t>(c)][k] * light[c];
        });
    }

    void find(const EntryTile& tile, const SubsurfaceSite& site, HitMask which)
    {
        using numbers::lanes::Double;
        csg::each_vector(which, [&](int i) {
            const auto fresh = numbers::lanes::lanes_of(static_cast<std::uint32_t>(which >> i));
            const Double area = tile.area(i) * Double(site.passed), apart = tile.apart(site.point, i);
            for (int c = 0; c < 3; ++c) {
                TileLanes& share = share_[static_cast<std::size_t>(c)];
                xsimd::select(fresh, area * site.matter.dipole(c, apart), EntryTile::load(share, i))
                    .store_aligned(share.data() + i);
            }
        });
        known_ |= which;
    }

    HitMask known_ = 0;                             ///< rays whose share_ is found
    alignas(64) std::array<TileLanes, 3> share_{};  ///< by channel: of light that goes in, what comes out
    alignas(64) TileLanes arriving_;                ///< what of a light goes in
};

/// Light that is scattered once, on the viewer's way (spec 6, 5.4).
class SingleEntries {
public:
    /// left: of light, after the viewer's way to where it was scattered.
    void set(std::size_t k, const SubsurfaceSite& site, int c, double left)
    {
        const auto once = ScatteredOnce<double>::of(site.matter, c, site.cosine(), site.passed, left);
        eta_[k] = once.eta;
        extinction_[k] = once.extinction;
        outer_[k] = once.outer;
        scale_[k] = once.scale;
    }
    /// f(k, share) for the hits of `which`, which light reaches.
    template <class F>
    void each(const EntryTile& tile, HitMask which, const TileLight& light, F&& f)
    {
        csg::each_vector(which, [&](int i) {
            const numbers::lanes::Double cosine = tile.cosine(light, i);
            const ScatteredOnce<numbers::lanes::Double> once{EntryTile::load(eta_, i), EntryTile::load(extinction_, i),
                                                             EntryTile::load(outer_, i), EntryTile::load(scale_, i)};
            numbers::lanes::choose(cosine >= numbers::lanes::Double(kNearlyZero), once.share(cosine, tile.way(i)),
                                   numbers::lanes::Double(0.0))
                .store_aligned(share_.data() + i);
        });
        for_each_hit(which, [&](std::size_t k) { f(k, share_[k]); });
    }

private:
    alignas(64) TileLanes eta_{}, extinction_{}, outer_{}, scale_{}, share_;
};

}  // namespace trace
