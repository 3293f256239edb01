#include "render/picture/threads.h"

#include "render/plan/rendering_stack.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <pthread.h>
#include <sched.h>
#include <thread>
#include <utility>
#include <vector>

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

/// A thread of the process that helps one Threads after the other. It ends with the process.
class Threads::Helper {
public:
    /// Lets a waiting or a new thread wait for the loops of `of`; false: the system refuses one.
    static bool call(Threads& of, int number)
    {
        Helper* free = take();
        if (!free) free = start();
        if (!free) return false;
        const std::lock_guard lock(free->mutex_);
        free->of_ = &of;
        free->number_ = number;
        free->called_.notify_one();
        return true;
    }

private:
    struct Waiting {
        std::mutex mutex;
        std::vector<Helper*> all;
        std::size_t begun = 0;
    };

    static Waiting& waiting()
    {
        static Waiting& of_process = *[] {  // never destroyed: threads look at it until the process ends
            pthread_atfork(nullptr, nullptr, [] { waiting().all.clear(); });  // a copy of the process has no threads
            return new Waiting;
        }();
        return of_process;
    }

    static Helper* take()
    {
        const std::lock_guard lock(waiting().mutex);
        if (waiting().all.empty()) return nullptr;
        Helper* const last = waiting().all.back();
        waiting().all.pop_back();
        return last;
    }

    static Helper* start()
    {
        auto helper = std::make_unique<Helper>();
        {
            // Room for it to wait in: where memory is short a thread that goes back could not ask for any.
            const std::lock_guard lock(waiting().mutex);
            waiting().all.reserve(++waiting().begun);
        }
        pthread_attr_t attributes;
        pthread_attr_init(&attributes);
        pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
        pthread_attr_setstacksize(&attributes, plan::rendering_stack());
        pthread_t thread{};
        const auto body = [](void* self) -> void* { static_cast<Helper*>(self)->help(); };
        const int refused = pthread_create(&thread, &attributes, body, helper.get());
        pthread_attr_destroy(&attributes);
        return refused == 0 ? helper.release() : nullptr;
    }

    [[noreturn]] void help()
    {
        for (;;) {
            std::unique_lock lock(mutex_);
            called_.wait(lock, [&] { return of_ != nullptr; });
            Threads& of = *std::exchange(of_, nullptr);
            const int number = number_;
            lock.unlock();
            of.wait_for_loops(number);
            {
                const std::lock_guard waits(waiting().mutex);
                waiting().all.push_back(this);
            }
            of.leave();
        }
    }

    std::mutex mutex_;
    std::condition_variable called_;
    Threads* of_ = nullptr;
    int number_ = 0;
};

Threads::~Threads()
{
    std::unique_lock lock(mutex_);
    over_ = true;
    asked_.notify_all();
    done_.wait(lock, [&] { return helpers_ == 0; });
}

void Threads::begin()
{
    begun_ = true;
    for (int number = 1; number < count_; ++number) {
        if (!Helper::call(*this, number)) break;
        const std::lock_guard lock(mutex_);
        ++helpers_;
    }
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

void Threads::leave()
{
    const std::lock_guard lock(mutex_);
    if (--helpers_ == 0) done_.notify_one();
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
    if (!begun_) begin();
    Loop loop{first, last, f, nullptr};
    {
        const std::lock_guard lock(mutex_);
        loop_ = &loop;
        busy_ = helpers_;
        ++loops_;
    }
    asked_.notify_all();
    run(loop, 0);
    std::unique_lock lock(mutex_);
    done_.wait(lock, [&] { return busy_ == 0; });
    if (loop.failed) std::rethrow_exception(loop.failed);
}

}  // namespace trace
