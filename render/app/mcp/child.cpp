#include "render/app/mcp/child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <stdexcept>

namespace app::mcp {
namespace {

using ChildClock = std::chrono::steady_clock;

constexpr double kGrace = 1.0;                      // seconds from asking to ending
constexpr rlim_t kLargestFile = rlim_t{256} << 20;  // bytes

void limit(int what, rlim_t most)
{
    rlimit both{};
    getrlimit(static_cast<__rlimit_resource>(what), &both);
    both.rlim_cur = both.rlim_max = both.rlim_max == RLIM_INFINITY ? most : std::min(most, both.rlim_max);
    setrlimit(static_cast<__rlimit_resource>(what), &both);
}

/// In the new process: never returns.
[[noreturn]] void be_child(const std::function<int()>& work, const int (&out)[2], const int (&err)[2])
{
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(out[1], STDOUT_FILENO);
    dup2(err[1], STDERR_FILENO);
    for (const int file : {nothing, out[0], out[1], err[0], err[1]}) close(file);
    for (const int signal : {SIGPIPE, SIGINT, SIGTERM, SIGCHLD}) std::signal(signal, SIG_DFL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, kLargestFile);
    int status = 1;
    try {
        status = work();
    } catch (const std::exception& error) {
        fmt::print(stderr, "error: {}\n", error.what());
    }
    std::fflush(nullptr);
    _exit(status);
}

/// Bytes that a process has in memory now. Addresses would say little: stacks of many threads take many, and no memory.
std::size_t resident_of(pid_t process)
{
    unsigned long all = 0, here = 0;
    if (std::FILE* const file = std::fopen(fmt::format("/proc/{}/statm", process).c_str(), "r")) {
        if (std::fscanf(file, "%lu %lu", &all, &here) != 2) here = 0;
        std::fclose(file);
    }
    return here * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// One end of a pipe, with what came through it.
struct Listened {
    int file;
    std::string& text;
    bool open = true;

    void read_some(std::size_t most)
    {
        char block[1 << 16];
        const ssize_t got = ::read(file, block, sizeof block);
        if (got < 0 && (errno == EINTR || errno == EAGAIN)) return;
        if (got <= 0) {
            ::close(file);
            open = false;
            return;
        }
        const std::size_t room = most - std::min(most, text.size());
        text.append(block, std::min(room, static_cast<std::size_t>(got)));
    }
};

}  // namespace

ChildResult run_child(const ChildLimits& limits, const std::function<int()>& work, const std::function<int()>& listen,
                      const std::function<bool()>& wanted)
{
    int out[2], err[2];
    if (pipe2(out, O_CLOEXEC) != 0) throw std::runtime_error("no pipe is to be had");
    if (pipe2(err, O_CLOEXEC) != 0) {
        close(out[0]);
        close(out[1]);
        throw std::runtime_error("no pipe is to be had");
    }
    std::fflush(nullptr);  // else the copy would say it again
    const pid_t child = fork();
    if (child == 0) be_child(work, out, err);
    close(out[1]);
    close(err[1]);
    if (child < 0) {
        close(out[0]);
        close(err[0]);
        throw std::runtime_error("no process is to be had");
    }
    setpgid(child, child);

    ChildResult result;
    Listened listened[2] = {{out[0], result.out}, {err[0], result.err}};
    const auto start = ChildClock::now();
    double ask_at = limits.seconds, end_at = limits.seconds + kGrace;
    bool asked = false;
    const auto signal_all = [&](int signal) { ::kill(-child, signal); };
    while (listened[0].open || listened[1].open) {
        constexpr int kLook = 20;  // ms
        pollfd files[3] = {{listened[0].open ? listened[0].file : -1, POLLIN, 0},
                           {listened[1].open ? listened[1].file : -1, POLLIN, 0},
                           {result.cancelled ? -1 : listen(), POLLIN, 0}};
        ::poll(files, 3, kLook);
        for (int i = 0; i < 2; ++i)
            if (listened[i].open && files[i].revents != 0) listened[i].read_some(limits.output);
        const double seconds = std::chrono::duration<double>(ChildClock::now() - start).count();
        if (!result.cancelled && !wanted()) {
            result.cancelled = true;
            ask_at = seconds;
            end_at = seconds + kGrace;
        }
        if (!result.too_large && resident_of(child) > limits.memory) {
            result.too_large = true;
            end_at = seconds;
        }
        if (!asked && seconds >= ask_at) {
            asked = true;
            result.late = !result.cancelled;
            signal_all(SIGINT);
        }
        if (seconds >= end_at) {
            signal_all(SIGKILL);
            end_at = seconds + kGrace;
        }
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    signal_all(SIGKILL);  // what it left behind
    if (WIFEXITED(status)) result.status = WEXITSTATUS(status);
    else if (WIFSIGNALED(status) && !asked && !result.too_large) result.signal = WTERMSIG(status);
    return result;
}

}  // namespace app::mcp
