#pragma once

#include "csg/tree/program.h"

namespace csg {

/// Rays that tell whether something is held: they cross 512 places at least, so what is 2 % of the surface goes unseen
/// once in 30,000 times.
inline constexpr std::uint32_t kHeldRays = 256;

/// Whether all that is drawn lies within a bound, but for what sticks out by less than 1 % of its size: that was meant
/// to be held. Told from the corners of the box where the bound is convex, else from where a fixed set of rays crosses
/// what is drawn, so that a spike that none of them meets passes for held. What has no finite box is not held.
/// \param rays  how many of the set
bool held_by(const Program& drawn, const Program& bound, const SolidStore& store, std::uint32_t rays = kHeldRays);

/// The same of a box.
bool held_by(const Aabb& box, const Program& bound, const SolidStore& store);

}  // namespace csg
