#include "render/app/farm/measure.h"

#include "render/app/base/text.h"
#include "render/app/frames/window.h"
#include "render/app/output/scratch_folder.h"
#include "render/files/whole_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace app {
namespace {

using Json = nlohmann::json;

std::string text_of_file(const std::string& path) { return files::whole_file_if(path).value_or(std::string()); }

double number_in(const Json& object, const char* name)
{
    const auto found = object.find(name);
    return found != object.end() && found->is_number() ? found->get<double>() : 0.0;
}

/// What a frame of a run's --json cost. False: it was not rendered to the end.
bool read_cost(const Json& frame, SizedCost& cost)
{
    const auto phases = frame.find("phases"), counts = frame.find("counts");
    if (phases == frame.end() || counts == frame.end() || !frame.value("picture", Json()).is_string()) return false;
    cost.reading = number_in(*phases, "parse_cpu_seconds") + number_in(*phases, "plan_cpu_seconds");
    cost.writing = number_in(*phases, "write_cpu_seconds");
    for (const Json& pass : frame.value("passes", Json::array())) cost.passes += number_in(pass, "cpu_seconds");
    cost.picture = std::max(0.0, number_in(*phases, "trace_cpu_seconds") - cost.passes);
    cost.supersamples = number_in(*counts, "supersamples");
    return true;
}

/// The window in shares of the picture, which do not change with its size.
std::string window_words(const Settings& settings)
{
    const Window w = window_of(settings);
    if (w.first_column == 0 && w.first_row == 0 && w.last_column + 1 == settings.width &&
        w.last_row + 1 == settings.height)
        return {};
    const auto share = [](int at, int of) { return static_cast<double>(at) / of; };
    return fmt::format(" +SC{:.6f} +EC{:.6f} +SR{:.6f} +ER{:.6f}", share(w.first_column, settings.width),
                       share(w.last_column + 1, settings.width), share(w.first_row, settings.height),
                       share(w.last_row + 1, settings.height));
}

}  // namespace

SizedCost measure_frame(const FarmJob& job, const Frame& frame, double scale, const Cancellation& cancel)
{
    const ScratchFolder scratch;
    const Settings& s = job.settings;
    const auto side = [&](int of) { return std::max(1, static_cast<int>(std::lround(of * scale))); };
    const int width = side(s.width), height = side(s.height);
    std::string command = "exec " + shell_word(renderer_program());
    for (const std::string& word : job.words) command += ' ' + shell_word(word);
    command += fmt::format(" +W{} +H{} +WT1 -C --quiet --console=whittle", width, height) + window_words(s);
    if (job.list.animation) command += fmt::format(" --frames={}", frame.number);
    command += " +O" + shell_word(scratch / "a") + " --json=" + shell_word(scratch / "a.json");
    const int status = std::system((command + " </dev/null >/dev/null 2>" + shell_word(scratch / "told")).c_str());
    if (cancel.requested) return {};
    if (status != 0)
        throw std::runtime_error("the renderer fails on a small picture: " + text_of_file(scratch / "told"));
    SizedCost cost;
    const Json told = Json::parse(text_of_file(scratch / "a.json"), nullptr, false);
    if (!told.is_object() || told.value("frames", Json::array()).size() != 1 || !read_cost(told["frames"][0], cost))
        throw std::runtime_error("the renderer says nothing of what it did");
    cost.pixels = static_cast<double>(width) * height;
    cost.memory = number_in(told, "peak_memory_bytes");
    cost.rest =
        std::max(0.0, number_in(told, "processor_seconds") - cost.reading - cost.passes - cost.picture - cost.writing);
    return cost;
}

std::map<int, FrameCost> finished_frames(const std::string& folder)
{
    std::error_code error;
    const std::filesystem::directory_iterator files(folder, error);
    if (error) throw OptionError(fmt::format("--from: cannot read the folder '{}': {}", folder, error.message()));
    std::map<int, FrameCost> found;
    for (const auto& entry : files) {
        if (entry.path().extension() != ".json") continue;
        const Json told = Json::parse(text_of_file(entry.path().string()), nullptr, false);
        if (!told.is_object()) continue;  // one that is being written
        for (const Json& frame : told.value("frames", Json::array())) {
            SizedCost cost;
            if (!frame.is_object() || !read_cost(frame, cost)) continue;
            found[static_cast<int>(number_in(frame, "number"))] = {
                cost.reading, cost.passes, cost.picture + cost.writing, number_in(told, "peak_memory_bytes")};
        }
    }
    return found;
}

}  // namespace app
