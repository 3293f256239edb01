#pragma once

#include "csg/tree/program.h"
#include "csg/base/hit.h"
#include "render/trace/media/media_scratch.h"
#include "render/trace/radiosity/gather_scratch.h"
#include "render/trace/shade/shade_scratch.h"
#include "render/trace/subsurface/subsurface_scratch.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace trace {

/// Rays by kind, counted per tile without locks and added up at the end.
struct RayCounts {
    std::uint64_t camera = 0, shadow = 0, reflected = 0, refracted = 0, supersamples = 0;
    std::uint64_t gathered = 0, samples = 0;  ///< rays of radiosity, and their samples
    std::uint64_t far = 0;                    ///< hits so far off that POV-Ray does not draw them (csg/items/reach.h)
    RayCounts& operator+=(const RayCounts& other)
    {
        camera += other.camera;
        shadow += other.shadow;
        reflected += other.reflected;
        refracted += other.refracted;
        supersamples += other.supersamples;
        gathered += other.gathered;
        samples += other.samples;
        far += other.far;
        return *this;
    }
};

/// What one thread needs while it traces and shades; reused for every tile.
struct Scratch {
    csg::Scratch geometry;
    std::vector<csg::Hit> crossings;  ///< shadow_crossings of the ray at hand
    RayCounts counts;
    std::uint32_t grain_state = 0;  ///< of the stream behind Options::grain_stream
    ShadeScratch shade;
    std::unique_ptr<radiosity::GatherScratch> gather;  ///< made for scenes with radiosity

    /// Of rays that are gathered while a tile is being shaded, whose own scratch has to stay as it is. As deep as such
    /// rays gather in turn.
    Scratch& nested()
    {
        if (!nested_) nested_ = std::make_unique<Scratch>();
        nested_->geometry.cancel = geometry.cancel;
        return *nested_;
    }
    /// Of media, for the scenes that have some.
    MediaScratch& media()
    {
        if (!media_) media_ = std::make_unique_for_overwrite<MediaScratch>();  // not zeroed: it is large
        return *media_;
    }
    /// Of light below surfaces, likewise.
    SubsurfaceScratch& subsurface()
    {
        if (!subsurface_) subsurface_ = std::make_unique<SubsurfaceScratch>();
        return *subsurface_;
    }
    RayCounts all_counts() const
    {
        RayCounts sum = counts;
        if (nested_) sum += nested_->all_counts();
        return sum;
    }

private:
    std::unique_ptr<Scratch> nested_;
    std::unique_ptr<MediaScratch> media_;
    std::unique_ptr<SubsurfaceScratch> subsurface_;
};

}  // namespace trace
