#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace app {

/// Tells of saves: a file of a list that was written and closed, or that another was renamed to. Watches folders, since
/// most editors write a new file and put it in the old one's place.
class Saves {
public:
    /// \param saved is called from a thread of this object's own, once for what comes within some milliseconds.
    /// Throws std::runtime_error where the system has no watches left.
    explicit Saves(std::function<void()> saved);
    Saves(const Saves&) = delete;
    Saves& operator=(const Saves&) = delete;
    ~Saves();

    /// Replaces the list.
    /// \param any  a file with any name in the folders of the list counts: one of them may be missing
    void follow(const std::vector<std::string>& files, bool any);

private:
    void run();
    bool take_events();

    const std::function<void()> saved_;
    int watch_ = -1, ending_ = -1;  ///< descriptors
    std::mutex mutex_;
    std::map<int, std::string> folders_;  ///< by watch
    std::set<std::string> files_;         ///< whole paths
    bool any_ = false;
    std::thread thread_;
};

}  // namespace app
