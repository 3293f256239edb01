#include "numbers/lane_equal.h"
#include "csg/solids/solid.h"
#include "csg/packet/lanes/tile_rays.h"
#include "csg/world/world.h"
#include "csg/items/last_bits.h"
#include "csg/items/world_data.h"

#include <array>
#include <bit>

namespace csg {
namespace {

/// Of hits on one solid of this world.
void part_normals(const SolidStore& store, PartId part, const HitTile& hits, RayMask which, ShadingPoints& out)
{
    with_solid(store, part, [&](const auto& solid) {
        if constexpr (requires(glm::dvec3 * n) { solid.normals({}, {}, n); }) {
            std::array<glm::dvec3, kTileRays> points, normals;
            std::array<std::uint32_t, kTileRays> faces;
            std::size_t count = 0;
            each_ray(which, [&](std::size_t k) {
                points[count] = out.point(k);
                faces[count++] = hits.face[k];
            });
            solid.normals({points.data(), count}, {faces.data(), count}, normals.data());
            count = 0;
            each_ray(which, [&](std::size_t k) {
                const glm::dvec3& n = normals[count++];
                out.set_normal(k, hits.inverted[k] != 0 ? -n : n);
            });
            return;
        }
        each_ray(which, [&](std::size_t k) {
            const glm::dvec3 n = solid.normal(out.point(k), hits.face[k]);
            out.set_normal(k, hits.inverted[k] != 0 ? -n : n);
        });
    });
}

}  // namespace

void World::shading_points(const RayTile& rays, const HitTile& hits, std::uint64_t which, ShadingPoints& out) const
{
    using lanes::Double;
    each_vector(which, [&](int i) {
        const auto get = [i](const RayLanes& lanes) { return Double::load_aligned(lanes.data() + i); };
        const Double t = get(hits.t);
        (get(rays.ox) + t * get(rays.dx)).store_aligned(out.x.data() + i);
        (get(rays.oy) + t * get(rays.dy)).store_aligned(out.y.data() + i);
        (get(rays.oz) + t * get(rays.dz)).store_aligned(out.z.data() + i);
    });
    const RayMask copies = which & ~lanes::equal(hits.instance, Hit::kNoInstance);
    each_ray(copies, [&](std::size_t k) {
        out.set_normal(k, details(rays.ray(static_cast<int>(k)), hits.at(static_cast<int>(k)), false).normal);
    });
    const auto tell = [&](std::size_t k) {
        const int place = static_cast<int>(k);
        const HitDetails told = details(rays.ray(place), hits.at(place), false);
        out.set(k, told.point, told.normal);
    };
    for (RayMask left = which & ~copies; left != 0;) {
        const PartId part = hits.part[static_cast<std::size_t>(std::countr_zero(left))];
        const RayMask group = left & lanes::equal(hits.part, part);
        if (has_last_bits(data_->told, part)) each_ray(group, tell);
        else part_normals(data_->store, part, hits, group, out);
        left &= ~group;
    }
}

}  // namespace csg
