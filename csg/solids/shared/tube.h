#pragma once

#include "csg/base/roundings.h"
#include "csg/spans/span.h"

/// What cylinders, cones and lemons have in common.
namespace csg {

/// Faces of cylinders, cones and lemons.
enum TubeFace : std::uint32_t { kSide, kLowEnd, kHighEnd };

/// Of what slab() has found between the ends of a cylinder or cone. The side is face 0, as Interval has it.
template <class I>
inline void name_ends(bool open, I& ends)
{
    using Face = decltype(ends.entry_face);
    ends.entry_face = open ? Face(kUndrawnFace) : ends.entry_face + Face(kLowEnd);
    ends.exit_face = open ? Face(kUndrawnFace) : ends.exit_face + Face(kLowEnd);
}

/// Frame of cylinders, cones, lemons and discs: scale (across, across, along), local z turned to `axis` about the
/// shortest way and moved to `base` (spec 5a, 3.3). `axis` has unit length.
Transform axis_frame(const glm::dvec3& base, const glm::dvec3& axis, double across, double along,
                     Roundings by = Roundings::Own);

}  // namespace csg
