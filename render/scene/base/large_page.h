#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <ctime>

namespace scene {

inline constexpr std::size_t kLargePage = std::size_t{2} << 20;

/// Asks for pages of 2 MB in the memory, which begins with one, and touches that; whether it was fast. In a virtual
/// machine the host may first have to find the memory in small pages: ten times the work of clearing it, and slower
/// than small pages that the guest already has. Where the kernel has no such pages this changes nothing.
inline bool take_large_page(void* memory, std::size_t bytes)
{
    // Nanoseconds; clearing takes 100'000 to 300'000, small pages as many bytes 800'000.
    constexpr long kSlow = 600'000;
    timespec before{}, after{};
    madvise(memory, bytes, MADV_HUGEPAGE);
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &before);
    *static_cast<volatile char*>(memory) = 0;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &after);
    return (after.tv_sec - before.tv_sec) * 1'000'000'000 + after.tv_nsec - before.tv_nsec < kSlow;
}

}  // namespace scene
