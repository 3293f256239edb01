#include "render/app/run/last_resort.h"

#include "render/app/run/stacks.h"

#include <unistd.h>

#include <chrono>
#include <utility>

namespace app {

namespace {

/// How long a run may take to notice that it is cancelled. One that looks does so within milliseconds, on a busy
/// machine within some tens of them; users are promised an end within half a second.
constexpr std::chrono::milliseconds kGrace{250};

}  // namespace

LastResort::LastResort(Cancellation& cancel, std::function<void()> save) : cancel_(cancel), save_(std::move(save))
{
    thread_ = start_thread(start, this);
    cancel_.heeded = true;
}

LastResort::~LastResort()
{
    noticed();
    cancel_.heeded = false;
    cancel_.wake();
    pthread_join(thread_, nullptr);
}

void LastResort::replace(std::function<void()> save)
{
    const std::lock_guard lock(guard_);
    save_ = std::move(save);
}

void LastResort::noticed()
{
    const std::lock_guard lock(guard_);
    noticed_ = true;
    looked_.notify_all();
}

void* LastResort::start(void* self)
{
    static_cast<LastResort*>(self)->watch();
    return nullptr;
}

void LastResort::watch()
{
    std::unique_lock lock(guard_);
    while (!cancel_.requested && !noticed_) {
        lock.unlock();
        cancel_.wait();
        lock.lock();
    }
    if (looked_.wait_for(lock, kGrace, [this] { return noticed_; })) return;
    save_();
    _exit(kCancelled);
}

}  // namespace app
