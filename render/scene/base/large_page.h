#pragma once

#include "render/scene/base/thread_time.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace scene {

inline constexpr std::size_t kLargePage = std::size_t{2} << 20;

/// Seconds that a page of 4 kB takes when it is touched first: 0.25 to 1.5 millionths, and 16 in a virtual machine
/// whose host hears of each. The least of four, measured once.
inline double small_page_time()
{
    static const double time = [] {
        constexpr std::size_t kPage = 4096, kCount = 4;
        void* const memory = mmap(nullptr, kCount * kPage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        double least = 0.0;
        for (std::size_t i = 0; memory != MAP_FAILED && i < kCount; ++i) {
            const double before = thread_seconds();
            static_cast<volatile char*>(memory)[i * kPage] = 0;
            const double taken = thread_seconds() - before;
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
    // Clearing takes 0.1 to 0.3 ms. Of the small ones some would never be touched.
    constexpr double kClearing = 600e-6, kTouched = 384.0;
    madvise(memory, bytes, MADV_HUGEPAGE);
    const double before = thread_seconds();
    *static_cast<volatile char*>(memory) = 0;
    const double taken = thread_seconds() - before;
    return taken < kClearing || taken < kTouched * small_page_time();
}

/// Has the memory in pages of 2 MB as far as it holds whole ones, unless the first of them is slow. It is the caller's
/// and not yet used.
inline void take_large_pages(void* memory, std::size_t bytes)
{
    const auto at = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t begin = (at + kLargePage - 1) / kLargePage * kLargePage,
                         end = (at + bytes) / kLargePage * kLargePage;
    if (begin >= end) return;
    void* const pages = reinterpret_cast<void*>(begin);
    if (!take_large_page(pages, end - begin)) madvise(pages, end - begin, MADV_NOHUGEPAGE);
}

}  // namespace scene
