#pragma once

#include "csg/freeform/shared/intersection_list.h"
#include "csg/base/hit.h"

#include <array>
#include <concepts>
#include <span>

namespace csg {

/// A shape that answers many rays sooner together than one by one, the optional hook of csg/freeform/README.md:
///   intersects_many()            whether this one does; some do for some of their parameters
///   intersect_many(rays, out)    intersect() of each ray: out[k] begun with the range of rays[k], and told the same to
///   the last bit
template <class T>
concept IntersectsMany = requires(const T& shape, std::span<const Ray> rays, IntersectionList* out)
{
    {
        shape.intersects_many()
        } -> std::same_as<bool>;
    shape.intersect_many(rays, out);
};

/// A shape whose crossings are a matter of the last bits of a ray: it takes points into its space itself, and rays that
/// come through a transformation otherwise than those that do not.
template <class T>
concept OfLastBits = requires(const T& shape, const Transform& frame, const Ray& ray, IntersectionList& out)
{
    shape.into(frame, ray.origin);
    shape.intersect(ray, out, true);
};

/// Rays of a tile that one solid is asked for together, and what it tells of each.
struct RayBatch {
    std::array<Ray, kTileRays> rays;
    std::array<IntersectionList, kTileRays> records;
    std::array<std::uint8_t, kTileRays> place;  ///< of the ray in its tile
    std::size_t count = 0;

    void add(const Ray& ray, std::size_t at, double from, double to, bool first_only)
    {
        rays[count] = ray;
        records[count].begin(from, to, first_only);
        place[count++] = static_cast<std::uint8_t>(at);
    }
    std::span<Ray> asked() { return {rays.data(), count}; }
};

}  // namespace csg
