#pragma once

#include "csg/tree/program.h"
#include "csg/base/hit.h"
#include "render/kernel/context/kept.h"
#include "render/kernel/context/shade_scratch.h"
#include "render/kernel/tile/ray_counts.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace trace {

struct MediaScratch;
struct ShadowMedia;
struct SubsurfaceScratch;
namespace radiosity {
struct GatherScratch;
}

/// What one thread needs while it traces and shades; reused for every tile.
struct Scratch {
    csg::Scratch geometry;
    std::vector<csg::Hit> crossings;  ///< shadow_crossings of the ray at hand
    RayCounts counts;
    std::uint32_t grain_state = 0;  ///< of the stream behind Options::grain_stream
    ShadeScratch shade;
    Kept<MediaScratch, false> media;  ///< for the scenes that have some
    Kept<ShadowMedia> shadow_media;
    Kept<radiosity::GatherScratch> gather;
    Kept<SubsurfaceScratch> subsurface;

    /// Of rays that are gathered while a tile is being shaded, whose own scratch has to stay as it is. As deep as such
    /// rays gather in turn.
    Scratch& nested()
    {
        if (!nested_) nested_ = std::make_unique<Scratch>();
        nested_->geometry.cancel = geometry.cancel;
        return *nested_;
    }
    RayCounts all_counts() const
    {
        RayCounts sum = counts;
        if (nested_) sum += nested_->all_counts();
        return sum;
    }

private:
    std::unique_ptr<Scratch> nested_;
};

}  // namespace trace
