#include "render/app/editor/fmt_command.h"

#include "language/format/format.h"
#include "render/app/editor/replace_file.h"
#include "render/app/options/settings.h"
#include "render/app/run/cancellation.h"
#include "render/scene/base/line_table.h"
#include "render/scene/base/message.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>

namespace app {
namespace {

constexpr const char* kFmtUsage =
    R"(usage: whittle fmt FILE... [--check | --stdout] [--indent=N] [--tabs] [--width=N]
       whittle fmt - < FILE

Lays scene text out: blanks, indentation, long lines. Tokens and comments stay what they are, so pictures do. Files are replaced
as a whole or not at all. Between the comments `// format off` and `// format on` everything stays as it was written.
Exit status: 0 done, 1 a file could not be read, laid out or written, or --check found one that is not laid out.

  -             standard input, laid out to standard output
  --check       change nothing; tell which files would change
  --stdout      print what would be written
  --indent=N    columns of a level, 1 to 16; usual: 2
  --tabs        a tab for each level, as wide as --indent says
  --width=N     columns of a line, 40 to 1000; usual: 120
)";

struct FmtRequest {
    std::vector<std::string> files;
    bool check = false, print = false;
    language::format::Options layout;
};

int fmt_number(const std::string& word, int least, int most)
{
    const std::string_view value = std::string_view(word).substr(word.find('=') + 1);
    int number = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error != std::errc() || end != value.data() + value.size() || number < least || number > most)
        throw OptionError(fmt::format("{} wants a number from {} to {}, found '{}'", word.substr(0, word.find('=')),
                                      least, most, value));
    return number;
}

FmtRequest fmt_request(const std::vector<std::string>& arguments)
{
    FmtRequest request;
    bool options = true;
    for (const std::string& word : arguments) {
        if (!options || word == "-" || !word.starts_with("-")) request.files.push_back(word);
        else if (word == "--") options = false;
        else if (word == "--check") request.check = true;
        else if (word == "--stdout") request.print = true;
        else if (word == "--tabs") request.layout.tabs = true;
        else if (word.starts_with("--indent=")) request.layout.indent = fmt_number(word, 1, 16);
        else if (word.starts_with("--width=")) request.layout.width = fmt_number(word, 40, 1000);
        else throw OptionError("unknown option '" + word + "' of whittle fmt");
    }
    if (request.files.empty()) throw OptionError("fmt wants files: whittle fmt FILE... [--check | --stdout]");
    return request;
}

/// Returns whether all is well.
bool lay_out(const std::string& path, const FmtRequest& request)
{
    const std::string text = whole_file(path);
    std::string out;
    try {
        out = language::format::formatted(text, request.layout);
    } catch (const language::format::Refused& refused) {
        const scene::LineTable lines{text};
        throw scene::Error({path == "-" ? "standard input" : path, lines.place(refused.offset)}, refused.what());
    }
    if (request.check) {
        if (out != text) fmt::print("{}\n", path);
        return out == text;
    }
    if (request.print || path == "-") std::fwrite(out.data(), 1, out.size(), stdout);
    else if (out != text) replace_file(path, out);
    return true;
}

}  // namespace

std::string fmt_help() { return kFmtUsage; }

int fmt_command(const std::vector<std::string>& arguments)
{
    const FmtRequest request = fmt_request(arguments);
    int status = kSuccess;
    for (const std::string& path : request.files) {
        try {
            if (!lay_out(path, request)) status = kError;
        } catch (const scene::Error& error) {
            fmt::print(stderr, "{}\n", error.what());
            status = kError;
        } catch (const std::exception& error) {
            fmt::print(stderr, "whittle: error: {}\n", error.what());
            status = kError;
        }
    }
    return status;
}

}  // namespace app
