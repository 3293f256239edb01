#pragma once

#include "render/app/options/settings.h"

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// What a piece of text is about; each kind can be turned off on the console and kept in a file (spec 1, 19.3).
enum class Stream {
    Lines,      ///< what other programs look for: [Parsing...], POV-Ray finished
    Debug,      ///< #debug of a scene, as written
    Fatal,      ///< errors
    Render,     ///< what will be done, and notes
    Statistic,  ///< counts and times
    Warning,    ///< warnings
};

/// Where the program's text goes: standard error, as far as the options let it, and the files of +GA, +GD, ...
/// When standard error is no terminal, or one of another encoding than UTF-8, characters beyond ASCII become '?':
/// readers decode it as ASCII.
class Streams {
public:
    explicit Streams(const Settings& settings);

    /// Opens the files that the options ask for in the folder of the picture. Throws OptionError for a name with a
    /// folder, or one that cannot be written.
    void open_files(const Settings& settings, const std::string& folder);

    void put(Stream stream, std::string_view text);

    bool terminal() const { return terminal_; }

private:
    struct File {
        bool all;  ///< +GA: of every stream
        Stream stream;
        std::unique_ptr<std::FILE, int (*)(std::FILE*)> to;
    };
    bool shown(Stream stream) const;

    const bool terminal_, shows_utf8_;
    bool quiet_, lines_, debug_, fatal_, render_, statistic_, warning_;
    std::vector<File> files_;
};

/// UTF-8 with one '?' for each character beyond ASCII.
std::string as_ascii(std::string_view text);

}  // namespace app
