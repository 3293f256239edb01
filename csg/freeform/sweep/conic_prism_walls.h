#pragma once

#include "csg/freeform/sweep/conic_prism.h"

/// What a ray is told once its crossings with the walls are known. Compiled once per instruction set.
namespace csg {

template <class Walls>
inline void ConicPrism::tell(const Course& course, const Walls& walls, bool inside, IntersectionList& out) const
{
    static_assert(kLow == 0 && kHigh == 1, "slab() counts its faces so");
    const double shift = course.shift;
    const auto& within = course.within;
    const std::uint32_t first = end_face(within.entry_face), last = end_face(within.exit_face);
    double in = -kInfinity;
    std::uint32_t in_face = kUndrawnFace;
    const auto piece = [&](double until, std::uint32_t face) {
        if (until < within.entry || in > within.exit || !(in <= until)) return true;
        const bool entered = in<within.entry, left = until> within.exit;
        return out.enter(shift + (entered ? within.entry : in), entered ? first : in_face) &&
               out.leave(shift + (left ? within.exit : until), left ? last : face);
    };
    for (const auto& wall : walls) {
        if (inside && !piece(wall.t, wall.face)) return;
        in = wall.t;
        in_face = wall.face;
        inside = !inside;
    }
    if (inside) piece(kInfinity, kUndrawnFace);
}

}  // namespace csg
