#pragma once

#include "render/texture/points/points.h"
#include "render/kernel/extinction/media_mix.h"
#include "render/kernel/tile/hit_mask.h"
#include "render/kernel/context/context.h"

namespace trace {

/// Light of media photons that turns into rays at points of the air (spec 6, 3.10): the sum over the photons near a
/// point of phase(cosine) * flux, over the volume that they were gathered in, 4/3 pi r^3. The cosine is between the
/// ray's direction and the photon's way back to where it came from. What the point scatters is multiplied outside.
/// Asked for all samples of media that scatter, lit or not, a batch of up to 64 points at a time.
/// \param directions  of the rays that the points lie on, unit
/// \param mixes       by point: the media there
/// \param light       receives the sum of the points of `which`; others' are left alone
void media_photons(const Context& context, const texture::Points& points, HitMask which,
                   const std::array<glm::dvec3, csg::kTileRays>& directions,
                   const std::array<const MediaMix*, csg::kTileRays>& mixes, TileColors& light);

/// Whether the passes before the picture have left photons in media, or on surfaces.
bool has_media_photons(const Context& context);
bool has_surface_photons(const Context& context);

}  // namespace trace
