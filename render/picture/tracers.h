#pragma once

#include "render/picture/kernel_module.h"

#include <tbb/enumerable_thread_specific.h>

#include <memory>
#include <vector>

namespace trace {

/// A tracer and a buffer of colours for each thread that asks.
class Tracers {
public:
    struct Worker {
        struct Free {
            const KernelTable* kernel;
            void operator()(BlockTracer* done) const { kernel->free(done); }
        };
        std::unique_ptr<BlockTracer, Free> tracer;
        std::vector<scene::Color> colors;
    };

    /// All must outlive it.
    Tracers(const KernelTable& kernel, const plan::CompiledScene& scene, const RenderOptions& options)
        : kernel_(kernel), workers_([&kernel, &scene, &options] {
              return Worker{{kernel.make(scene, options.indirect, options.cancel), {&kernel}}, {}};
          })
    {}

    Worker& local() { return workers_.local(); }
    RayCounts counts() const
    {
        RayCounts all;
        for (const Worker& worker : workers_) all += kernel_.counts(*worker.tracer);
        return all;
    }

private:
    const KernelTable& kernel_;
    tbb::enumerable_thread_specific<Worker> workers_;
};

}  // namespace trace
