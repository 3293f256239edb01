#include "render/app/run/memory.h"

#include "render/scene/base/large_page.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string_view>
#include <system_error>

// Memory of the program: what the system refuses is told with its size, for the standard's std::bad_alloc says its own
// name, and what malloc maps by itself comes in large pages. Nothing here may allocate.
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

using Text = std::array<char, 200>;

/// \param bytes that were asked for; 0: unknown
void write_refusal(Text& text, std::size_t bytes)
{
    constexpr double kMega = 1e6, kKilo = 1e3;
    std::array<char, 40> needed{};
    const auto asked = static_cast<double>(bytes);
    if (asked >= kMega) std::snprintf(needed.data(), needed.size(), ": %.1f MB more are needed", asked / kMega);
    else if (asked >= kKilo) std::snprintf(needed.data(), needed.size(), ": %.1f kB more are needed", asked / kKilo);
    else if (bytes > 0) std::snprintf(needed.data(), needed.size(), ": %zu bytes more are needed", bytes);
    rlimit limit{};
    const bool limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    const double used = address_space() / kMega;
    if (limited)
        std::snprintf(text.data(), text.size(),
                      "memory is refused%s; %.1f MB of the %.1f MB that this process may have (ulimit -v) are in use",
                      needed.data(), used, static_cast<double>(limit.rlim_cur) / kMega);
    else std::snprintf(text.data(), text.size(), "memory is refused%s; %.1f MB are in use", needed.data(), used);
}

class RefusedMemory final : public std::bad_alloc {
public:
    explicit RefusedMemory(std::size_t bytes) { write_refusal(text_, bytes); }
    const char* what() const noexcept override { return text_.data(); }

private:
    Text text_{};
};

}  // namespace

void refuse_memory(std::size_t bytes) { throw RefusedMemory(bytes); }

bool refuses_thread(const std::exception& error)
{
    const auto* const system = dynamic_cast<const std::system_error*>(&error);
    if (system != nullptr) return system->code() == std::errc::resource_unavailable_try_again;
    return std::string_view(error.what()).starts_with("pthread_create ");  // TBB's, a plain std::runtime_error
}

std::string text_of(const std::exception& error)
{
    if (refuses_thread(error))
        return "a thread cannot be started: this process may have no more memory (ulimit -v) or threads (ulimit -u)";
    const bool refused = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
    if (!refused || dynamic_cast<const RefusedMemory*>(&error) != nullptr) return error.what();
    Text text{};
    write_refusal(text, 0);  // a library's own, which does not tell how much
    return text.data();
}

}  // namespace app

// The address sanitizer has its own, which find what these would hide.
#if !defined(__SANITIZE_ADDRESS__)
void* operator new(std::size_t bytes)
{
    void* const memory = std::malloc(bytes == 0 ? 1 : bytes);
    if (!memory) app::refuse_memory(bytes);
    if (bytes >= app::kMapped) scene::take_large_pages(memory, bytes);
    return memory;
}

void* operator new(std::size_t bytes, std::align_val_t alignment)
{
    const auto step = static_cast<std::size_t>(alignment);
    void* const memory = std::aligned_alloc(step, (bytes + step - 1) / step * step);
    if (!memory) app::refuse_memory(bytes);
    if (bytes >= app::kMapped) scene::take_large_pages(memory, bytes);
    return memory;
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
#endif
