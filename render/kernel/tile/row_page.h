#pragma once

#include "render/texture/evaluate_points.h"
#include "render/texture/finish.h"
#include "render/kernel/tile/hit_mask.h"
#include "render/kernel/tile/tile_lanes.h"

#include <array>

namespace trace {

using TileFloats = std::array<float, csg::kTileRays>;

/// A colour for each hit.
struct alignas(64) TileColors {
    alignas(64) TileFloats red, green, blue;

    glm::vec3 operator[](std::size_t k) const { return {red[k], green[k], blue[k]}; }
    void set(std::size_t k, const glm::vec3& c)
    {
        red[k] = c.x;
        green[k] = c.y;
        blue[k] = c.z;
    }
    void fill(float v)
    {
        red.fill(v);
        green.fill(v);
        blue.fill(v);
    }
    /// One colour for a tile's first `count` hits, and for places that fill up the last lanes.
    void fill(const glm::vec3& c, int count)
    {
        each_place(count, [&](std::size_t k) { red[k] = c.x; });
        each_place(count, [&](std::size_t k) { green[k] = c.y; });
        each_place(count, [&](std::size_t k) { blue[k] = c.z; });
    }
};

inline constexpr std::array<TileFloats TileColors::*, 3> kChannels = {&TileColors::red, &TileColors::green,
                                                                      &TileColors::blue};

/// What highlights need of the finish of each hit.
struct alignas(64) SpecularLobe {
    alignas(64) TileLanes phong, phong_size, specular, exponent;

    void set(std::size_t k, const texture::Finish& f)
    {
        phong[k] = static_cast<double>(f.phong);
        phong_size[k] = static_cast<double>(f.phong_size);
        specular[k] = static_cast<double>(f.specular);
        exponent[k] = static_cast<double>(f.specular_exponent);
    }
    void fill(const texture::Finish& f)
    {
        phong.fill(static_cast<double>(f.phong));
        phong_size.fill(static_cast<double>(f.phong_size));
        specular.fill(static_cast<double>(f.specular));
        exponent.fill(static_cast<double>(f.specular_exponent));
    }
};

/// Up to one row of each hit on its way through the lights: a layer of a texture that it shows.
struct RowPage {
    HitMask holds, bent;     ///< hits that have a row here; of them, those with a normal of their own
    HitMask scalar;          ///< of them, those that go through the lights one by one
    HitMask lit, shiny;      ///< with diffuse light; with highlights
    HitMask grainy;          ///< from whose diffuse light `crand` takes some off; alone on their hits
    HitMask raised, tinted;  ///< whose diffuse cosine is raised to a power; whose highlights are metallic
    std::array<const texture::Finish*, csg::kTileRays> finish;
    SpecularLobe lobe;   ///< of the shiny hits
    TileColors emitted;  ///< by the finish: its ambient and emission
    alignas(64) TileFloats finish_diffuse;
    TileColors pigment, glow;             ///< glow: ambient and emission
    TileColors gained_before;             ///< by lights before those of a group (DirectBatch::begin_group)
    TileColors gained, filter;            ///< what the lights have added so far; what the layers above let through
    texture::ColorPoints scalar_pigment;  ///< of the rows of `scalar`
    alignas(64) TileFloats alpha;         ///< opacity; in lanes where there is indirect light
    std::array<glm::vec2, csg::kTileRays> passes;  ///< filter and transmit of the pigment; in lanes if recorded
    alignas(64) TileLanes diffuse;                 ///< times the layer's opacity
    alignas(64) TileLanes nx, ny, nz;              ///< all hits' where some are bent

    glm::dvec3 normal(std::size_t k) const { return {nx[k], ny[k], nz[k]}; }
};

/// A row of a texture that is gone through by itself.
struct LitRow {
    const texture::Finish& finish;
    const scene::Color& pigment;
    const glm::vec3& filter;  ///< of the layers above
    float alpha;              ///< opacity
    float glows;              ///< share of what the finish emits that leaves for the viewer
    const glm::dvec3& normal;
    const glm::dvec3& raw_normal;  ///< of the hit
    bool two_sided;                ///< double_illuminate
};

}  // namespace trace
