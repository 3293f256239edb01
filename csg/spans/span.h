#pragma once

#include "csg/base/types.h"

#include <cstdint>

namespace csg {

/// A solid of a SolidStore: its kind in the top 4 bits, its index among the solids of that kind below.
using PartId = std::uint32_t;
inline constexpr PartId kNoPart = 0xffffffffu;

/// Face of a crossing that bounds the solid but is not drawn: the ends of an `open` cylinder, a disc's plane
/// beyond its rim.
inline constexpr std::uint32_t kUndrawnFace = 0xffffffffu;

/// A place where a ray passes through a surface.
struct Crossing {
    double t = 0.0;          ///< ray parameter; may be infinite (the solid has no surface on that side)
    PartId part = kNoPart;   ///< whose surface
    std::uint32_t face = 0;  ///< which face of it: meaning depends on the kind of solid
    bool inverted = false;   ///< subtracted or inverse: the outward normal of the part is negated
    bool closed = false;     ///< whether the boundary point itself belongs to the inside (spec 5a, 2.4)

    /// Whether there is a surface to see.
    bool drawn() const { return face != kUndrawnFace && t > -kInfinity && t < kInfinity; }
};

/// A part of the ray inside a solid. Contains the parameters between its ends, and an end itself if that is closed.
struct Span {
    Crossing in, out;

    static Span everything() { return {{.t = -kInfinity}, {.t = kInfinity}}; }
    static Span from(const Crossing& in) { return {in, {.t = kInfinity}}; }
    static Span until(const Crossing& out) { return {{.t = -kInfinity}, out}; }

    bool contains(double t) const
    {
        return (in.t < t || (in.t == t && in.closed)) && (t < out.t || (t == out.t && out.closed));
    }
};

/// What a convex solid answers: the one parameter interval inside it.
struct Interval {
    double entry = -kInfinity, exit = kInfinity;
    std::uint32_t entry_face = 0, exit_face = 0;
};

}  // namespace csg
