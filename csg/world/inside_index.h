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

private:
    const WorldData& world_;
    std::vector<std::uint32_t> unbounded_;  ///< items that have no finite box, or hold what lies outside of it
    Bvh boxes_;
};

}  // namespace csg
