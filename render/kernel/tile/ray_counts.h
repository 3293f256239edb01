#pragma once

#include <cstdint>

namespace trace {

/// Rays by kind, counted per tile without locks and added up at the end.
struct RayCounts {
    std::uint64_t camera = 0, shadow = 0, reflected = 0, refracted = 0, supersamples = 0;
    std::uint64_t gathered = 0, samples = 0;  ///< rays of radiosity, and their samples
    std::uint64_t far = 0;  ///< hits so far off that POV-Ray does not draw them (csg/items/depth_range.h)
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

}  // namespace trace
