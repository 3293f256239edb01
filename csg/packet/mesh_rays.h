#pragma once

#include "csg/mesh/mesh_query.h"
#include "csg/packet/packet_walk.h"

/// Many rays against one mesh.
namespace csg {

/// Rays of a tile that come to a mesh, in the mesh's space and close together: ray i of these is ray place[i] of the
/// tile. What PacketWalk asks of rays.
struct MeshRays {
    alignas(64) RayLanes dx, dy, dz, inverse_x, inverse_y, inverse_z;
    alignas(64) RayLanes t_min, limit;  ///< where the ray is taken from `start`
    std::array<glm::dvec3, kTileRays> start;
    std::array<double, kTileRays> moved;  ///< how far along the ray `start` lies (move_near)
    std::array<std::uint8_t, kTileRays> place;
    int count = 0;

    glm::dvec3 origin_of(std::size_t i) const { return start[i]; }
    Ray ray(std::size_t i) const { return {start[i], {dx[i], dy[i], dz[i]}}; }
    RayMask all() const { return count < kTileRays ? (RayMask{1} << count) - 1 : ~RayMask{0}; }

    void add(const Aabb& bounds, Ray ray, std::size_t from, double first, double last)
    {
        const auto i = static_cast<std::size_t>(count++);
        moved[i] = move_near(bounds, ray);
        start[i] = ray.origin;
        place[i] = static_cast<std::uint8_t>(from);
        t_min[i] = first - moved[i];
        limit[i] = last - moved[i];
        const auto set = [&](int axis, RayLanes& direction, RayLanes& inverse) {
            direction[i] = ray.direction[axis];
            inverse[i] = slab_reciprocal(direction[i]);
        };
        set(0, dx, inverse_x);
        set(1, dy, inverse_y);
        set(2, dz, inverse_z);
    }
};

/// The nearest faces that the rays meet, or any for each. What PacketWalk asks of a leaf.
class MeshFaces {
public:
    /// \param tile that the rays were taken from
    /// \param any face of a ray will do
    template <class Rays>
    MeshFaces(const MeshShape& shape, MeshRays& rays, const Rays& tile, bool any)
        : shape_(shape), rays_(rays), any_(any)
    {
        for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); ++i) {
            first_[i] = tile.t_min[rays.place[i]];
            last_[i] = tile.limit[rays.place[i]];
            t[i] = kInfinity;
        }
    }

    void open(ChildWord leaf, RayMask mask)
    {
        const TriangleBlock& block = shape_.block(leaf.index());
        each_ray(mask, [&](std::size_t i) {
            alignas(32) double here[4];
            for (std::uint32_t met = meet_triangles(block, rays_.ray(i), here); met != 0; met &= met - 1) {
                const auto k = static_cast<std::uint32_t>(std::countr_zero(met));
                offer(i, here[k] + rays_.moved[i], leaf.index() * 4 + k);
            }
        });
    }

    /// What will be looked at soon: leaves of a large mesh lie far from each other in memory.
    void fetch(ChildWord child) const
    {
        const void* const at = child.is_leaf() ? static_cast<const void*>(&shape_.block(child.index()))
                                               : &shape_.bvh().nodes[child.index()];
        for (int line = 0; line < 3; ++line) __builtin_prefetch(static_cast<const char*>(at) + line * 64);
    }

    RayLanes t;  ///< infinite: the ray meets none
    std::array<std::uint32_t, kTileRays> face;

private:
    void offer(std::size_t i, double here, std::uint32_t which)
    {
        if (!(here >= first_[i] && here <= last_[i])) return;
        if (!face_comes_first(here, which, t[i], face[i])) return;
        t[i] = last_[i] = here;
        face[i] = which;
        rays_.limit[i] = any_ ? -kInfinity : here - rays_.moved[i];
    }

    const MeshShape& shape_;
    MeshRays& rays_;
    bool any_;
    RayLanes first_, last_;  ///< along the rays themselves
};

}  // namespace csg
