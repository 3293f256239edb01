#pragma once

#include "render/app/link/mailbox.h"
#include "render/app/options/settings.h"
#include "render/app/watch/place/lit_pixels.h"
#include "render/app/watch/place/number_edits.h"
#include "render/web/web.h"

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace app {

/// What a picture that pages show was made from.
struct Looked {
    int generation = 0;
    Settings settings;
    std::shared_ptr<const scene::Description> scene;
    std::map<std::string, NumberEdits> numbers;  ///< by file, absolute without "." and ".."
};

/// The place of the text that is looked at: told by an editor's cursor or a pixel of the picture, shown in both.
/// A thread of its own finds the pixels that see it.
class Spotlight {
public:
    using Newest = std::function<std::shared_ptr<const Looked>()>;
    using Told = std::function<void(const std::string& json)>;

    /// Both are called from threads of its own.
    /// \param newest  null: there is no picture yet
    /// \param told  takes what pages are told, of one line
    Spotlight(Newest newest, Told told);
    ~Spotlight();

    /// Another picture was made: the pixels may be others.
    void renew();
    /// The statement that a pixel sees: lit, and shown by editors that have its file.
    /// \param body  {"x": 3, "y": 4}
    web::Reply show(const std::string& body);
    /// The numbers of a file that pages have set go into the text of an editor that has it open.
    /// \param body  {"file": "..."}
    web::Reply write(const std::string& body);

private:
    struct Place {
        std::string file;  ///< absolute, without "." and ".."
        std::uint32_t offset = 0;
        std::optional<std::uint64_t> mark;  ///< of the text that an editor has
    };

    void run();
    void tell(const Place& place, const std::shared_ptr<const Looked>& looked);
    void point_at(Place place);
    void take(const std::string& text);
    std::shared_ptr<const SeenPixels> seen(const std::shared_ptr<const Looked>& looked);
    bool shown_in_editor(const std::string& message);

    const Newest newest_;
    const Told told_;
    std::mutex mutex_;
    std::condition_variable asked_, answered_;
    std::optional<Place> place_;
    bool waiting_ = false, renewed_ = false;
    std::size_t answers_ = 0;  ///< of editors, so far
    std::atomic<bool> ending_ = false;
    std::mutex seeing_;
    std::shared_ptr<const Looked> seen_of_;
    std::shared_ptr<const SeenPixels> seen_;
    std::thread thread_;
    Mailbox mailbox_;  ///< last: it calls
};

}  // namespace app
