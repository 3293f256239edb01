#include "python/binding/job.h"

#include "render/app/run/stacks.h"
#include "render/solid/measure/workers.h"

#include <pybind11/pybind11.h>

#include <chrono>
#include <utility>

namespace python {
namespace {

namespace py = pybind11;

constexpr auto kLookAgain = std::chrono::milliseconds(40);  // for signals
constexpr auto kPatience = std::chrono::milliseconds(300);  // with work that was cancelled

}  // namespace

void wait_for(const std::shared_ptr<Job>& job, std::function<void()> work)
{
    app::start_on_deep_stack([job, work = std::move(work)]() mutable {
        solid::deepen_workers();
        std::exception_ptr failed;
        try {
            work();
        } catch (...) {
            failed = std::current_exception();
        }
        work = {};  // what it owned is gone before anybody hears of it
        const std::lock_guard lock(job->mutex_);
        job->failed_ = failed;
        job->done_ = true;
        job->changed_.notify_all();
    });
    try {
        for (;;) {
            std::function<void()> look;
            {
                const py::gil_scoped_release free;
                std::unique_lock lock(job->mutex_);
                job->changed_.wait_for(lock, kLookAgain, [&] { return job->done_ || job->look_; });
                if (job->done_) break;
                look = std::exchange(job->look_, {});
            }
            if (look) look();
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        }
    } catch (...) {
        job->cancel = true;
        const py::gil_scoped_release free;
        std::unique_lock lock(job->mutex_);
        job->changed_.wait_for(lock, kPatience, [&] { return job->done_; });
        throw;
    }
    if (job->failed_) std::rethrow_exception(job->failed_);
}

}  // namespace python
