#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>

namespace trace {

/// wanted: 0 for all cores that this process may run on.
int threads_of(int wanted);

/// Threads that share a loop, the one that asks among them. The others begin with the first loop, with stacks of
/// plan::rendering_stack() bytes, and wait for the next; afterwards they wait for whoever asks next in this process.
/// One thread alone begins none. Where the system refuses more threads those that there are do the work. One loop at a
/// time.
class Threads {
public:
    /// count: as many at most, at least 1.
    explicit Threads(int count) : count_(count < 1 ? 1 : count) {}
    ~Threads();
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

    int count() const { return count_; }

    /// f(i, thread) for each i of [first, last), the lower ones first; thread is in [0, count()) and runs one call at a
    /// time. Returns when all is done. What a call throws ends the loop, and the first of it is thrown here.
    void each(std::size_t first, std::size_t last, const std::function<void(std::size_t, int)>& f);

private:
    struct Loop;
    class Helper;

    void begin();
    void wait_for_loops(int number);
    void leave();
    void run(Loop& loop, int number);

    const int count_;
    bool begun_ = false;
    std::mutex mutex_;
    std::condition_variable asked_, done_;
    Loop* loop_ = nullptr;     // guarded, as all below
    std::uint64_t loops_ = 0;  // asked for so far
    std::size_t helpers_ = 0, busy_ = 0;
    bool over_ = false;
};

}  // namespace trace
