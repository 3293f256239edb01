#pragma once

#include "numbers/functions/functions.h"
#include "render/texture/evaluate_points.h"
#include "render/texture/finish.h"
#include "render/kernel/light/shadow_rays.h"
#include "render/kernel/context/context.h"

#include <algorithm>
#include <bit>
#include <cmath>

/// What surfaces with patterns or `caustics` leave of light at the crossings of a tile's shadow rays, all together: the
/// bits of surface_filter() (spec 3, 13.2).
namespace trace {

/// Crossings of shadow rays with surfaces of patterns or `caustics`, and what they leave of light.
struct FilterScratch {
    struct Place {
        std::uint8_t ray, crossing;
    };
    csg::RayTile rays;
    csg::HitTile hits;
    TileHits places;
    std::array<Place, csg::kTileRays> place;
    /// By shadow ray and crossing, where SurfaceTraits::filters_together.
    std::array<std::array<glm::vec3, csg::CrossingTile::kMost>, csg::kTileRays> filters;
};

class SurfaceFilters {
public:
    explicit SurfaceFilters(Context& context)
        : context_(context), traits_(context.traits), kept_(context.scratch.shade.filters())
    {
        kept_.rays.count = 0;
        kept_.rays.common_origin = false;
    }

    /// The crossings of one ray from the point that it leaves.
    void add(std::size_t ray, const csg::Ray& way, const Hit* crossings, std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i) {
            if (!traits_.surfaces[crossings[i].surface].filters_together) continue;
            if (kept_.rays.count == csg::kTileRays) run();
            const auto n = static_cast<std::size_t>(kept_.rays.count++);
            kept_.rays.set(n, way, 0.0, 0.0);
            kept_.hits.set(static_cast<int>(n), crossings[i]);
            kept_.place[n] = {static_cast<std::uint8_t>(ray), static_cast<std::uint8_t>(i)};
        }
    }

    /// Works out what has been added, into FilterScratch::filters.
    void run()
    {
        const HitMask all = first_hits(kept_.rays.count);
        if (all == 0) return;
        context_.world.shading_points(kept_.rays, kept_.hits, all, kept_.places);
        turn_to_viewer(kept_.rays, kept_.places);
        for (HitMask left = all; left != 0;) {
            const csg::SurfaceId surface = kept_.hits.surface[first_hit(left)];
            const HitMask group = left & numbers::lanes::equal(kept_.hits.surface, surface);
            filter(surface, group);
            left &= ~group;
        }
        kept_.rays.count = 0;
    }

private:
    /// Layer by layer, as surface_filter() has them. Nothing looks around: places are found for a whole tile, and no
    /// pattern depends on directions.
    void filter(csg::SurfaceId id, HitMask group)
    {
        const plan::Surface& surface = context_.scene.surfaces[id];
        const auto& set = context_.scene.textures;
        const texture::Texture& texture = set.textures[surface.texture];
        const float power = surface.interior == plan::kNone ? 0.0f
                                                            : context_.scene.interiors[surface.interior].caustics_power;
        Seen seen;
        std::array<glm::vec3, csg::kTileRays> light;
        const auto count = static_cast<std::size_t>(std::popcount(group));
        std::fill_n(light.begin(), count, glm::vec3(1));
        for (std::uint32_t i = texture.count; i-- > 0;) {
            const texture::Layer& layer = set.layers[texture.first + i];
            const texture::Pigment& pigment = set.pigments[layer.pigment];
            if (pigment.kind == texture::Pigment::Kind::Solid) {
                const glm::vec3 passes = texture::passed(pigment.color);
                for (std::size_t n = 0; n < count; ++n) light[n] *= passes;
            } else {
                look(group, seen);
                texture::ColorPoints colors;
                texture::pigment_colors(set, layer.pigment, seen.points, seen.around, colors);
                const bool ends = pigment.kind == texture::Pigment::Kind::Image;
                for (std::size_t n = 0; n < count; ++n) {
                    if (ends && texture::pigment_missing(set, layer.pigment, seen.points.at(n), seen.nothing)) continue;
                    const scene::Color c = colors.at(n);
                    light[n] *= texture::passed(c);
                }
            }
            if (power != 0.0f) focus(layer.normal, static_cast<double>(power), group, seen, light);
        }
        std::size_t n = 0;
        for_each_hit(group,
                     [&](std::size_t k) { kept_.filters[kept_.place[k].ray][kept_.place[k].crossing] = light[n++]; });
    }

    /// Crossings of one surface as patterns see them.
    struct Seen {
        texture::Points points;
        texture::Around around;
        texture::Surroundings nothing;
    };
    void look(HitMask group, Seen& seen) const
    {
        if (seen.points.count != 0) return;
        for_each_hit(group, [&](std::size_t k) {
            seen.around[seen.points.size()] = &seen.nothing;
            seen.points.add(kept_.places.point(k));
        });
        seen.points.pad();
    }

    /// What a layer makes of light that comes straight at it.
    void focus(std::uint32_t normal, double power, HitMask group, Seen& seen,
               std::array<glm::vec3, csg::kTileRays>& light) const
    {
        texture::Points n;
        for_each_hit(group, [&](std::size_t k) { n.add(kept_.places.normal(k)); });
        if (normal != texture::kNone) {
            look(group, seen);
            n.pad();
            texture::perturb_points(context_.scene.textures, normal, seen.points, seen.around, n);
            texture::normalize_points(n);
        }
        std::size_t i = 0;
        for_each_hit(group, [&](std::size_t k) {
            const glm::dvec3 d = kept_.rays.ray(static_cast<int>(k)).direction;
            light[i] *= static_cast<float>(1.0 + numbers::pow(std::abs(glm::dot(n.at(i), d)), power));
            ++i;
        });
    }

    Context& context_;
    const plan::SceneTraits& traits_;
    FilterScratch& kept_;
};

}  // namespace trace
