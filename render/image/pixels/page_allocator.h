#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <new>

namespace image {

enum class Pages { large, small };

/// Memory that is zero from the start and takes no room until it is written: a new vector of n elements is n zeros at
/// once. Elements that a vector gains by `resize` within room that it had hold what was there before. Its pages are of
/// 2 MB where there is much of it, for touched one by one, 4 kB pages cost a picture of 1280x960 4 ms; small ones are
/// for pictures that are written here and there.
template <class T>
struct PageAllocator {
    using value_type = T;

    Pages pages = Pages::large;

    PageAllocator() = default;
    explicit PageAllocator(Pages wanted) : pages(wanted) {}
    template <class U>
    PageAllocator(const PageAllocator<U>& other) : pages(other.pages)
    {}

    T* allocate(std::size_t count)
    {
        void* memory = std::calloc(count, sizeof(T));
        if (memory == nullptr)  // operator new tells how much is refused
            memory = std::memset(::operator new(count * sizeof(T)), 0, count * sizeof(T));
        const std::uintptr_t begin = (reinterpret_cast<std::uintptr_t>(memory) + kPage - 1) / kPage * kPage;
        const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(memory) + count * sizeof(T)) / kPage * kPage;
        if (pages == Pages::large && begin < end)  // where the kernel has no such pages this changes nothing
            madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t) { std::free(memory); }
    /// Nothing to do: the memory is zero.
    void construct(T*) {}

    friend bool operator==(const PageAllocator&, const PageAllocator&) { return true; }

private:
    static constexpr std::size_t kPage = std::size_t{2} << 20;
};

}  // namespace image
