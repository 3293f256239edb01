#include "render/app/lsp/reading.h"

#include "parser/parse.h"
#include "render/app/run/scene_file.h"
#include "render/app/run/scene_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <malloc.h>
#include <unistd.h>

namespace app::lsp {
namespace {

/// Bytes that the program has in memory now.
std::size_t resident()
{
    unsigned long all = 0, here = 0;
    if (std::FILE* const file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%lu %lu", &all, &here) != 2) here = 0;
        std::fclose(file);
    }
    return here * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void keep_note(void* context, const parser::Message& message)
{
    if (message.severity == parser::Severity::Note) *static_cast<parser::Message*>(context) = message;
}

}  // namespace

Reader::Reader(const Settings& settings, const Limits& limits, std::function<void(Reading&&)> done)
    : settings_(settings), limits_(limits), done_(std::move(done)), worker_([this] { work(); }),
      watchdog_([this] { watch(); })
{}

void Reader::stop()
{
    {
        const std::lock_guard lock(mutex_);
        over_ = true;
        waiting_.clear();
        interrupt(Stop::Newer);
    }
    changed_.notify_all();
    if (worker_.joinable()) worker_.join();
    if (watchdog_.joinable()) watchdog_.join();
}

void Reader::interrupt(Stop why)
{
    if (!running_ || why_ != Stop::No) return;
    why_ = why;
    cancel_ = true;
}

std::uint64_t Reader::ask(const std::string& scene, std::shared_ptr<const Texts> texts)
{
    std::uint64_t number = 0;
    {
        const std::lock_guard lock(mutex_);
        std::erase_if(waiting_, [&](const Job& job) { return job.scene == scene; });
        number = ++asked_;
        waiting_.push_front({scene, std::move(texts), number});
        // What another scene had begun is begun again behind this one.
        if (running_ && running_->scene != scene && why_ == Stop::No) waiting_.push_back(*running_);
        interrupt(Stop::Newer);
    }
    changed_.notify_all();
    return number;
}

void Reader::forget(const std::string& scene)
{
    const std::lock_guard lock(mutex_);
    std::erase_if(waiting_, [&](const Job& job) { return job.scene == scene; });
    if (running_ && running_->scene == scene) interrupt(Stop::Newer);
}

void Reader::work()
{
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return over_ || !waiting_.empty(); });
        if (over_) return;
        running_ = std::move(waiting_.front());
        waiting_.pop_front();
        why_ = Stop::No;
        cancel_ = false;
        since_ = std::chrono::steady_clock::now();
        before_ = resident();
        lock.unlock();
        changed_.notify_all();
        Reading reading;
        const bool current = read(*running_, reading);
        lock.lock();
        const bool wanted = current && why_ != Stop::Newer;
        running_.reset();
        if (!wanted) continue;
        lock.unlock();
        done_(std::move(reading));
        lock.lock();
    }
}

/// Looks at time and memory of what runs.
void Reader::watch()
{
    constexpr auto kPause = std::chrono::milliseconds(20);
    std::unique_lock lock(mutex_);
    while (!over_) {
        if (!running_) {
            changed_.wait(lock, [this] { return over_ || running_; });
            continue;
        }
        changed_.wait_for(lock, kPause, [this] { return over_; });
        if (!running_) continue;
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - since_;
        if (passed.count() > limits_.seconds) interrupt(Stop::Time);
        else if (resident() > before_ + limits_.memory) interrupt(Stop::Memory);
    }
}

void Reader::cut_short(Reading& reading, const scene::Message& at, Stop why, const lint::Reader& texts)
{
    for (lint::Finding& found : lint::check_text(reading.scene, {}, texts, limits_.lint))
        if (found.check == "endless-loop") reading.told.push_back({found.message, std::string(found.check)});
    lint::Finding found = lint::endless_loop(at, limits_.seconds);
    if (why == Stop::Memory)
        found.message.text =
            fmt::format("reading was stopped here for it took more than {} MB: does this loop end? [endless-loop]",
                        limits_.memory >> 20);
    if (found.message.place.path.empty()) found.message.place = {reading.scene, {1, 1}};
    reading.told.push_back({found.message, std::string(found.check)});
    ::malloc_trim(0);
}

/// False: it was stopped for newer text.
bool Reader::read(const Job& job, Reading& reading)
{
    reading.scene = job.scene;
    reading.number = job.number;
    scene::Message stopped;
    const lint::Reader texts = [&](const std::string& path) -> std::optional<std::string> {
        const auto open = job.texts->find(path);
        return open != job.texts->end() ? open->second : text_on_disk(path);
    };
    const auto add = [&](std::vector<lint::Finding> findings) {
        for (lint::Finding& one : findings) reading.told.push_back({std::move(one.message), std::string(one.check)});
    };
    try {
        SceneReading how(settings_, cancel_);
        how.options.texts = job.texts.get();
        how.options.tell_values = true;
        parser::Result result = parser::parse_file(job.scene, how.options, keep_note, &stopped);
        for (scene::Message& message : result.messages) {
            const std::string check(message.check);
            if (check.empty() || limits_.lint.wants(check)) reading.told.push_back({std::move(message), check});
        }
        reading.values = std::move(result.values);
        reading.whole = true;
        add(lint::check_text(job.scene, result.scene.files, texts, limits_.lint));
        if (!cancel_) add(lint::check_scene(result.scene, texts, limits_.lint, false));
    } catch (const parser::Cancelled&) {
        if (why_ == Stop::Newer) return false;
        cut_short(reading, stopped, why_, texts);
    } catch (const scene::Error& error) {
        for (const scene::Message& message : error.messages()) reading.told.push_back({message, {}});
    } catch (const std::exception& error) {
        scene::Message message;
        message.text = error.what();
        message.place = {job.scene, {1, 1}};
        reading.told.push_back({std::move(message), {}});
    }
    return true;
}

}  // namespace app::lsp
