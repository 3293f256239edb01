#include "render/app/run/memory.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <new>

// Memory that the system refuses is told with its size: the standard's std::bad_alloc says its own name. Nothing here
// may allocate.
namespace app {
namespace {

/// Address space of this process in bytes; 0: unknown.
double address_space()
{
    std::array<char, 64> text{};
    const int file = open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    if (file < 0) return 0.0;
    const ssize_t count = read(file, text.data(), text.size() - 1);
    close(file);
    return count > 0 ? std::strtod(text.data(), nullptr) * static_cast<double>(sysconf(_SC_PAGESIZE)) : 0.0;
}

class RefusedMemory final : public std::bad_alloc {
public:
    explicit RefusedMemory(std::size_t bytes)
    {
        constexpr double kMega = 1e6;
        const double needed = static_cast<double>(bytes) / kMega, used = address_space() / kMega;
        rlimit limit{};
        const bool limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
        if (limited)
            std::snprintf(
                text_.data(), text_.size(),
                "memory is refused: %.1f MB more are needed, and %.1f MB of the %.1f MB that this process may "
                "have are in use (ulimit -v)",
                needed, used, static_cast<double>(limit.rlim_cur) / kMega);
        else
            std::snprintf(text_.data(), text_.size(), "memory is refused: %.1f MB more are needed, %.1f MB are in use",
                          needed, used);
    }
    const char* what() const noexcept override { return text_.data(); }

private:
    std::array<char, 200> text_{};
};

}  // namespace

void refuse_memory(std::size_t bytes) { throw RefusedMemory(bytes); }

}  // namespace app

// The address sanitizer has its own, which find what these would hide.
#if !defined(__SANITIZE_ADDRESS__)
void* operator new(std::size_t bytes)
{
    void* const memory = std::malloc(bytes == 0 ? 1 : bytes);
    if (!memory) app::refuse_memory(bytes);
    return memory;
}

void* operator new(std::size_t bytes, std::align_val_t alignment)
{
    const auto step = static_cast<std::size_t>(alignment);
    void* const memory = std::aligned_alloc(step, (bytes + step - 1) / step * step);
    if (!memory) app::refuse_memory(bytes);
    return memory;
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
#endif
