#pragma once

#include "render/texture/evaluate_points.h"
#include "render/trace/light/shadow_rays.h"
#include "render/trace/shade/shade_context.h"

#include <cmath>

/// What surfaces with `caustics` leave of light at the crossings of a tile's shadow rays, all together: the bits of
/// surface_filter() (spec 3, 13.2). Compiled once per instruction set.
namespace trace {

class FocusedLight {
public:
    explicit FocusedLight(Context& context)
        : context_(context), traits_(context.scratch.shade.traits), kept_(*context.scratch.shade.focused)
    {
        kept_.rays.count = 0;
        kept_.rays.common_origin = false;
    }

    /// The crossings of one ray from the point that it leaves.
    void add(std::size_t ray, const csg::Ray& way, const Hit* crossings, std::size_t count)
    {
        for (std::size_t i = 0; i < count; ++i) {
            if (!traits_.surfaces[crossings[i].surface].focuses) continue;
            if (kept_.rays.count == csg::kTileRays) run();
            const auto n = static_cast<std::size_t>(kept_.rays.count++);
            kept_.rays.set(n, way, 0.0, 0.0);
            kept_.hits.set(static_cast<int>(n), crossings[i]);
            kept_.place[n] = {static_cast<std::uint8_t>(ray), static_cast<std::uint8_t>(i)};
        }
    }

    /// Works out what has been added, into FocusScratch::filters.
    void run()
    {
        const HitMask all = first_hits(kept_.rays.count);
        if (all == 0) return;
        context_.world.places(kept_.rays, kept_.hits, all, kept_.places);
        turn_to_viewer(kept_.rays, kept_.places);
        for (HitMask left = all; left != 0;) {
            const csg::SurfaceId surface = kept_.hits.surface[first_hit(left)];
            const HitMask group = left & csg::lanes::equal(kept_.hits.surface, surface);
            filter(surface, group);
            left &= ~group;
        }
        kept_.rays.count = 0;
    }

private:
    void filter(csg::SurfaceId id, HitMask group)
    {
        const plan::Surface& surface = context_.scene.surfaces[id];
        const auto& set = context_.scene.textures;
        const auto power = static_cast<double>(context_.scene.interiors[surface.interior].caustics_power);
        const std::uint32_t normal = set.layers[set.textures[surface.texture].first].normal;
        const glm::vec3 color = traits_.surfaces[id].filter;
        texture::Points n;
        for_each_hit(group, [&](std::size_t k) { n.add(kept_.places.normal(k)); });
        if (normal != texture::kNone) bend(normal, group, n);
        std::size_t i = 0;
        for_each_hit(group, [&](std::size_t k) {
            const glm::dvec3 d = kept_.rays.ray(static_cast<int>(k)).direction;
            const double focus = std::pow(std::abs(glm::dot(n.at(i++), d)), power);
            glm::vec3 light = color;
            light *= static_cast<float>(1.0 + focus);
            kept_.filters[kept_.place[k].ray][kept_.place[k].crossing] = light;
        });
    }

    /// Nothing looks around: the surface's place is found for a whole tile, and no pattern depends on directions.
    void bend(std::uint32_t normal, HitMask group, texture::Points& n)
    {
        texture::Points points;
        texture::Around around;
        const texture::Surroundings nothing;
        around.fill(&nothing);
        for_each_hit(group, [&](std::size_t k) { points.add(kept_.places.point(k)); });
        points.pad();
        n.pad();
        texture::perturb_points(context_.scene.textures, normal, points, around, n);
    }

    Context& context_;
    const SceneTraits& traits_;
    FocusScratch& kept_;
};

}  // namespace trace
