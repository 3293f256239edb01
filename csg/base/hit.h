#pragma once

#include "csg/base/types.h"

#include <array>
#include <cstdint>

/// What is asked of geometry and what it answers: hits of one ray, and of a tile of rays as arrays.
namespace csg {

/// The winner of a ray: just enough to find it again.
struct Hit {
    double t = kInfinity;
    SurfaceId surface = kNoSurface;
    std::uint32_t part = 0;                     ///< solid (kind and index, packed as World likes): what details() needs
    std::uint32_t face = 0;                     ///< box side, cylinder cap, triangle of a mesh, ...
    bool inverted : 1 = false;                  ///< subtracted or inverse: the raw normal is negated
    std::uint32_t instance : 31 = kNoInstance;  ///< the part is one of this instance's world (csg/items/world_data.h)
    static constexpr std::uint32_t kNoInstance = 0x7fffffffu;
    bool found() const { return surface != kNoSurface; }
};

static_assert(sizeof(Hit) == 24, "many are kept");

/// Computed for the winner alone.
struct HitDetails {
    glm::dvec3 point;            ///< world
    glm::dvec3 normal;           ///< raw outward normal, unit length, negated if inverted; not yet turned to the viewer
    glm::dvec2 uv{0};            ///< only where Surface::uv_mapping asks for it
    glm::vec3 weights{1, 0, 0};  ///< how near the corners of a mesh's face are; sums to 1
};

/// How much of a surface one part of its shape has (a blob's component); all shares of a point sum to 1.
struct Share {
    std::uint32_t part;
    float weight;
};

inline constexpr int kTileSide = 8;
inline constexpr int kTileRays = kTileSide * kTileSide;

/// Up to 64 rays as arrays. Lane i of a camera tile is pixel (i % 8, i / 8) of the tile, unless compacted.
struct alignas(64) RayTile {
    std::array<double, kTileRays> ox, oy, oz, dx, dy, dz;
    std::array<double, kTileRays> t_min, t_max;
    int count = 0;
    bool common_origin = false;  ///< all rays start in one point (eye, or a point light: traced from the light)
    Ray ray(int i) const
    {
        const auto k = static_cast<std::size_t>(i);
        return {{ox[k], oy[k], oz[k]}, {dx[k], dy[k], dz[k]}};
    }
    void set(std::size_t k, const Ray& ray, double from, double to)
    {
        ox[k] = ray.origin.x, oy[k] = ray.origin.y, oz[k] = ray.origin.z;
        dx[k] = ray.direction.x, dy[k] = ray.direction.y, dz[k] = ray.direction.z;
        t_min[k] = from;
        t_max[k] = to;
    }
};

/// Nearest hits of a tile as arrays.
struct alignas(64) HitTile {
    std::array<double, kTileRays> t;
    std::array<SurfaceId, kTileRays> surface;
    std::array<std::uint32_t, kTileRays> part, face, instance;
    std::array<std::uint8_t, kTileRays> inverted;
    Hit at(int i) const
    {
        const auto k = static_cast<std::size_t>(i);
        Hit h{t[k], surface[k], part[k], face[k], inverted[k] != 0};
        h.instance = instance[k] & Hit::kNoInstance;
        return h;
    }
    void set(int i, const Hit& h)
    {
        const auto k = static_cast<std::size_t>(i);
        t[k] = h.t;
        surface[k] = h.surface;
        part[k] = h.part;
        face[k] = h.face;
        instance[k] = h.instance;
        inverted[k] = h.inverted ? 1 : 0;
    }
};

/// Points and normals of a tile's hits as arrays.
struct alignas(64) ShadingPoints {
    alignas(64) std::array<double, kTileRays> x, y, z, nx, ny, nz;

    glm::dvec3 point(std::size_t k) const { return {x[k], y[k], z[k]}; }
    glm::dvec3 normal(std::size_t k) const { return {nx[k], ny[k], nz[k]}; }
    void set_normal(std::size_t k, const glm::dvec3& n)
    {
        nx[k] = n.x;
        ny[k] = n.y;
        nz[k] = n.z;
    }
    void set(std::size_t k, const glm::dvec3& p, const glm::dvec3& n)
    {
        x[k] = p.x;
        y[k] = p.y;
        z[k] = p.z;
        set_normal(k, n);
    }
};

/// What a shadow ray met.
enum class Shadow : std::uint8_t { Clear, Blocked, Filtered };  ///< Filtered: crosses only transparent surfaces

/// What the shadow rays of a tile cross where nothing opaque stops them.
struct CrossingTile {
    static constexpr std::uint8_t kMost = 16, kTooMany = 255;
    std::array<Shadow, kTileRays> ending;
    std::array<std::uint8_t, kTileRays> count;           ///< of hits, nearest first; kTooMany: ask ray by ray
    std::array<std::array<Hit, kMost>, kTileRays> hits;  ///< only where `ending` is Filtered
};

}  // namespace csg
