#include "render/app/program.h"

#include "render/app/run/written_journal.h"
#include "render/app/report/console_reporter.h"
#include "render/app/run/memory.h"
#include "render/scene/base/large_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace app {
namespace {

Cancellation of_process;
const char* last_words = "cancelled\n";  // of a run that a signal ends where nobody looks for it
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler uses them");

void cancel(int)
{
    const bool again = of_process.requested.exchange(true);
    if (!again && of_process.heeded) return of_process.wake();
    if (!again) { [[maybe_unused]] const auto written = write(STDERR_FILENO, last_words, std::strlen(last_words)); }
    _exit(kCancelled);
}

/// A link called povray, povray-3.7 or the like: a program that calls it wants POV-Ray's console.
ConsoleStyle style_of(const std::string& program)
{
    return std::filesystem::path(program).filename().string().starts_with("povray") ? ConsoleStyle::Povray
                                                                                    : ConsoleStyle::Whittle;
}

/// What was printed has to arrive: `failure` where a status promises so and the file or pipe does not take it.
int with_output(int status, int failure)
{
    const bool arrived = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (arrived || status == failure || status == kCancelled) return status;
    fmt::print(stderr, "whittle: error: cannot write to standard output: {}\n", std::strerror(errno));
    return failure;
}

#if defined(__GLIBC__)
/// Lets the heap begin with room in pages of 2 MB, for each small page that is touched costs 1 to 12 microseconds: most
/// of what a small scene takes, and a third of what a description of 20,000 objects does. `grown`: by so much
/// afterwards.
void begin_heap_with_large_pages(int grown)
{
    constexpr int kRoom = 256 << 20;
    constexpr std::uintptr_t kPage = scene::kLargePage;
    constexpr std::size_t kFirst = std::size_t{64} << 10, kHeader = 32;
    mallopt(M_TOP_PAD, grown);
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY) return;  // the room would count
    mallopt(M_TOP_PAD, kRoom);
    void* const first = std::malloc(kFirst);
    mallopt(M_TOP_PAD, grown);
    const auto at = reinterpret_cast<std::uintptr_t>(first), begin = (at + kFirst + kHeader + kPage) / kPage * kPage,
               end = reinterpret_cast<std::uintptr_t>(sbrk(0)) / kPage * kPage;
    if (begin >= end || end - begin > kRoom) return std::free(first);  // elsewhere than in the heap
    scene::take_large_pages(reinterpret_cast<void*>(begin), end - begin);
    // What lies before the first large page is left out for good: it is never touched.
    static const void* const before_pages = std::realloc(first, begin - at - kHeader);
    static_cast<void>(before_pages);
}
#endif

/// What has been freed is used again before the system is asked for more: a page that comes anew is cleared first, and
/// lists that grow would pay for that at each size.
void keep_freed_memory()
{
#if defined(__GLIBC__)
    constexpr int kMostKept = 512 << 20, kAtOnce = 4 << 20;  // bytes
    mallopt(M_MMAP_THRESHOLD, kMapped);
    mallopt(M_TRIM_THRESHOLD, kMostKept);
    begin_heap_with_large_pages(kAtOnce);
#endif
}

}  // namespace

Cancellation& cancellation() { return of_process; }

void heed_signals()
{
    for (const int signal : {SIGINT, SIGTERM, SIGQUIT, SIGPIPE}) std::signal(signal, cancel);
}

bool has_word(const Words& arguments, std::initializer_list<std::string_view> words)
{
    return std::any_of(arguments.begin(), arguments.end(),
                       [&](const std::string& a) { return std::find(words.begin(), words.end(), a) != words.end(); });
}

bool wants_help(const Words& arguments) { return has_word(arguments, {"--help", "-help", "-h", "-?"}); }

int call(const Called& command, const Words& arguments)
{
    if (!wants_help(arguments)) return command.run({arguments.begin() + 1, arguments.end()});
    fmt::print("{}", command.help());
    return kSuccess;
}

void run_program(int count, char** values, int (*run)(const Words&, Settings&, Remains&), int failure)
{
    keep_freed_memory();
    const std::vector<std::string> arguments(values + std::min(count, 1), values + count);
    Settings settings;
    settings.console_style = style_of(count > 0 ? values[0] : "");
    if (settings.console_style == ConsoleStyle::Povray) last_words = "\nRender cancelled by user\n\n";
    int status = kError;
    Remains remains;  // until the process ends
    try {
        status = run(arguments, settings, remains);
    } catch (const std::exception& error) {
        status = status_of(error);
        const std::string text = text_of(error);
        journal_option_error(settings, text, status);
        tell_option_error(settings.console_style, fmt::format("{}", fmt::join(values, values + count, " ")), text);
    }
    status = with_output(status, failure);
    std::fflush(nullptr);
#ifdef WHITTLE_TRAIN
    std::exit(status);  // which writes what the kernels have counted
#endif
    _exit(status);  // nothing to clean up: a picture library that is still loading would only delay the end
}

}  // namespace app
