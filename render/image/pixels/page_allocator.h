#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>

namespace image {

/// Memory in pages of 2 MB where there is much of it: touched one by one, 4 kB pages cost a picture of 1280x960 4 ms.
template <class T>
struct PageAllocator {
    using value_type = T;

    PageAllocator() = default;
    template <class U>
    PageAllocator(const PageAllocator<U>&)
    {}

    T* allocate(std::size_t count)
    {
        if (count > (kMost - kPage) / sizeof(T)) throw std::bad_alloc();
        const std::size_t bytes = count * sizeof(T);
        if (bytes < kMuch) return static_cast<T*>(::operator new(bytes));
        const std::size_t whole = (bytes + kPage - 1) / kPage * kPage;
        void* memory = ::operator new (whole, std::align_val_t{kPage});
        madvise(memory, whole, MADV_HUGEPAGE);  // where the kernel has none this changes nothing
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count)
    {
        if (count * sizeof(T) < kMuch) ::operator delete(memory);
        else ::operator delete (memory, std::align_val_t{kPage});
    }
    friend bool operator==(const PageAllocator&, const PageAllocator&) { return true; }

private:
    static constexpr std::size_t kPage = std::size_t{2} << 20, kMuch = 2 * kPage, kMost = ~std::size_t{0};
};

}  // namespace image
