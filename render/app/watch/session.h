#pragma once

#include "parser/parse.h"
#include "render/app/options/settings.h"
#include "render/app/watch/event_log.h"
#include "render/app/watch/comparison.h"
#include "render/app/watch/gallery.h"
#include "render/app/watch/saves.h"
#include "render/app/watch/place/spotlight.h"
#include "render/app/watch/view.h"
#include "render/image/files.h"
#include "render/web/web.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>

namespace app {

/// One scene being watched: a thread reads and traces it, whoever asks for another picture cancels that.
class Session final : public web::Host {
public:
    /// \param reference, povray see Comparison
    Session(const Settings& settings, const std::string& reference, const std::string& povray);
    ~Session() override;

    web::Reply answer(bool posted, const std::string& path, const std::string& body) override;
    bool events(std::uint64_t& position, std::string& out) override { return events_.read(position, out); }

private:
    enum class Cause { Save, View };
    using Parsed = std::shared_ptr<const parser::Result>;
    void ask(Cause cause);
    void run();
    void make(const View& view, Cause cause);
    void render(const View& view, Cause cause);
    void read(const View& view, const Settings& settings);
    std::map<std::string, std::string> edited_texts(const View& view) const;
    void follow(bool wrong, const std::vector<scene::Message>& messages);
    Settings settings_for(const View& view) const;
    web::Reply change(const std::string& body);
    web::Reply compare(const std::string& body);
    web::Reply open(const std::string& body);
    std::string scene_wanted();
    web::Reply pixel(const std::string& query);

    const Settings settings_;
    EventLog events_;
    Comparison comparison_;

    std::mutex mutex_;
    std::condition_variable asked_;
    View view_;
    std::string wanted_scene_;  ///< its path
    std::optional<Cause> waiting_;
    bool ending_ = false;
    std::atomic<bool> cancel_ = false;
    std::shared_ptr<const Looked> looked_;  ///< null: there was no picture yet
    std::mutex explaining_;                 ///< one pixel at a time
    std::atomic<bool> ending_early_ = false;
    Spotlight spotlight_;
    Gallery gallery_;

    // The job thread's own.
    std::string scene_;
    int generation_ = 0;
    Parsed parsed_;   ///< of the text as it was last right
    View read_with_;  ///< its clock and constants
    bool wrong_ = false;
    bool unread_ = true;              ///< a save came since, or its reading was cancelled
    double full_pass_ = 0;            ///< seconds that the pass of all pixels took last; 0: there was none
    std::int64_t read_at_ = 0;        ///< when the text was last begun to be read, milliseconds since 1970
    std::vector<std::string> files_;  ///< that were read last
    std::vector<scene::Message> told_;

    std::thread thread_;
    Saves saves_;  ///< last: it calls
};

}  // namespace app
