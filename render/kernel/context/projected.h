#pragma once

#include "csg/tree/program.h"
#include "csg/world/world.h"
#include "render/light/projector.h"

#include <algorithm>

/// Where rays meet what a light is projected through (spec 3, 12).
namespace trace {

inline constexpr double kProjectedFrom = 1e-4;  ///< nearer crossings do not count
inline constexpr std::uint8_t kProjectedRays = 0xff;

/// Of its world, which is not the scene's.
inline csg::Scratch& projector_scratch()
{
    thread_local csg::Scratch scratch;
    return scratch;
}

/// How far it is along the ray; negative: nowhere.
inline double projected_depth(const light::Projector& projector, const csg::Ray& ray)
{
    const csg::Hit hit =
        projector.world().nearest(ray, kProjectedFrom, numbers::kInfinity, kProjectedRays, projector_scratch());
    return hit.found() ? hit.t : -1.0;
}

/// The same of a tile's rays, wherever they begin and end: f(ray, depth).
template <class F>
inline void projected_depths(const light::Projector& projector, csg::RayTile& rays, F&& f)
{
    const auto count = static_cast<std::size_t>(rays.count);
    std::fill_n(rays.t_min.begin(), count, kProjectedFrom);
    std::fill_n(rays.t_max.begin(), count, numbers::kInfinity);
    csg::HitTile met;
    projector.world().nearest(rays, kProjectedRays, projector_scratch(), met);
    for (std::size_t i = 0; i < count; ++i) f(i, met.surface[i] == csg::kNoSurface ? -1.0 : met.t[i]);
}

}  // namespace trace
