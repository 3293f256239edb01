#pragma once

#include "render/texture/finish.h"
#include "render/trace/shade_lanes.h"

#include <array>
#include <bit>
#include <cstdint>

namespace trace {

/// Bit k: hit k of the tile.
using HitMask = std::uint64_t;
static_assert(csg::kTileRays == 64);

/// f(k) for every hit of a mask, the first one first.
template <class F>
inline void for_each_hit(HitMask mask, F&& f)
{
    for (; mask != 0; mask &= mask - 1) f(static_cast<std::size_t>(std::countr_zero(mask)));
}

inline std::size_t first_hit(HitMask mask) { return static_cast<std::size_t>(std::countr_zero(mask)); }
inline bool has(HitMask mask, std::size_t k) { return (mask >> k & 1) != 0; }

/// Hits 0 <= k < count.
inline HitMask first_hits(int count) { return count < csg::kTileRays ? (HitMask{1} << count) - 1 : ~HitMask{0}; }

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
};

/// The hits' layers at one depth below the top, on their way through the lights.
struct FlatDepth {
    HitMask holds, bent;             ///< hits that have a layer here; of them, those with a normal of their own
    HitMask lit, shiny;              ///< with diffuse light; with highlights
    HitMask raised, tinted;          ///< whose diffuse cosine is raised to a power; whose highlights are metallic
    std::array<const texture::Finish*, csg::kTileRays> finish;
    TileColors pigment, glow;        ///< glow: ambient and emission
    TileColors gained, filter;       ///< what the lights have added so far; what the layers above let through
    alignas(64) TileLanes diffuse;   ///< times the layer's opacity
    alignas(64) TileLanes nx, ny, nz;   ///< all hits' where some are bent

    glm::dvec3 normal(std::size_t k) const { return {nx[k], ny[k], nz[k]}; }
};

}  // namespace trace
