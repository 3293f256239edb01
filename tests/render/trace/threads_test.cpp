#include "render/picture/threads.h"

#include "render/plan/rendering_stack.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

constexpr std::size_t kFirst = 3, kLast = 1'000;

/// How often each step was done, and that no thread's number was in two calls at a time.
std::vector<int> steps_done(trace::Threads& threads)
{
    std::vector<std::atomic<int>> done(kLast), within(static_cast<std::size_t>(threads.count()));
    std::atomic<int> wrong = 0;
    threads.each(kFirst, kLast, [&](std::size_t i, int thread) {
        std::atomic<int>& calls = within.at(static_cast<std::size_t>(thread));
        if (++calls != 1) ++wrong;
        ++done.at(i);
        if (i % 16 == 0) std::this_thread::yield();
        --calls;
    });
    CHECK(wrong == 0);
    return {done.begin(), done.end()};
}

std::vector<int> each_once()
{
    std::vector<int> out(kLast, 1);
    for (std::size_t i = 0; i < kFirst; ++i) out[i] = 0;
    return out;
}

}  // namespace

TEST_CASE("Threads that share loops do each step of each loop once")
{
    for (const int count : {-1, 0, 1, 2, 7}) {
        trace::Threads threads(count);
        for (int loop = 0; loop < 50; ++loop) REQUIRE(steps_done(threads) == each_once());
        threads.each(5, 5, [](std::size_t, int) { FAIL("nothing to do"); });
        threads.each(6, 5, [](std::size_t, int) { FAIL("nothing to do"); });
    }
}

TEST_CASE("A loop is shared by as many threads as were asked for")
{
    // Each step waits for one of every other thread: with fewer of them this would not end.
    constexpr int kCount = 4;
    trace::Threads threads(kCount);
    std::mutex mutex;
    std::set<std::thread::id> met;
    std::atomic<int> waiting = 0;
    threads.each(0, kCount, [&](std::size_t, int) {
        {
            const std::lock_guard lock(mutex);
            met.insert(std::this_thread::get_id());
        }
        ++waiting;
        while (waiting < kCount) std::this_thread::yield();
    });
    CHECK(met.size() == kCount);
    CHECK(met.count(std::this_thread::get_id()) == 1);
}

TEST_CASE("What a step throws ends its loop and arrives; the next loop is done")
{
    for (const int count : {1, 4}) {
        trace::Threads threads(count);
        std::atomic<std::size_t> done = 0;
        const auto failing = [&](std::size_t i, int) {
            if (i >= 10) throw std::runtime_error("step");
            ++done;
        };
        CHECK_THROWS_WITH(threads.each(0, 1'000'000, failing), "step");
        CHECK(done == 10);
        CHECK(steps_done(threads) == each_once());
    }
}

TEST_CASE("Where no more threads may begin, those that there are do the work")
{
    const std::size_t usual = plan::rendering_stack();
    plan::rendering_stack() = std::size_t{1} << 60;  // bytes, which no system has
    trace::Threads threads(4);
    CHECK(steps_done(threads) == each_once());
    plan::rendering_stack() = usual;
}
