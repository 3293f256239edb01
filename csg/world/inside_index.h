#pragma once

#include "csg/bvh/bvh.h"
#include "csg/world/world.h"

#include <vector>

namespace csg {

/// Whether a point lies inside of anything of a world, asked so often that the items near it are found by a hierarchy.
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
