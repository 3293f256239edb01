#pragma once

#include "render/picture/render.h"
#include "render/picture/threads.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace trace {

/// The threads of one piece of work, as many as the options ask for; each has a tracer of its own, made when the thread
/// first asks. \tparam Kept  what else a thread keeps: buffers
template <class Tracer, class Kept = std::monostate>
class Workers {
public:
    struct Worker {
        std::unique_ptr<Tracer, void (*)(Tracer*)> tracer;
        Kept kept;
    };

    /// free: of the kernel whose tracers `make` makes. The options and what `make` looks at must outlive it.
    Workers(const RenderOptions& options, std::function<Tracer*()> make, void (*free)(Tracer*))
        : cancel_(options.cancel), make_(std::move(make)), free_(free), threads_(threads_of(options.threads)),
          workers_(static_cast<std::size_t>(threads_.count()))
    {}

    int threads() const { return threads_.count(); }

    /// work(i, worker) for [first, last), until one is false or all is cancelled. False: so it ended.
    template <class Work>
    bool each(std::size_t first, std::size_t last, Work work)
    {
        std::atomic<bool> stopped = false;
        threads_.each(first, last, [&](std::size_t i, int thread) {
            std::optional<Worker>& mine = workers_[static_cast<std::size_t>(thread)];
            if (!mine) mine.emplace(Worker{{make_(), free_}, {}});
            if (stopped || (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed)) || !work(i, *mine))
                stopped = true;
        });
        return !stopped;
    }

    /// counted: by the kernel.
    RayCounts counts(RayCounts (*counted)(const Tracer&)) const
    {
        RayCounts all;
        for (const std::optional<Worker>& worker : workers_)
            if (worker) all += counted(*worker->tracer);
        return all;
    }

private:
    const std::atomic<bool>* cancel_;
    const std::function<Tracer*()> make_;
    void (*free_)(Tracer*);
    Threads threads_;
    std::vector<std::optional<Worker>> workers_;
};

}  // namespace trace
