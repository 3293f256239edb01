#pragma once

#include "render/app/run/exit_status.h"

#include <semaphore.h>

#include <atomic>
#include <memory>
#include <vector>

namespace app {

/// Between a signal handler and the run.
struct Cancellation {
    std::atomic<bool> requested{false};
    std::atomic<bool> heeded{
        false};  ///< on while the run looks at `requested` by itself; else a signal ends it at once

    Cancellation() { sem_init(&asked_, 0, 0); }
    Cancellation(const Cancellation&) = delete;
    Cancellation& operator=(const Cancellation&) = delete;
    /// For a signal handler: ends wait().
    void wake() { sem_post(&asked_); }
    void wait()
    {
        while (sem_wait(&asked_) != 0) {}
    }

private:
    sem_t asked_;
};

/// What a run need not free: millions of small things that the end of the process drops at once.
class Remains {
public:
    template <class Thing>
    void leave(Thing&& thing)
    {
        things_.push_back(std::make_shared<std::decay_t<Thing>>(std::forward<Thing>(thing)));
    }

private:
    std::vector<std::shared_ptr<const void>> things_;
};

}  // namespace app
