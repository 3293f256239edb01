#pragma once

#include "render/app/options/settings.h"

#include <semaphore.h>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

namespace app {

inline constexpr int kSuccess = 0, kError = 1, kCancelled = 2;  // POV-Ray's exit codes

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

/// Everything from the scene file to the picture file, frame by frame. Returns the exit status.
/// \param cancel when requested the trace stops and nothing is written
/// \param remains gets what the last frame was made from
int render_command(const Settings& settings, Cancellation& cancel, Remains& remains);

/// --json of a run that options ended before it began. Does nothing if --json was not among those read till then.
void journal_option_error(const Settings& settings, const std::string& text);

}  // namespace app
