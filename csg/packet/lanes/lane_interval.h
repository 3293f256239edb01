#pragma once

#include "csg/base/points.h"
#include "csg/solids/shared/slab.h"
#include "csg/solids/sphere.h"

/// Intervals of several rays, from one point or each from its own: what csg/solids has for a ray, with a ray a lane.
namespace csg::lanes {

/// What Interval is for one ray, with faces as numbers. Where `met` is false the rest means nothing.
struct Intervals {
    Double entry, exit, entry_face = Double(0.0), exit_face = Double(0.0);
    Bool met = Bool(false);
    Bool unclear = Bool(false);  ///< perhaps more than one interval: to be asked ray by ray; only a quadric says so
};

}  // namespace csg::lanes
