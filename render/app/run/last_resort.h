#pragma once

#include "render/app/run/cancellation.h"

#include <condition_variable>
#include <functional>
#include <mutex>

#include <pthread.h>

namespace app {

/// Ends a run that was asked to end and does not, because it is in the midst of something long that does not look: a
/// thread that sleeps until a signal comes, gives the run some time to end by itself, and then ends the process with
/// kCancelled. While one lives, the run is expected to look by itself (Cancellation::heeded).
class LastResort {
public:
    /// \param save what can be saved of the run as it stands; from the other thread, while the run goes on
    LastResort(Cancellation& cancel, std::function<void()> save);
    LastResort(const LastResort&) = delete;
    LastResort& operator=(const LastResort&) = delete;
    /// Returns only if the process is not being ended.
    ~LastResort();

    /// What can be saved from now on.
    void replace(std::function<void()> save);
    /// The run has looked, and ends by itself. Returns only if the process is not being ended.
    void noticed();

private:
    static void* start(void* self);
    void watch();
    Cancellation& cancel_;
    std::mutex guard_;  ///< held by who ends the run
    std::condition_variable looked_;
    std::function<void()> save_;
    bool noticed_ = false;
    pthread_t thread_;
};

}  // namespace app
