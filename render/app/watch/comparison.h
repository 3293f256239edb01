#pragma once

#include "render/app/options/settings.h"
#include "render/app/watch/event_log.h"

#include <atomic>
#include <mutex>
#include <string>
#include <thread>

namespace app {

/// Pictures of the same scene to compare with, told as events: one that was given, and POV-Ray's own, made in a folder
/// of its own that is removed afterwards. One at a time.
class Comparison {
public:
    /// \param reference  path of a picture; empty: none
    /// \param povray  program; empty: none
    Comparison(EventLog& events, std::string reference, std::string povray)
        : events_(events), reference_(std::move(reference)), povray_(std::move(povray))
    {}
    Comparison(const Comparison&) = delete;
    Comparison& operator=(const Comparison&) = delete;
    ~Comparison();

    void show_reference();
    /// \param scene  its path
    /// \param settings  what POV-Ray understands of them goes on its command line
    void run_povray(const std::string& scene, const Settings& settings);

private:
    void show(const std::string& with, const std::string& path);
    void refuse(const std::string& with, const std::string& why);
    void render(const std::string& scene, const Settings& settings);
    void stop();
    EventLog& events_;
    const std::string reference_, povray_;
    std::mutex mutex_;  ///< of the thread
    std::thread thread_;
    std::atomic<bool> ending_ = false;
};

}  // namespace app
