#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <ctime>

namespace scene {

inline constexpr std::size_t kLargePage = std::size_t{2} << 20;

/// Nanoseconds of the processor since the thread began.
inline long thread_time()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return now.tv_sec * 1'000'000'000 + now.tv_nsec;
}

/// Nanoseconds that a page of 4 kB takes when it is touched first: 250 to 1,500, and 16,000 in a virtual machine whose
/// host hears of each. The least of four, measured once.
inline long small_page_time()
{
    static const long time = [] {
        constexpr std::size_t kPage = 4096, kCount = 4;
        void* const memory = mmap(nullptr, kCount * kPage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        long least = 0;
        for (std::size_t i = 0; memory != MAP_FAILED && i < kCount; ++i) {
            const long before = thread_time();
            static_cast<volatile char*>(memory)[i * kPage] = 0;
            const long taken = thread_time() - before;
            least = i == 0 ? taken : std::min(least, taken);
        }
        if (memory != MAP_FAILED) munmap(memory, kCount * kPage);
        return least;
    }();
    return time;
}

/// Asks for pages of 2 MB in the memory, which begins with one, and touches that; whether it was fast. In a virtual
/// machine the host may first have to find the memory in small pages: ten times the work of clearing it, and slower
/// than small pages that the guest already has, unless each of these takes long too. Where the kernel has no such pages
/// this changes nothing.
inline bool take_large_page(void* memory, std::size_t bytes)
{
    // Nanoseconds; clearing takes 100'000 to 300'000. Of the small ones some would never be touched.
    constexpr long kClearing = 600'000, kTouched = 384;
    madvise(memory, bytes, MADV_HUGEPAGE);
    const long before = thread_time();
    *static_cast<volatile char*>(memory) = 0;
    return thread_time() - before < std::max(kClearing, kTouched * small_page_time());
}

}  // namespace scene
