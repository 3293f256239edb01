#include "render/app/run/stacks.h"

#include "render/plan/rendering_stack.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <pthread.h>
#include <sys/resource.h>
#include <system_error>
#include <thread>
#include <utility>

namespace app {
namespace {

constexpr std::size_t kDeep = std::size_t{256} << 20, kUsual = std::size_t{8} << 20;  // bytes

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)  // which clears the shadow of a whole stack
/// Of a thread that is not the first.
std::size_t deep_stack()
{
    constexpr std::size_t kShare = 8;  // of the memory that may be had, for the stacks of all threads
    rlimit limit;
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kDeep;
    return std::min<std::size_t>(kDeep, limit.rlim_cur / kShare / (std::thread::hardware_concurrency() + 1));
}
#else
std::size_t deep_stack() { return kUsual; }
#endif

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
/// Takes what tracing needs of the first thread's stack while there is room: where memory is short its growth would be
/// refused later, which ends the process without a word.
[[gnu::noinline]] void grow_first_stack()
{
    constexpr std::size_t kTracing = std::size_t{1} << 20;  // bytes; kernels with vectors of eight use 450,000
    constexpr std::size_t kPage = 4096;
    [[maybe_unused]] volatile char room[kTracing];
    for (std::size_t at = kTracing; at > 0; at -= kPage) room[at - 1] = 0;
}
#endif

void* run_work(void* work)
{
    const std::unique_ptr<std::function<void()>> owned(static_cast<std::function<void()>*>(work));
    (*owned)();
    return nullptr;
}

}  // namespace

void deepen_stacks()
{
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
    constexpr rlim_t kFirst = rlim_t{120} << 20;  // bytes; the system keeps 128 MB free below the first thread's
    rlimit limit;
    if (getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur < kFirst) {
        limit.rlim_cur = std::min(kFirst, limit.rlim_max);
        setrlimit(RLIMIT_STACK, &limit);
    }
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) grow_first_stack();
    const std::size_t other = deep_stack();
    if (other <= kUsual) return;
    plan::rendering_stack() = other;
    pthread_attr_t others;
    if (pthread_getattr_default_np(&others) != 0) return;
    if (pthread_attr_setstacksize(&others, other) == 0) pthread_setattr_default_np(&others);
    pthread_attr_destroy(&others);
#endif
}

void start_on_deep_stack(std::function<void()> work)
{
    const std::size_t stack = deep_stack();
    if (stack > kUsual) plan::rendering_stack() = stack;
    auto owned = std::make_unique<std::function<void()>>(std::move(work));
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
    if (stack > kUsual) pthread_attr_setstacksize(&attributes, stack);
    const std::unique_ptr<pthread_attr_t, int (*)(pthread_attr_t*)> destroyed(&attributes, pthread_attr_destroy);
    start_thread(run_work, owned.get(), &attributes);
    static_cast<void>(owned.release());  // the thread has it
}

pthread_t start_thread(void* (*work)(void*), void* of, const pthread_attr_t* attributes)
{
    pthread_t thread;
    const int failed = pthread_create(&thread, attributes, work, of);
    if (failed != 0) throw std::system_error(failed, std::generic_category(), "cannot start a thread");
    return thread;
}

}  // namespace app
