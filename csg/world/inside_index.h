#pragma once

#include "csg/bvh/bvh.h"
#include "csg/world/world.h"

#include <vector>

namespace csg {

/// Tells whether a point lies inside any item of a world. Worth building for callers that ask often: a hierarchy finds
/// the items near the point.
class InsideIndex {
public:
    /// \param world outlives this
    explicit InsideIndex(const WorldData& world);

    bool holds(const glm::dvec3& point) const;

    /// The same of up to 64 points; bit i: the one at <x[i], y[i], z[i]>. Aligned, with room for whole vectors.
    std::uint64_t holds(const double* x, const double* y, const double* z, std::size_t count) const;

private:
    struct Placed {
        std::uint32_t item;
        Aabb box;
    };

    template <class Asked>
    std::uint64_t find(const Asked& asked, std::uint64_t left) const;

    const WorldData& world_;
    /// Items that have no finite box, or hold what lies outside of it; all, if they are few.
    std::vector<Placed> apart_;
    Bvh boxes_;
};

}  // namespace csg
