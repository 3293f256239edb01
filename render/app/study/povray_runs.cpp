#include "render/app/study/povray_runs.h"

#include "render/app/base/text.h"
#include "render/app/output/scratch_folder.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <cstdlib>

namespace app {
namespace {

/// What a command prints, both streams. False: it failed.
bool output_of(const std::string& command, std::string& out)
{
    std::FILE* const pipe = popen((command + " 2>&1 </dev/null").c_str(), "r");
    if (pipe == nullptr) return false;
    std::array<char, 4096> block;
    for (std::size_t n; (n = std::fread(block.data(), 1, block.size(), pipe)) > 0;) out.append(block.data(), n);
    return pclose(pipe) == 0;
}

}  // namespace

std::optional<double> povray_seconds(const std::string& text)
{
    std::optional<double> all;
    for (const char* stage : {"Photon Time:", "Radiosity Time:", "Trace Time:"}) {
        const std::size_t at = text.find(stage);
        if (at == std::string::npos) continue;
        const std::size_t end = text.find('\n', at), open = text.find('(', at);
        if (open == std::string::npos || open > end) continue;  // "No photons"
        char* stop = nullptr;
        const double seconds = std::strtod(text.c_str() + open + 1, &stop);
        if (std::string_view(stop).starts_with(" seconds")) all = all.value_or(0.0) + seconds;
    }
    return all;
}

PovrayRuns::PovrayRuns(const std::string& program) : program_(program)
{
    std::string told;
    if (program.empty() || !output_of(shell_word(program) + " --version", told)) return;
    // Whittle under POV-Ray's name says so.
    const std::size_t at = told.find("POV-Ray 3.");
    if (at == std::string::npos || told.find("hittle") != std::string::npos) return;
    version_ = told.substr(at, told.find('\n', at) - at);
}

std::optional<PovrayRuns::Found> PovrayRuns::render(const std::string& scene, const std::vector<std::string>& switches,
                                                    const image::Files& files, double longest) const
{
    if (!found()) return {};
    const ScratchFolder scratch;
    const std::string picture = scratch / "a.png";
    std::string command = fmt::format("timeout {:g} {} {} {} +FN16 -D -P -GD", longest, shell_word(program_),
                                      shell_word("+I" + scene), shell_word("+O" + picture));
    for (const std::string& word : switches) command += ' ' + shell_word(word);
    std::string told;
    if (!output_of(command, told)) return {};
    const std::optional<double> seconds = povray_seconds(told);
    if (!seconds) return {};
    try {
        const image::Picture read = files.read(picture);
        Found out;
        out.seconds = *seconds;
        out.picture.width = read.width;
        out.picture.height = read.height;
        for (int y = 0; y < read.height; ++y)
            for (int x = 0; x < read.width; ++x)
                for (std::size_t c = 0; c < 3; ++c)
                    out.picture.values.push_back(read.at(x, y)[read.channels < 3 ? 0 : c]);
        return out;
    } catch (const image::FileError&) {
        return {};
    }
}

}  // namespace app
