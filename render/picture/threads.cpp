#include "render/picture/threads.h"

#include "render/plan/rendering_stack.h"

#include <algorithm>
#include <atomic>
#include <sched.h>
#include <thread>

namespace trace {

int threads_of(int wanted)
{
    if (wanted > 0) return wanted;
    cpu_set_t may_run;
    CPU_ZERO(&may_run);
    const int bound = sched_getaffinity(0, sizeof may_run, &may_run) == 0 ? CPU_COUNT(&may_run) : 0;
    return bound > 0 ? bound : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

struct Threads::Loop {
    std::atomic<std::size_t> next;
    std::size_t last;
    const std::function<void(std::size_t, int)>& f;
    std::exception_ptr failed;  // guarded
};

Threads::~Threads()
{
    if (!others_) return;
    {
        const std::lock_guard lock(mutex_);
        over_ = true;
    }
    asked_.notify_all();
    for (const Begun& other : *others_) pthread_join(other.thread, nullptr);
}

void Threads::begin()
{
    others_.emplace();
    others_->reserve(static_cast<std::size_t>(count_ - 1));  // each thread knows its entry by address
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, plan::rendering_stack());
    for (int number = 1; number < count_; ++number) {
        Begun& other = others_->emplace_back(Begun{this, number, {}});
        const auto body = [](void* begun) -> void* {
            const auto* const self = static_cast<const Begun*>(begun);
            self->of->wait_for_loops(self->number);
            return nullptr;
        };
        if (pthread_create(&other.thread, &attributes, body, &other) == 0) continue;
        others_->pop_back();
        break;
    }
    pthread_attr_destroy(&attributes);
}

void Threads::wait_for_loops(int number)
{
    std::uint64_t seen = 0;
    std::unique_lock lock(mutex_);
    for (;;) {
        asked_.wait(lock, [&] { return over_ || loops_ != seen; });
        if (over_) return;
        seen = loops_;
        Loop& loop = *loop_;
        lock.unlock();
        run(loop, number);
        lock.lock();
        if (--busy_ == 0) done_.notify_one();
    }
}

void Threads::run(Loop& loop, int number)
{
    try {
        for (std::size_t i = loop.next++; i < loop.last; i = loop.next++) loop.f(i, number);
    } catch (...) {
        loop.next = loop.last;
        const std::lock_guard lock(mutex_);
        if (!loop.failed) loop.failed = std::current_exception();
    }
}

void Threads::each(std::size_t first, std::size_t last, const std::function<void(std::size_t, int)>& f)
{
    if (count_ == 1 || last <= first + 1) {
        for (std::size_t i = first; i < last; ++i) f(i, 0);
        return;
    }
    if (!others_) begin();
    Loop loop{first, last, f, nullptr};
    {
        const std::lock_guard lock(mutex_);
        loop_ = &loop;
        busy_ = others_->size();
        ++loops_;
    }
    asked_.notify_all();
    run(loop, 0);
    std::unique_lock lock(mutex_);
    done_.wait(lock, [&] { return busy_ == 0; });
    if (loop.failed) std::rethrow_exception(loop.failed);
}

}  // namespace trace
