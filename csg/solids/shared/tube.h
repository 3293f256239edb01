#pragma once

#include "csg/base/points.h"
#include "csg/base/roundings.h"
#include "csg/solids/shared/common.h"
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

/// Slack of POV-Ray's own inside test, in units of the canonical frame: closed ones leave their surface out, open ones
/// hold it (spec 5a, 2.4).
constexpr double skin(bool open) { return open ? 1e-10 : -1e-10; }

/// Whether a point of the canonical frame lies in a tube between z = low and z = 1 that is larger by `skin`, where its
/// radius is `rim`, that included.
template <class P>
inline lanes::TruthOf<P> within_tube(const P& l, const lanes::NumberOf<P>& rim, double low, double skin)
{
    return (rim > 0.0) & (l.x * l.x + l.y * l.y < rim * rim) & (l.z > low - skin) & (l.z < 1.0 + skin);
}

/// Outward at point p. `rise`: of the side's normal in the canonical frame, a part of z.
inline glm::dvec3 tube_normal(const Transform& frame, const glm::dvec3& p, std::uint32_t face, double rise)
{
    if (face == kLowEnd || face == kHighEnd) return unit_or_x(frame.normal({0.0, 0.0, face == kLowEnd ? -1.0 : 1.0}));
    const glm::dvec3 local = frame.inverse_point(p);
    return unit_or_x(frame.normal({local.x, local.y, rise * local.z}));
}

/// Frame of cylinders, cones, lemons and discs: scale (across, across, along), local z turned to `axis` about the
/// shortest way and moved to `base` (spec 5a, 3.3). `axis` has unit length.
Transform axis_frame(const glm::dvec3& base, const glm::dvec3& axis, double across, double along,
                     Roundings by = Roundings::Own);

}  // namespace csg
