#pragma once

#include "render/kernel/light/tile_attenuation.h"
#include "render/kernel/light/shadow_caster.h"
#include "render/kernel/tile/tile_lanes.h"
#include "render/kernel/media/media_photons.h"
#include "render/kernel/media/media_scratch.h"
#include "render/kernel/tile/nearly_zero.h"

namespace trace {

/// Light of lamps at points in media: the tile that shadow rays start from. It has a Scratch of its own, since that of
/// the tile whose segments are being integrated still holds its hits.
class PointLights {
public:
    /// \param context     with that Scratch
    /// \param met         how far the points lie from the origins of their rays
    /// \param around      by point: what it is inside of
    /// \param collecting  points that collect photons: there photon targets block the lamps' direct light
    PointLights(Context& context, const csg::HitTile& met,
                const std::array<const InteriorList*, csg::kTileRays>& around, const texture::Points& points,
                HitMask collecting)
        : hits(met), context_(context), scratch_(context.scratch.shade), around_(around), count_(points.count)
    {
        TileHits& at = scratch_.hits;
        at.x = points.x.v, at.y = points.y.v, at.z = points.z.v;
        scratch_.lamp.photons.scene = has_surface_photons(context) ? &context.scene : nullptr;
        scratch_.lamp.photons.lit = collecting;
    }

    /// Finds what light `number` of the context brings to the points `asking`, for color(). Returns the points that it
    /// reaches.
    HitMask ask(std::size_t number, HitMask asking)
    {
        const light::Light& light = context_.lights.lights[number];
        scratch_.lamp.photons.of_light(number);
        const HitMask colored = steady(light) ? from_one_point(light) : from_each(light, asking);
        reached_ = 0;
        asking &= colored;
        if (asking == 0) return 0;
        if (light.area) {
            TileColors& seen = scratch_.lamp.shadowed;
            ShadowCaster(context_, *this, *this).cast_area(light, asking, seen);
            for_each_hit(asking, [&](std::size_t k) { this->light(k, seen[k]); });
        } else {
            ShadowCaster(context_, *this, *this).cast(light, asking, asking);
        }
        return reached_;
    }

    glm::vec3 color(std::size_t k) const { return colors_[k]; }
    glm::dvec3 direction(std::size_t k) const { return scratch_.lamp.light.direction(k); }
    const TileLight& directions() const { return scratch_.lamp.light; }

    // What ShadowCaster asks of a tile.
    static constexpr bool kInAir = true;
    const csg::HitTile& hits;
    int count() const { return count_; }
    const InteriorList& interiors(std::size_t k) const { return *around_[k]; }

    // What ShadowCaster tells.
    void light(HitMask hits_reached)
    {
        for_each_hit(hits_reached, [this](std::size_t k) { light(k, scratch_.lamp.colors[k]); });
    }
    void light(std::size_t k, const glm::vec3& color)
    {
        colors_[k] = color;
        if (!dark(color)) reached_ |= HitMask{1} << k;
    }
    void arrive(std::size_t, const glm::vec3&) {}
    HitMask arrives() const { return 0; }

private:
    HitMask from_one_point(const light::Light& light)
    {
        toward_lamp(light, scratch_.hits, count_, scratch_.lamp.light);
        scratch_.lamp.colors.fill(light.color);
        return ~HitMask{0};
    }

    HitMask from_each(const light::Light& light, HitMask asking)
    {
        HitMask colored = 0;
        toward_lamp(light, scratch_.hits, count_, scratch_.lamp.light);
        alignas(64) TileLanes share;
        attenuate(light, asking, scratch_.hits, scratch_.lamp.light, share);
        for_each_hit(asking, [&](std::size_t k) {
            const glm::vec3 color = light.color * static_cast<float>(share[k]);
            scratch_.lamp.colors[k] = color;
            colored |= HitMask{dark(color) ? 0u : 1u} << k;
        });
        return colored;
    }

    Context& context_;
    ShadeScratch& scratch_;
    const std::array<const InteriorList*, csg::kTileRays>& around_;
    int count_;
    HitMask reached_ = 0;
    std::array<glm::vec3, csg::kTileRays> colors_;
};

}  // namespace trace
