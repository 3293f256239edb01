#pragma once

#include "render/app/run/cancellation.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

/// Whittle's Python module: Scene, Picture and what solids tell, as python/whittle wraps them.
namespace python {

/// A call from Python that works on a thread of its own while the interpreter is free.
class Job {
public:
    app::Cancellation cancellation;  ///< requested by KeyboardInterrupt
    std::atomic<bool>& cancel = cancellation.requested;

    /// From the work: something to look at. What nobody has looked at is replaced.
    void show(std::function<void()> look)
    {
        const std::lock_guard lock(mutex_);
        look_ = std::move(look);
        changed_.notify_all();
    }

private:
    friend void wait_for(const std::shared_ptr<Job>& job, std::function<void()> work);
    std::mutex mutex_;
    std::condition_variable changed_;
    std::function<void()> look_;  ///< called with the interpreter held
    bool done_ = false;
    std::exception_ptr failed_;
};

/// Runs the work without the interpreter, and returns or throws as it does. KeyboardInterrupt, or what a look throws,
/// sets Job::cancel and is thrown; work that does not end soon after is left behind, so it owns whatever it uses.
void wait_for(const std::shared_ptr<Job>& job, std::function<void()> work);

/// The same for work that has a result, which is moved from where the work left it.
template <class Result, class Work>
Result result_of(Work work)
{
    auto job = std::make_shared<Job>();
    auto result = std::make_shared<std::optional<Result>>();
    wait_for(job, [job, result, work = std::move(work)] { result->emplace(work(*job)); });
    return std::move(**result);
}

}  // namespace python
