#include "render/app/watch/event_log.h"

#include <fmt/format.h>

#include <array>
#include <chrono>

namespace app {
namespace {

constexpr std::size_t kMostAtOnce = 262144;  // bytes a read: a client that is slow holds no more
constexpr auto kWait = std::chrono::seconds(1);
constexpr std::array kEventNames = {"text",     "scene", "controls", "messages", "block",
                                    "progress", "done",  "compared", "focus"};

}  // namespace

template <class Test>
void EventLog::drop(Test&& test)
{
    for (auto at = entries_.begin(); at != entries_.end();) {
        if (!test(at->second)) {
            ++at;
            continue;
        }
        bytes_ -= at->second.text->size();
        at = entries_.erase(at);
    }
}

void EventLog::push(Kind kind, const std::string& json, int generation, int pass)
{
    auto text = std::make_shared<const std::string>(
        fmt::format("event: {}\ndata: {}\n\n", kEventNames[static_cast<std::size_t>(kind)], json));
    const std::lock_guard lock(mutex_);
    if (kind != Kind::Block) {
        drop([&](const Entry& e) { return e.kind == kind && (kind != Kind::Scene || e.generation != shown_); });
    } else if (generation < shown_) {
        return;
    } else if (generation > shown_) {
        shown_ = generation;  // until its first block is there, the picture before stays
        drop([&](const Entry& e) {
            return e.kind == Kind::Block || (e.kind == Kind::Scene && e.generation < generation);
        });
    }
    bytes_ += text->size();
    entries_.emplace(++last_, Entry{kind, generation, pass, std::move(text)});
    changed_.notify_all();
}

void EventLog::passed(int generation, int pass)
{
    const std::lock_guard lock(mutex_);
    drop([&](const Entry& e) { return e.kind == Kind::Block && e.generation == generation && e.pass < pass; });
}

bool EventLog::read(std::uint64_t& position, std::string& out)
{
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, kWait, [&] { return closed_ || last_ > position; });
    for (auto at = entries_.upper_bound(position); at != entries_.end() && out.size() < kMostAtOnce; ++at) {
        out += *at->second.text;
        position = at->first;
    }
    return !closed_;
}

void EventLog::close()
{
    const std::lock_guard lock(mutex_);
    closed_ = true;
    changed_.notify_all();
}

std::size_t EventLog::bytes() const
{
    const std::lock_guard lock(mutex_);
    return bytes_;
}

}  // namespace app
