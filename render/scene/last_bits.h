#pragma once

#include "csg/base/roundings.h"
#include "render/scene/base/povray.h"

/// Sums and quotients that 3.7 and 3.8 round otherwise. The last bit decides on which side of an edge a hit lies, and
/// where the steps through a julia fractal fall.
namespace scene {

inline csg::Roundings roundings_of(PovRay povray)
{
    return povray == PovRay::V38 ? csg::Roundings::V38 : csg::Roundings::V37;
}

/// A vector at length 1, as that program has it.
inline glm::dvec3 unit(const glm::dvec3& v, PovRay povray) { return csg::unit(v, roundings_of(povray)); }

/// About x, then y, then z, degrees: 3.8's is what three rotations come to (spec 7d, 6). It differs where none is 0.
inline csg::Transform rotation(const glm::dvec3& angles, PovRay povray)
{
    using csg::Transform;
    const bool all = angles.x != 0.0 && angles.y != 0.0 && angles.z != 0.0;
    if (povray == PovRay::V37 || !all) return Transform::rotate_degrees(angles);
    return Transform::rotate_degrees({0, 0, angles.z}) *
           (Transform::rotate_degrees({0, angles.y, 0}) * Transform::rotate_degrees({angles.x, 0, 0}));
}

}  // namespace scene
