#include "render/app/report/console_reporter.h"

#include "render/app/report/plain_reporter.h"
#include "render/app/report/povray_reporter.h"

#include <fmt/format.h>

namespace app {

std::unique_ptr<ConsoleReporter> make_reporter(const Settings& settings, Streams& streams)
{
    if (settings.console_style == ConsoleStyle::Povray)
        return std::make_unique<PovrayReporter>(streams, settings.verbose && !settings.quiet);
    return std::make_unique<PlainReporter>(streams, settings.verbose && !settings.quiet);
}

void tell_option_error(ConsoleStyle style, const std::string& command_line, const std::string& text)
{
    if (style == ConsoleStyle::Whittle)
        fmt::print(stderr, "{}{}\n", text.find("error:") == std::string::npos ? "whittle: error: " : "",
                   as_ascii(text));
    else fmt::print(stderr, "\nProblem with option setting\n{}\n{}\n", as_ascii(command_line), as_ascii(text));
}

}  // namespace app
