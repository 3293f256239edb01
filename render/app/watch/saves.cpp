#include "render/app/watch/saves.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr int kSettleMilliseconds = 3;  // several files of one save
constexpr std::uint32_t kEvents = IN_CLOSE_WRITE | IN_MOVED_TO | IN_ONLYDIR;

/// The path as written, and where its links lead.
std::set<std::string> names_of(const std::string& file)
{
    std::set<std::string> names{fs::absolute(file).lexically_normal().string()};
    std::error_code error;
    const fs::path real = fs::canonical(file, error);
    if (!error) names.insert(real.string());
    return names;
}

}  // namespace

Saves::Saves(std::function<void()> saved)
    : saved_(std::move(saved)), watch_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)), ending_(eventfd(0, EFD_CLOEXEC))
{
    if (watch_ < 0 || ending_ < 0) throw std::runtime_error(std::string("cannot watch files: ") + std::strerror(errno));
    thread_ = std::thread([this] { run(); });
}

Saves::~Saves()
{
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = write(ending_, &one, sizeof one);
    thread_.join();
    close(watch_);
    close(ending_);
}

void Saves::follow(const std::vector<std::string>& files, bool any)
{
    const std::lock_guard lock(mutex_);
    any_ = any;
    files_.clear();
    std::set<std::string> wanted;
    for (const std::string& file : files)
        for (const std::string& name : names_of(file)) {
            files_.insert(name);
            wanted.insert(fs::path(name).parent_path().string());
        }
    std::map<int, std::string> now;
    for (const std::string& folder : wanted) {
        const int watch = inotify_add_watch(watch_, folder.c_str(), kEvents);
        if (watch >= 0) now.emplace(watch, folder);
    }
    for (const auto& [watch, folder] : folders_)
        if (!now.contains(watch)) inotify_rm_watch(watch_, watch);
    folders_ = std::move(now);
}

/// Reads what has come. True: a save is among it.
bool Saves::take_events()
{
    alignas(inotify_event) std::array<char, 16384> bytes;
    bool found = false;
    for (ssize_t count; (count = read(watch_, bytes.data(), bytes.size())) > 0;) {
        const std::lock_guard lock(mutex_);
        for (const char* at = bytes.data(); at < bytes.data() + count;) {
            inotify_event event{};
            std::memcpy(&event, at, sizeof event);
            const std::string name = event.len > 0 ? at + sizeof event : "";
            at += sizeof event + event.len;
            if (event.mask & IN_Q_OVERFLOW) found = true;  // some are lost: one of them may have been a save
            const auto folder = folders_.find(event.wd);
            if (folder == folders_.end() || !(event.mask & (IN_CLOSE_WRITE | IN_MOVED_TO))) continue;
            found = found || any_ || files_.contains((fs::path(folder->second) / name).string());
        }
    }
    return found;
}

void Saves::run()
{
    std::array<pollfd, 2> waiting{pollfd{watch_, POLLIN, 0}, pollfd{ending_, POLLIN, 0}};
    while (poll(waiting.data(), waiting.size(), -1) >= 0 || errno == EINTR) {
        if (waiting[1].revents != 0) return;
        bool saved = take_events();
        while (saved && poll(waiting.data(), waiting.size(), kSettleMilliseconds) > 0 && waiting[1].revents == 0)
            take_events();
        if (saved) saved_();
    }
}

}  // namespace app
