#pragma once

#include "render/trace/shade_context.h"
#include "render/trace/shade_light.h"

#include <algorithm>
#include <cmath>

/// A tile's hits whose layers neither bend the normal nor mirror: all of them go through a light together. Compiled once per
/// instruction set.
namespace trace {

class FlatHits {
public:
    explicit FlatHits(Context& context) : set_(context.scene.textures), scratch_(context.scratch.shade), bailout_(static_cast<float>(context.scene.settings.adc_bailout)) {}

    /// Hit k is none, or not yet.
    void none(std::size_t k) { scratch_.flat[k].count = 0; }
    bool holds(std::size_t k) const { return scratch_.flat[k].count != 0; }
    /// It has its colour once the lights are through.
    bool done(std::size_t k) const { return holds(k) && !scratch_.flat[k].goes_on; }
    const FlatLayer& top(std::size_t k) const { return scratch_.flat_layers[scratch_.flat[k].first]; }

    /// A hit of one layer; its pigment comes by color().
    void begin(std::size_t k, const LoneLayer& lone)
    {
        scratch_.flat[k] = {layers_, 0, lone.goes_on};
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
        scratch_.flat[k] = {layers_, 0, false};
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
            for_lit([this](const LitHit& lit, FlatLayer& layer) { scratch_.highlights.ask(lit.hit, *layer.finish); });
            scratch_.highlights.run();
        }
        for_lit([&](const LitHit& lit, FlatLayer& layer) {
            const std::size_t k = lit.hit;
            const glm::dvec3 d{rays.dx[k], rays.dy[k], rays.dz[k]}, n = scratch_.hits.normal(k);
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
            const FlatHit& flat = scratch_.flat[scratch_.lit[i].hit];
            for (std::size_t l = flat.first; l < std::size_t{flat.first} + flat.count; ++l) visit(scratch_.lit[i], scratch_.flat_layers[l]);
        }
    }

    const texture::TextureSet& set_;
    ShadeScratch& scratch_;
    const float bailout_;
    std::size_t lit_ = 0;
    std::uint16_t layers_ = 0;
    bool glints_ = false;    ///< some layer has highlights
};

}  // namespace trace
