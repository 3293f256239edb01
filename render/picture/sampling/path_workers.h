#pragma once

#include "render/picture/kernel_module.h"
#include "render/picture/sampling/find_sources.h"

#include <tbb/enumerable_thread_specific.h>

#include <memory>
#include <vector>

namespace trace {

/// A path tracer and a buffer of what it finds for each thread that asks.
class PathWorkers {
public:
    struct Worker {
        struct Free {
            const KernelTable* kernel;
            void operator()(PathTracer* done) const { kernel->free_paths(done); }
        };
        std::unique_ptr<PathTracer, Free> tracer;
        std::vector<PathSample> samples;
        std::vector<PathFound> found;
    };

    /// All must outlive it.
    PathWorkers(const KernelTable& kernel, const plan::CompiledScene& scene, const RenderOptions& options)
        : kernel_(kernel), sources_(scene.options.paths ? path::find_sources(scene) : path::Sources()),
          workers_([&kernel, &scene, &options, this] {
              return Worker{{kernel.make_paths(scene, sources_, options.cancel), {&kernel}}, {}, {}};
          })
    {}

    Worker& local() { return workers_.local(); }
    RayCounts counts() const
    {
        RayCounts all;
        for (const Worker& worker : workers_) all += kernel_.path_counts(*worker.tracer);
        return all;
    }

private:
    const KernelTable& kernel_;
    const path::Sources sources_;
    tbb::enumerable_thread_specific<Worker> workers_;
};

}  // namespace trace
