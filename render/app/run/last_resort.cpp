#include "render/app/run/last_resort.h"

#include <unistd.h>

#include <chrono>
#include <utility>

namespace app {

namespace {

/// A run that looks does so within milliseconds, on a busy machine some tens; half a second is what a user is promised.
constexpr std::chrono::milliseconds kGrace{250};

}  // namespace

LastResort::LastResort(Cancellation& cancel, std::function<void()> save)
    : cancel_(cancel), save_(std::move(save)), thread_([this] { watch(); })
{
    cancel_.heeded = true;
}

LastResort::~LastResort()
{
    noticed();
    cancel_.heeded = false;
    cancel_.wake();
    thread_.join();
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
