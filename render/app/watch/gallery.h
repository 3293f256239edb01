#pragma once

#include "render/app/options/settings.h"
#include "render/web/web.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

namespace app {

/// The scenes of a folder, as small pictures without antialiasing. One is made at a time, and given up where it takes
/// long.
class Gallery {
public:
    explicit Gallery(const Settings& settings) : settings_(settings) {}

    /// \param shown  the scene that is watched now: its folder is meant
    web::Reply list(const std::string& shown) const;
    /// \param query  name=NAME, of the list
    web::Reply thumbnail(const std::string& shown, const std::string& query);
    /// The path of a name of the list; empty: it is none.
    static std::string path_of(const std::string& shown, const std::string& name);
    /// What is being made ends, and nothing is made after.
    void end();

private:
    const Settings settings_;
    std::mutex one_at_a_time_, mutex_;
    std::condition_variable done_;
    std::atomic<bool> cancel_ = false, ending_ = false;
};

}  // namespace app
