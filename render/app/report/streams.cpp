#include "render/app/report/streams.h"

#include "render/app/base/text.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace app {

namespace {

struct FileOption {
    std::string Settings::*name;
    bool all;
    Stream stream;
    const char* usual;  ///< the name that a plain "true" means
};

constexpr FileOption kFileOptions[] = {
    {&Settings::all_file, true, Stream::Lines, "alltext.out"},
    {&Settings::debug_file, false, Stream::Debug, "debug.out"},
    {&Settings::fatal_file, false, Stream::Fatal, "fatal.out"},
    {&Settings::render_file, false, Stream::Render, "render.out"},
    {&Settings::statistic_file, false, Stream::Statistic, "stats.out"},
    {&Settings::warning_file, false, Stream::Warning, "warning.out"},
};

bool is_any_of(std::string_view text, std::initializer_list<const char*> words)
{
    for (const char* word : words)
        if (same_text(text, word)) return true;
    return false;
}

/// The file that an option's value names: "" for none.
std::string file_name(const std::string& value, const char* usual)
{
    if (value.empty() || is_any_of(value, {"off", "false", "no", "0"})) return {};
    if (is_any_of(value, {"on", "true", "yes", "1"})) return usual;
    return value;
}

/// As the environment says: the first of the three that is set.
bool locale_is_utf8()
{
    for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
        const char* value = std::getenv(name);
        if (!value || !*value) continue;
        std::string text(value);
        for (char& c : text) c = lower_case(c);
        return text.find("utf-8") != std::string::npos || text.find("utf8") != std::string::npos;
    }
    return false;
}

}  // namespace

std::string as_ascii(std::string_view text)
{
    std::string plain;
    plain.reserve(text.size());
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) plain += c;
        else if (byte >= 0xC0) plain += '?';  // the bytes that continue a character are dropped
        else if (plain.empty() || plain.back() != '?') plain += '?';
    }
    return plain;
}

Streams::Streams(const Settings& s)
    : terminal_(isatty(STDERR_FILENO) != 0), shows_utf8_(locale_is_utf8()), quiet_(s.quiet), lines_(true),
      debug_(s.all_console.value_or(s.debug_console)), fatal_(s.all_console.value_or(s.fatal_console)),
      render_(s.all_console.value_or(s.render_console)), statistic_(s.all_console.value_or(s.statistic_console)),
      warning_(s.all_console.value_or(s.warning_console))
{}

void Streams::open_files(const Settings& settings, const std::string& folder)
{
    if (!files_.empty()) return;  // the frames of an animation share them
    for (const FileOption& option : kFileOptions) {
        const std::string name = file_name(settings.*option.name, option.usual);
        if (name.empty()) continue;
        if (name.find('/') != std::string::npos)
            throw OptionError("a text file stands in the folder of the picture: '" + name + "' must not name another");
        const std::string path = folder.empty() ? name : folder + "/" + name;
        const bool append = settings.append_file || settings.continue_trace;
        std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), append ? "ab" : "wb"),
                                                             std::fclose);
        if (!file) throw OptionError("cannot write '" + path + "': " + std::strerror(errno));
        files_.push_back({option.all, option.stream, std::move(file)});
    }
}

bool Streams::shown(Stream stream) const
{
    if (quiet_) return stream == Stream::Fatal;
    switch (stream) {
    case Stream::Lines: return lines_;
    case Stream::Debug: return debug_;
    case Stream::Fatal: return fatal_;
    case Stream::Render: return render_;
    case Stream::Statistic: return statistic_;
    case Stream::Warning: return warning_;
    }
    return true;
}

void Streams::put(Stream stream, std::string_view text)
{
    for (const File& file : files_) {
        if (!file.all && file.stream != stream) continue;
        std::fwrite(text.data(), 1, text.size(), file.to.get());
        std::fflush(file.to.get());
    }
    if (!shown(stream)) return;
    const std::string plain = terminal_ && shows_utf8_ ? std::string(text) : as_ascii(text);
    std::fwrite(plain.data(), 1, plain.size(), stderr);
    std::fflush(stderr);
}

}  // namespace app
