#pragma once

#include "render/app/options/settings.h"
#include "render/lint/lint.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace app::lsp {

/// What reading a scene told.
struct Told {
    scene::Message message;
    std::string check;  ///< name of the lint check that found it; empty: the parser's
};

struct Reading {
    std::string scene;
    std::uint64_t number = 0;  ///< that ask() gave
    std::vector<Told> told;
    bool whole = false;                         ///< it could be read to its end
    std::map<std::string, std::string> values;  ///< parser::Result::values, where it could
};

struct Limits {
    double seconds = 10;                        ///< a scene that takes longer is stopped
    std::size_t memory = std::size_t{2} << 30;  ///< bytes that the program may grow while it reads
    lint::Wanted lint;
};

/// Reads scenes on a thread of its own, the newest text first. What runs is stopped when newer text comes.
class Reader {
public:
    using Texts = std::map<std::string, std::string>;
    /// \param done is called on that thread, unless what was read is out of date
    Reader(const Settings& settings, const Limits& limits, std::function<void(Reading&&)> done);
    ~Reader() { stop(); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    /// Texts of the editor by absolute path lie over the files on disk. Each time gives another number.
    std::uint64_t ask(const std::string& scene, std::shared_ptr<const Texts> texts);
    void forget(const std::string& scene);
    /// Ends both threads.
    void stop();

private:
    enum class Stop : int { No, Newer, Time, Memory };
    struct Job {
        std::string scene;
        std::shared_ptr<const Texts> texts;
        std::uint64_t number = 0;
    };
    void work();
    void watch();
    void interrupt(Stop why);
    bool read(const Job& job, Reading& reading);
    void cut_short(Reading& reading, const scene::Message& at, Stop why, const lint::Reader& texts);

    const Settings& settings_;
    const Limits limits_;
    const std::function<void(Reading&&)> done_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> waiting_;
    std::uint64_t asked_ = 0;
    std::optional<Job> running_;
    std::chrono::steady_clock::time_point since_;  ///< of what runs
    std::size_t before_ = 0;                       ///< bytes that the program had then
    std::atomic<bool> cancel_ = false;
    std::atomic<Stop> why_ = Stop::No;
    bool over_ = false;
    std::thread worker_, watchdog_;
};

}  // namespace app::lsp
