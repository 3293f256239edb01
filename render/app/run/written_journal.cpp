#include "render/app/run/written_journal.h"

#include "render/app/report/journal.h"
#include "render/app/report/progress_lines.h"
#include "render/app/report/streams.h"
#include "render/app/run/cancellation.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>

namespace app {

int write_journal(const std::string& path, const std::string& text)
{
    if (path == "-") {
        fmt::print("{}", text);
        return 0;
    }
    std::ofstream out(path, std::ios::binary);
    out << text;
    if (out.flush()) return 0;
    const int why = errno;
    fmt::print(stderr, "whittle: error: cannot write '{}': {}\n", path, std::strerror(why));
    return why != 0 ? why : EIO;
}

void journal_option_error(const Settings& settings, const std::string& text, int status)
{
    if (const std::string line = failure_line(settings.progress, text); !line.empty()) fmt::print(stderr, "{}\n", line);
    if (settings.json_file.empty()) return;
    Streams streams(settings);
    const std::unique_ptr<ConsoleReporter> silent = make_reporter(settings, streams);
    Journal journal(streams, *silent, settings);
    journal.record_error(text);
    write_journal(settings.json_file, journal.text(status));
}

}  // namespace app
