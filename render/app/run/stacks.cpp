#include "render/app/run/stacks.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <cstddef>
#include <pthread.h>
#include <sys/resource.h>
#include <thread>

namespace app {

void deepen_stacks()
{
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)  // which clears the shadow of a whole stack
    constexpr rlim_t kFirst = rlim_t{120} << 20;  // bytes; the system keeps 128 MB free below the first thread's
    constexpr std::size_t kOther = std::size_t{256} << 20, kUsual = std::size_t{8} << 20;
    constexpr std::size_t kShare = 8;  // of the memory that may be had, for the stacks of all threads
    rlimit limit;
    if (getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur < kFirst) {
        limit.rlim_cur = std::min(kFirst, limit.rlim_max);
        setrlimit(RLIMIT_STACK, &limit);
    }
    std::size_t other = kOther;
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        other = std::min<std::size_t>(kOther, limit.rlim_cur / kShare / (std::thread::hardware_concurrency() + 1));
    if (other <= kUsual) return;
    static const tbb::global_control workers(tbb::global_control::thread_stack_size, other);
    pthread_attr_t others;
    if (pthread_getattr_default_np(&others) != 0) return;
    if (pthread_attr_setstacksize(&others, other) == 0) pthread_setattr_default_np(&others);
    pthread_attr_destroy(&others);
#endif
}

}  // namespace app
