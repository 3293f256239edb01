#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace support {

inline std::string text_of(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

inline void write_text(const std::string& path, const std::string& text)
{
    std::ofstream(path, std::ios::binary) << text;
}

inline bool ascii(const std::string& text)
{
    return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

/// How a program ended: exit status, or minus the signal's number. What it wrote stands in files.
struct Ended {
    int status;
    std::string out, err;
    double cpu_seconds = 0.0;  ///< of all its threads
};

/// A program that runs in a folder, without a shell: the arguments arrive as they stand. HOME is the folder, there is
/// no display and no POVINI. What it writes goes to files beside the folder, or nowhere if `err` is a pipe's end.
class RunningProgram {
public:
    /// \param input  what standard input holds
    /// \param error_end  a file descriptor for standard error instead of a file
    RunningProgram(const std::string& folder, const std::string& program, std::vector<std::string> arguments,
                   const std::string& input = {}, int error_end = -1)
        : base_(folder + ".streams")
    {
        write_text(base_ + ".in", input);
        arguments.insert(arguments.begin(), program);
        // A signal may come before the program itself has begun: none of the test's own handlers may see it.
        sigset_t all, before;
        sigfillset(&all);
        sigprocmask(SIG_SETMASK, &all, &before);
        process_ = fork();
        if (process_ == 0) {
            for (const int handled : {SIGINT, SIGTERM, SIGHUP, SIGSEGV, SIGABRT, SIGFPE, SIGILL})
                ::signal(handled, SIG_DFL);
        }
        sigprocmask(SIG_SETMASK, &before, nullptr);
        if (process_ < 0) throw std::runtime_error("no process");
        if (process_ == 0) become(folder, arguments, error_end);
    }
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;
    ~RunningProgram()
    {
        if (process_ > 0) {
            ::kill(process_, SIGKILL);
            waitpid(process_, nullptr, 0);
        }
        for (const char* end : {".in", ".out", ".err"}) std::remove((base_ + end).c_str());
    }

    void kill(int signal) const { ::kill(process_, signal); }
    std::string error_so_far() const { return text_of(base_ + ".err"); }
    bool running() { return process_ > 0 && wait4(process_, &result_, WNOHANG, &usage_) == 0; }

    /// Of all threads, till now.
    double cpu_seconds() const
    {
        std::istringstream in(text_of("/proc/" + std::to_string(process_) + "/stat"));
        std::string word;
        double ticks = 0.0;
        for (int i = 1; i <= 15 && in >> word; ++i)
            if (i >= 14) ticks += std::strtod(word.c_str(), nullptr);
        return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
    }

    /// Waits for the end, at most so long; then the program is killed and the status is -SIGKILL.
    Ended wait(std::chrono::seconds at_most = std::chrono::seconds(60))
    {
        const auto end = std::chrono::steady_clock::now() + at_most;
        while (running()) {
            if (std::chrono::steady_clock::now() > end) ::kill(process_, SIGKILL);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        process_ = 0;
        return {WIFEXITED(result_) ? WEXITSTATUS(result_) : -WTERMSIG(result_), text_of(base_ + ".out"),
                text_of(base_ + ".err"), seconds(usage_.ru_utime) + seconds(usage_.ru_stime)};
    }

private:
    [[noreturn]] void become(const std::string& folder, const std::vector<std::string>& arguments, int error_end) const
    {
        const auto redirect = [](const std::string& path, int flags, int to) {
            dup2(open(path.c_str(), flags, 0600), to);
        };
        redirect(base_ + ".in", O_RDONLY, STDIN_FILENO);
        redirect(base_ + ".out", O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
        if (error_end >= 0) dup2(error_end, STDERR_FILENO);
        else redirect(base_ + ".err", O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, STDERR_FILENO);
        setenv("HOME", folder.c_str(), 1);
        unsetenv("DISPLAY");
        unsetenv("POVINI");
        std::vector<char*> values;
        for (const std::string& argument : arguments) values.push_back(const_cast<char*>(argument.c_str()));
        values.push_back(nullptr);
        if (chdir(folder.c_str()) == 0) execv(values[0], values.data());
        _exit(127);
    }

    static double seconds(const timeval& time)
    {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }

    std::string base_;
    pid_t process_ = 0;
    int result_ = 0;
    rusage usage_{};
};

inline Ended run_program(const std::string& folder, const std::string& program,
                         const std::vector<std::string>& arguments, const std::string& input = {})
{
    return RunningProgram(folder, program, arguments, input).wait();
}

}  // namespace support
