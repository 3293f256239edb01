#pragma once

#include "render/picture/kernel_module.h"

#include <memory>
#include <vector>

namespace study {

/// Frees a tracer through the module that made it.
struct FreeTracer {
    const trace::KernelTable* kernel = nullptr;
    void operator()(trace::BlockTracer* tracer) const { kernel->free(tracer); }
};
using OwnTracer = std::unique_ptr<trace::BlockTracer, FreeTracer>;

inline OwnTracer make_tracer(const trace::KernelTable& kernel, const plan::CompiledScene& scene,
                             const trace::IndirectLight* indirect, const std::atomic<bool>* cancel)
{
    return {kernel.make(scene, indirect, cancel), {&kernel}};
}

/// Centres of the pixels of some tiles of 8x8, scattered evenly over the picture; tile after tile. At most so many
/// pixels, but one tile.
std::vector<trace::SamplePosition> scattered_tiles(const plan::Options& options, std::size_t pixels);

/// All rays that were traced so far.
inline double ray_count(const trace::RayCounts& counts)
{
    return static_cast<double>(counts.camera + counts.shadow + counts.reflected + counts.refracted + counts.gathered);
}

}  // namespace study
