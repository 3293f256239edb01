#pragma once

#include "python/binding/job.h"
#include "python/binding/picture.h"
#include "parser/parse.h"
#include "render/app/options/settings.h"

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace python {

/// What a picture is asked for with.
struct Words {
    std::vector<std::string> options;  ///< arguments of a command line
    std::vector<std::string> exact;    ///< words that are not parted at blanks; they come after
};

/// What the words ask for, after the INI file that applies without being named. Throws app::OptionError.
app::Settings settings_of(const Words& words);

/// A scene's text, read when it is first asked for, and again only where what it was read with has changed and it may
/// have looked at that.
class Source {
public:
    /// \param text  of the scene; unset: that of the file which the settings name
    explicit Source(std::optional<std::string> text) : text_(std::move(text)) {}

    using Read = std::shared_ptr<const parser::Result>;
    /// May be asked from any thread. Throws scene::Error, parser::Cancelled.
    Read read(const app::Settings& settings, const std::atomic<bool>& cancel);
    const std::optional<std::string>& text() const { return text_; }
    /// Of a file that messages name; empty where it cannot be read.
    std::string text_of(const std::string& file) const;

private:
    /// What a scene may look at, as text: its words, and what they are found by.
    struct Looks {
        std::string always, size, clock;
    };
    static Looks looks_of(const parser::Options& options);
    bool still_right(const Looks& looks) const;
    bool mentions(std::initializer_list<std::string_view> words) const;

    const std::optional<std::string> text_;
    std::mutex mutex_;
    Looks looks_;
    Read read_;
    bool looks_at_size_ = true, looks_at_clock_ = true;
};

/// What a picture of a scene is asked for.
struct Request {
    Words words;
    std::optional<std::string> camera;  ///< text of a camera block in the place of the scene's own
    std::string layers;                 ///< of --aov; empty: none
    /// Shown what there is of the picture, with the interpreter held.
    std::function<void(std::shared_ptr<Picture>)> preview;
};

std::shared_ptr<Picture> render(const std::shared_ptr<Source>& source, Request request);

}  // namespace python
