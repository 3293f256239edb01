#pragma once

#include "render/scene/description.h"
#include "render/scene/base/message.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace parser {

class SceneQueries;  // parser/base/queries.h

/// A macro, a loop or a file that is being read.
struct ReadingPlace {
    std::string what;   ///< "macro", "loop" or "file"
    std::string name;   ///< of the macro, "#while", path of the file
    std::string place;  ///< "path:line:column" of its body or its directive
};

/// What the command line tells the parser.
struct Options {
    std::vector<std::string> library_path;   ///< searched after the current folder and before the scene's, in order
    std::vector<std::string> write_folders;  ///< where #fopen may write, besides the current folder
    bool write_nothing = false;              ///< what #fopen would write is dropped
    bool restrict_read = false;  ///< files are read only where may_read() of parser/stream/files/file_policy.h says
    std::map<std::string, double> declared_numbers;  ///< Declare=name=value
    std::map<std::string, std::string> declared_strings;
    int version = 370;                    ///< before any #version
    bool version_given = false;           ///< by an option: gamma and the like follow it (spec 1, 15.1)
    std::optional<scene::PovRay> povray;  ///< --povray; unset: as the scene's #version says
    int image_width = 320, image_height = 240;
    double clock = 0.0;
    bool clock_on = false;
    int frame_number = 0, initial_frame = 0, final_frame = 0;
    double clock_delta = 0;
    double initial_clock = 0, final_clock = 0;
    std::string include_header;       ///< file to include ahead of the scene; empty: none
    SceneQueries* queries = nullptr;  ///< answers trace(), inside(), eval_pigment, ...; null: they are errors
    std::uint64_t most_tokens =
        0;               ///< a scene that has more read to it, loops and macros counted, is refused; 0: no limit
    bool blocks = true;  ///< loops and macros over numbers and texts are compiled; false: read word by word, for tests
    const std::map<std::string, std::string>* texts = nullptr;  ///< of an editor: they lie over the files on disk, by
                                                                ///< absolute path without "." and ".."
    bool tell_values = false;                                   ///< fills Result::values
    const std::atomic<bool>* cancel = nullptr;  ///< looked at now and then: when set, reading ends with Cancelled
    /// Called about five times a second while a text is read, from the fifth second on.
    std::function<void(const ReadingPlace& where, double seconds)> still_reading;
};

/// Thrown when Options::cancel asks for it.
struct Cancelled {};

using scene::Message;
using scene::Severity;

/// Thrown once for a scene that cannot be read: one message, or several where it was safe to go on behind a statement
/// with a mistake.
using scene::Error;

/// A place that time went to.
struct ReadingCost : ReadingPlace {
    double seconds = 0.0, own_seconds = 0.0;  ///< with what it calls, and without
};

struct Statistics {
    std::uint64_t files = 0, bytes = 0, tokens = 0, macro_calls = 0;
    std::vector<ReadingCost> costs;  ///< the ten that most time of reading went to, the most costly first
};

struct Result {
    scene::Description scene;
    std::vector<Message> messages;  ///< in order; without errors
    Statistics statistics;
    std::map<std::string, std::string>
        values;                           ///< global numbers, vectors and texts at the end, as the scene writes them
    std::vector<std::string> data_files;  ///< read besides the text: by #fopen, images, densities, fonts; in order
    /// What stood in scene.files and in data_files when they were read, not later (files::hash_of_text, hash_of_file).
    std::vector<std::uint64_t> text_hashes, data_hashes;
};

/// Called with each message as it arises (may be empty).
using MessageSink = void (*)(void* context, const Message&);

}  // namespace parser
