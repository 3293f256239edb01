#include "render/app/heap.h"

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>

namespace app {
namespace {

constexpr std::size_t kHugePage = std::size_t{2} << 20, kReserved = std::size_t{256} << 20;
/// A small scene stays below, and takes no more than it did.
constexpr std::size_t kFew = std::size_t{1} << 20;
/// Where the reserve is used up, blocks from here on are mapped by themselves and go back as soon as they are freed.
constexpr int kLargeBlock = 8 << 20;
constexpr int kNoTrimBelow = 2047 << 20, kMostMapped = 1 << 16;

bool limited(decltype(RLIMIT_AS) resource)
{
    rlimit limit{};
    return getrlimit(resource, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
}

/// Where the system counts addresses as memory, what is not touched would be missing elsewhere.
bool addresses_are_counted()
{
    int mode = 0;
    return limited(RLIMIT_AS) || limited(RLIMIT_DATA) ||
           (std::ifstream("/proc/sys/vm/overcommit_memory") >> mode && mode == 2);
}

}  // namespace

void prepare_heap()
{
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    if (addresses_are_counted()) return;
    mallopt(M_TRIM_THRESHOLD, kNoTrimBelow);
    mallopt(M_MMAP_THRESHOLD, kLargeBlock);
    mallopt(M_MMAP_MAX, 0);  // the heap itself grows by what is asked for now
    void* const all = std::malloc(kReserved);
    mallopt(M_MMAP_MAX, kMostMapped);
    if (!all) return;
    const auto begin = reinterpret_cast<std::uintptr_t>(all), end = begin + kReserved;
    std::free(all);                                               // to be the rest of the heap, whose addresses stay
    if (reinterpret_cast<std::uintptr_t>(sbrk(0)) < end) return;  // another allocator
    const std::uintptr_t first = (begin + kFew + kHugePage - 1) / kHugePage * kHugePage;
    madvise(reinterpret_cast<void*>(first), end / kHugePage * kHugePage - first, MADV_HUGEPAGE);
#endif
}

}  // namespace app
