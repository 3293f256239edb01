#pragma once

#include "render/scene/color.h"
#include "render/texture/texture_set.h"
#include "render/trace/ray_state.h"

#include <vector>

/// The rays that go on from a tile's hits. They wait and are traced a tile at a time too, so that their hits go through
/// the lights together; the colours are put together when all are known, last hit first. The sums are those of
/// shade_layers in the same order, so the bits are the same as in recursion.
namespace trace {

struct Context;

/// Where a colour of a Wave lies; a camera ray's is its place in the tile.
using Place = std::uint32_t;
inline constexpr Place kNowhere = 0xffffffffu;

struct WaitingRay {
    RayState state;
    Place place;                     ///< of its colour
    int level;                       ///< levels in use including this ray's
    double reach;                    ///< how far light has come from the camera to where this ray starts
};

/// A hit of one layer whose colour waits for the rays behind it.
struct Branch {
    glm::vec3 own;                   ///< the surface's own light
    glm::vec3 filter, fade;          ///< of the ray that goes through
    glm::vec3 reflectivity;
    float residual, power;           ///< share of alpha that goes through; reflection_power
    bool total;
    Place place, through, mirror;    ///< kNowhere: no such ray, or a black one
    std::uint32_t air;               ///< where fog is: what the colour crosses on its way, in Wave::airs; or kNowhere
};

/// What fog needs to know of a ray.
struct Air {
    RayState state;
    double length;
};

/// What waits, per thread. Rays are a stack of batches: the last is traced first, so that few wait at any time.
struct Wave {
    std::vector<WaitingRay> rays, mirrors;   ///< `mirrors`: of the tile at hand, until it is through
    std::vector<std::uint32_t> batches;      ///< where each starts in `rays`
    std::vector<Branch> branches;            ///< behind every hit: those of the rays that go on from it
    std::vector<Air> airs;
    std::vector<scene::Color> colors;        ///< by Place

    /// Hits beyond this are shaded by recursion: a tree of mirrors may have any number.
    static constexpr std::size_t kMostBranches = 1 << 14;
    bool full() const { return branches.size() >= kMostBranches; }

    void clear(std::size_t camera_rays);

    /// Puts the tile's mirrored rays behind those that go through, as a batch of their own.
    void end_tile(std::size_t first);
};

/// Adds the hit of a tile to the wave, with the rays that go on from it. c: its pigment; own: its light;
/// reach: from the camera to the hit.
void add_branch(Context& context, const struct HitPlace& hit, const texture::Finish& finish, const scene::Color& c,
                const glm::vec3& own, Place place, double reach);

/// Whether the rays come from one point as far behind them as their reach: flat mirrors show the camera's image there, and
/// behind what does not bend rays it is the camera. Rays of one tile then form a beam from `origin`.
bool from_one_point(const WaitingRay* rays, int count, glm::dvec3& origin);

/// Every branch's colour, last first.
void collect(Context& context);

}  // namespace trace
