#pragma once

#include "csg/base/hit.h"
#include "csg/base/types.h"
#include "render/plan/surface.h"

#include <vector>

/// What shading can know of a surface before any ray meets it: read by all threads (traits/find_traits.h).
namespace plan {

/// Most layers of a texture that are looked up for a whole tile ahead of shading.
inline constexpr std::uint32_t kPrefetchedLayers = 64;

/// The only layer of a texture, if it shades alike for a whole tile.
struct SingleLayer {
    std::uint32_t index = kNone;
    bool goes_on = false;  ///< it may mirror light or let it through
    bool clear = false;    ///< nothing shows of it, unless what is inside bends the light
    bool dull = false;     ///< it may let light through, and shows that of lamps by its opacity alone
};

/// A texture of layers with patterns or bent normals, or a texture map.
struct PatternedLayers {
    std::uint32_t texture = kNone;
    bool alone = false;  ///< no layer has more than colour, diffuse light and highlights
    bool map = false;
};

struct SurfaceTraits {
    bool needs_uv = true;        ///< something of its textures looks at surface coordinates
    bool looked_around = false;  ///< something asks for more than the point (texture::Surroundings)
    bool batched = true;         ///< its places are found for a whole tile: nothing asks for more than point and normal
    bool steady_filter = false;  ///< light that passes is filtered alike everywhere and in every direction
    bool filters_alone = false;  ///< steady_filter, and nothing inside dims light on its way
    bool filters_together = false;  ///< what it filters by patterns or focuses (`caustics`) is found for a whole tile
    SingleLayer outer, inner;       ///< as seen from outside, and where the raw normal faces along the ray
    PatternedLayers outer_patterned, inner_patterned;  ///< textures whose layers a tile looks up together
    glm::vec3 filter{1};                               ///< steady_filter: by this (spec 3, 13.2)
};

/// What lies between two planes across an axis, the one on which it is farthest from some light. Shadow rays do not
/// come there from most points, which is told sooner than by boxes.
struct Slab {
    static constexpr int kNoAxis = -1;  ///< there is none
    int axis = kNoAxis;
    double lower = 0.0, upper = 0.0;
};

struct SceneTraits {
    std::vector<SurfaceTraits> surfaces;      ///< by csg::SurfaceId
    std::vector<csg::SurfaceId> not_batched;  ///< whose SurfaceTraits::batched is false
    std::vector<std::uint8_t> dimming;        ///< by interior: 1 where what is inside dims light
    bool sky_looks_around = false;            ///< a pigment of the sky asks for texture::Surroundings
    bool grouped = false;                     ///< some surface is not reached by all lights
    bool filters = false;                     ///< some surface lets a shadow ray through
    bool filters_together = false;            ///< some surface does so in a way that is found for a whole tile
    bool fades = false;                       ///< light fades inside some interior
    bool media = false;                       ///< some interior holds media that dim light
    bool fresnel = false;                     ///< some finish mirrors by Fresnel's equations
    bool interior_media = false;              ///< some interior holds media of any kind
    bool clear_surfaces = false;              ///< what is wholly clear may be left unlit (LeanStep)
    bool scalar_rows = false;                 ///< Options::scalar_light
    bool even_fog = false;                    ///< the air has fog that is the same everywhere, and nothing else
    /// Boxes of what shadow rays have to meet from the point itself: surfaces whose filter depends on where they are
    /// met, to the last bit where a pattern has edges, and solids that depend on the way (csg::Freeform::one_way).
    /// Elsewhere they may come from the light as a beam.
    std::vector<csg::Aabb> own_rays;
    /// What holds all of these, and what holds all else that does not stop light too.
    Slab own_rays_slab, clear_slab;
    bool has_open_surface = false;  ///< some solid tells crossings beside its surface (csg/freeform/freeform_solid.h)

    /// Whether it matters where a ray began that goes on behind a crossing: such solids tell a ray only so many.
    bool restarts() const { return has_open_surface && filters; }
};

}  // namespace plan
