#pragma once

#include "render/texture/evaluate_points.h"
#include "render/trace/shade_context.h"
#include "render/trace/shade_light.h"

#include <algorithm>
#include <cmath>

/// A tile's hits on surfaces of colours, diffuse light and highlights: all of them go through a light together. Compiled once
/// per instruction set.
namespace trace {

class FlatHits {
public:
    explicit FlatHits(Context& context) : set_(context.scene.textures), scratch_(context.scratch.shade), bailout_(static_cast<float>(context.scene.settings.adc_bailout)),
          bends_normals_(context.scene.settings.quality >= 8)
    {
    }


    /// Hit k is none, or not yet.
    void none(std::size_t k) { scratch_.flat[k].count = 0; }
    bool holds(std::size_t k) const { return scratch_.flat[k].count != 0; }
    /// It has its colour once the lights are through.
    bool done(std::size_t k) const { return holds(k) && !scratch_.flat[k].goes_on; }
    bool bent(std::size_t k) const { return scratch_.flat[k].bent; }
    const FlatLayer& top(std::size_t k) const { return scratch_.flat_layers[scratch_.flat[k].first]; }

    /// A hit of one layer; its pigment comes by color().
    void begin(std::size_t k, const LoneLayer& lone)
    {
        scratch_.flat[k] = {layers_, 0, lone.goes_on, false};
        add_layer(k, set_.layers[lone.index]);
    }

    void color(std::size_t k, const scene::Color& c)
    {
        const FlatHit& flat = scratch_.flat[k];
        color(scratch_.flat_layers[flat.first], c, flat.goes_on ? texture::opacity(c, set_.legacy_opacity) : 1.0f);
    }

    /// A hit whose layers' pigments are known; they let nothing through to what is behind.
    void begin(std::size_t k, const texture::Texture& texture, const std::array<scene::Color, kLayersAhead>& colors)
    {
        scratch_.flat[k] = {layers_, 0, false, false};
        glm::vec3 filter(1);
        float residual = 1.0f;
        for (std::uint32_t i = texture.count; i-- > 0 && residual > bailout_;) {
            FlatLayer& layer = add_layer(k, set_.layers[texture.first + i]);
            const scene::Color& c = colors[i];
            color(layer, c, texture.plain ? 1.0f : texture::opacity(c, set_.legacy_opacity));
            layer.filter = filter;
            filter *= c.filter * c.rgb() + c.transmit;
            residual = std::min(1.0f, std::abs(scene::grey(filter)));
        }
    }

    /// Bends the normals of the layers that have some; their places and surroundings are known.
    void bend()
    {
        while (bends_ != 0) {
            const std::uint32_t normal = scratch_.bends[0].normal;
            texture::Points points;
            texture::Around around;
            texture::Normals bent;
            std::array<std::uint16_t, csg::kTileRays> owner;
            std::size_t left = 0;
            for (std::size_t i = 0; i < bends_; ++i) {
                const Bend& b = scratch_.bends[i];
                const std::size_t at = points.size();
                if (b.normal != normal || at == csg::kTileRays) {
                    scratch_.bends[left++] = b;
                    continue;
                }
                around[at] = &scratch_.around[b.hit];
                bent[at] = scratch_.hits.normal(b.hit);
                owner[at] = b.layer;
                points.add(scratch_.points[b.hit]);
            }
            bends_ = left;
            points.pad();
            texture::perturb_points(set_, normal, points, around, bent);
            for (std::size_t i = 0; i < points.size(); ++i) scratch_.flat_layers[owner[i]].normal = glm::normalize(bent[i]);
        }
    }

    /// Some layer faces the direction.
    bool faces(std::size_t k, const glm::dvec3& direction) const
    {
        const FlatHit& flat = scratch_.flat[k];
        if (!flat.bent) return !(glm::dot(scratch_.hits.normal(k), direction) < kNearlyZero);
        const auto first = scratch_.flat_layers.begin() + flat.first;
        return std::any_of(first, first + flat.count, [&](const FlatLayer& layer) { return !(glm::dot(layer.normal, direction) < kNearlyZero); });
    }

    bool lit(std::size_t k) const
    {
        const FlatHit& flat = scratch_.flat[k];
        return flat.count > 1 || scratch_.flat_layers[flat.first].finish->lit();
    }

    /// The light at hand reaches hit k.
    void light(std::size_t k, const glm::vec3& color)
    {
        if (std::abs(color.x) > kDark || std::abs(color.y) > kDark || std::abs(color.z) > kDark)
            scratch_.lit[lit_++] = {static_cast<std::uint8_t>(k), color};
    }

    /// Adds what the light at hand gives to the hits that it reaches; it is over then.
    void add(const light::Light& light, const csg::RayTile& rays)
    {
        const bool highlights = glints_ && !light.shadowless && lit_ != 0;
        if (highlights) {
            scratch_.highlights.cosines(rays, scratch_.hits, scratch_.light, rays.count);
            for_lit([&](const LitHit& lit, FlatLayer& layer, bool bent) {
                const std::size_t k = lit.hit;
                if (!bent) return scratch_.highlights.ask(k, *layer.finish);
                scratch_.highlights.ask(*layer.finish, {rays.dx[k], rays.dy[k], rays.dz[k]}, layer.normal, scratch_.light.direction(k));
            });
            scratch_.highlights.run();
        }
        for_lit([&](const LitHit& lit, FlatLayer& layer, bool bent) {
            const std::size_t k = lit.hit;
            const glm::dvec3 d{rays.dx[k], rays.dy[k], rays.dz[k]}, n = bent ? layer.normal : scratch_.hits.normal(k);
            layer.lit += surface_light({*layer.finish, layer.pigment, d, n, static_cast<double>(layer.alpha)}, scratch_.light.direction(k), lit.color,
                                       false, highlights ? scratch_.highlights.next() : 0.0, 0.0);
        });
        lit_ = 0;
    }

    /// Light of all layers as the viewer sees it.
    glm::vec3 sum(std::size_t k) const
    {
        const FlatHit& flat = scratch_.flat[k];
        const FlatLayer* layer = &scratch_.flat_layers[flat.first];
        if (flat.count == 1) return layer->glow + layer->lit;
        glm::vec3 sum(0);
        for (const FlatLayer* end = layer + flat.count; layer != end; ++layer) sum += layer->filter * (layer->glow + layer->lit);
        return sum;
    }

private:
    FlatLayer& add_layer(std::size_t k, const texture::Layer& of)
    {
        FlatLayer& layer = scratch_.flat_layers[layers_++];
        ++scratch_.flat[k].count;
        layer.finish = &set_.finishes[of.finish];
        layer.normal = scratch_.hits.normal(k);
        if (of.normal != texture::kNone && bends_normals_) {
            scratch_.flat[k].bent = true;
            scratch_.bends[bends_++] = {of.normal, static_cast<std::uint16_t>(layers_ - 1), static_cast<std::uint8_t>(k)};
        }
        glints_ |= layer.finish->phong > 0.0f || layer.finish->specular > 0.0f;
        return layer;
    }

    static void color(FlatLayer& layer, const scene::Color& c, float alpha)
    {
        layer.pigment = c;
        layer.alpha = alpha;
        layer.glow = c.rgb() * (layer.finish->ambient + layer.finish->emission) * alpha;
        layer.lit = glm::vec3(0);
    }

    template <class Visit>
    void for_lit(Visit&& visit)
    {
        for (std::size_t i = 0; i < lit_; ++i) {
            const LitHit& lit = scratch_.lit[i];
            const FlatHit& flat = scratch_.flat[lit.hit];
            for (std::size_t l = flat.first; l < std::size_t{flat.first} + flat.count; ++l) {
                FlatLayer& layer = scratch_.flat_layers[l];
                if (!flat.bent || !(glm::dot(layer.normal, scratch_.light.direction(lit.hit)) < kNearlyZero)) visit(lit, layer, flat.bent);
            }
        }
    }

    const texture::TextureSet& set_;
    ShadeScratch& scratch_;
    const float bailout_;
    const bool bends_normals_;
    std::size_t lit_ = 0, bends_ = 0;
    std::uint16_t layers_ = 0;
    bool glints_ = false;    ///< some layer has highlights
};

}  // namespace trace
