#include "render/app/run/written_journal.h"

#include "render/app/report/journal.h"
#include "render/app/report/streams.h"
#include "render/app/run/cancellation.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>

namespace app {

bool write_journal(const std::string& path, const std::string& text)
{
    if (path == "-") {
        fmt::print("{}", text);
        return true;
    }
    std::ofstream out(path, std::ios::binary);
    out << text;
    if (out.flush()) return true;
    fmt::print(stderr, "whittle: error: cannot write '{}': {}\n", path, std::strerror(errno));
    return false;
}

void journal_option_error(const Settings& settings, const std::string& text)
{
    if (settings.json_file.empty()) return;
    Streams streams(settings);
    const std::unique_ptr<ConsoleReporter> silent = make_reporter(settings, streams);
    Journal journal(streams, *silent, settings);
    journal.record_error(text);
    write_journal(settings.json_file, journal.text(kError));
}

}  // namespace app
