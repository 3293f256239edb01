#pragma once

#include "render/picture/render.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <functional>
#include <memory>
#include <variant>

namespace trace {

/// wanted: 0 for all cores.
inline int threads_of(int wanted) { return wanted > 0 ? wanted : tbb::info::default_concurrency(); }

/// The threads of one piece of work, as many as the options ask for and no more whatever else runs; each has a tracer
/// of its own, made when the thread first asks. \tparam Kept  what else a thread keeps: buffers
template <class Tracer, class Kept = std::monostate>
class Workers {
public:
    struct Worker {
        std::unique_ptr<Tracer, void (*)(Tracer*)> tracer;
        Kept kept;
    };

    /// free: of the kernel whose tracers `make` makes. The options and what `make` looks at must outlive it.
    Workers(const RenderOptions& options, std::function<Tracer*()> make, void (*free)(Tracer*))
        : cancel_(options.cancel), threads_(threads_of(options.threads)),
          limit_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads_)), arena_(threads_),
          workers_([make = std::move(make), free] {
              return Worker{{make(), free}, {}};
          })
    {}

    int threads() const { return threads_; }

    /// work(i, worker) for [first, last), until one is false or all is cancelled. False: so it ended.
    template <class Work>
    bool each(std::size_t first, std::size_t last, Work work)
    {
        std::atomic<bool> stopped = false;
        arena_.execute([&] {
            tbb::parallel_for(first, last, [&](std::size_t i) {
                if (stopped || (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) ||
                    !work(i, workers_.local()))
                    stopped = true;
            });
        });
        return !stopped;
    }

    /// counted: by the kernel.
    RayCounts counts(RayCounts (*counted)(const Tracer&)) const
    {
        RayCounts all;
        for (const Worker& worker : workers_) all += counted(*worker.tracer);
        return all;
    }

private:
    const std::atomic<bool>* cancel_;
    const int threads_;
    tbb::global_control limit_;
    tbb::task_arena arena_;
    tbb::enumerable_thread_specific<Worker> workers_;
};

}  // namespace trace
