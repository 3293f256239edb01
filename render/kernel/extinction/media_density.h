#pragma once

#include "render/plan/compiled_scene.h"
#include "render/texture/evaluate_points.h"
#include "render/kernel/tile/row_page.h"

namespace trace {

/// Densities of media at points of the air.
class MediaDensity {
public:
    MediaDensity() { around_.fill(&kNoSurface); }

    /// Colours of a medium's densities at points, multiplied; `points` is padded. Those of `which` are found, others
    /// are anything.
    const TileColors& at(const plan::CompiledScene& scene, const plan::Media& media, const texture::Points& points,
                         HitMask which);

private:
    void multiply_all(HitMask which, bool first);
    void multiply_some(HitMask which, bool first);

    /// Nothing that a density could look at: it has a place and no surface.
    static const texture::Surroundings kNoSurface;

    texture::Around around_;
    texture::Points some_;
    texture::ColorPoints colors_;
    TileColors density_;
};

}  // namespace trace
