#include "render/app/farm/job.h"

#include "render/app/options/command_line.h"
#include "render/app/options/ini_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace app {
namespace {

int count_of(const char* name, const std::string& value, int most)
{
    int number = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
    if (error != std::errc() || end != value.data() + value.size() || number < 1 || number > most)
        throw OptionError(fmt::format("{} wants a number from 1 to {}, found '{}'", name, most, value));
    return number;
}

}  // namespace

bool take_word_value(const std::vector<std::string>& arguments, std::size_t& i, const char* name, std::string& value)
{
    const std::string& word = arguments[i];
    const std::string with_sign = std::string(name) + "=";
    if (word.starts_with(with_sign)) value = word.substr(with_sign.size());
    else if (word == name && i + 1 < arguments.size()) value = arguments[++i];
    else return false;
    return true;
}

bool take_job_word(const std::vector<std::string>& arguments, std::size_t& i, FarmJob& job)
{
    constexpr int kMostTasks = 100'000, kMostCores = 512;
    std::string value;
    if (take_word_value(arguments, i, "--tasks", value)) job.tasks = count_of("--tasks", value, kMostTasks);
    else if (take_word_value(arguments, i, "--cores", value)) job.cores = count_of("--cores", value, kMostCores);
    else if (take_word_value(arguments, i, "--from", value)) job.from = value;
    else return false;
    return true;
}

void complete(FarmJob& job, std::vector<std::string> words)
{
    job.words = std::move(words);
    read_default_ini_file(job.settings);
    apply_command_line(job.settings, job.words);
    if (job.settings.input_file.empty())
        throw OptionError("no scene given: whittle plan scene.pov, or whittle plan --help");
    if (job.settings.input_file == "-" || job.settings.output_file == "-")
        throw OptionError("many tasks read one scene and write many pictures: neither can be a stream");
    job.list = frames_of(job.settings);
    constexpr int kUsualTasks = 200, kUsualParts = 16;
    const int frames = static_cast<int>(job.list.frames.size());
    if (job.tasks == 0) job.tasks = job.list.animation ? kUsualTasks : kUsualParts;
    if (job.list.animation) job.tasks = std::min(job.tasks, frames);
}

std::string renderer_program()
{
    const char* const calling = std::getenv("WHITTLE_PROGRAM");  // main.cpp sets it for the tools
    return calling != nullptr && *calling != '\0' ? calling : "whittle";
}

}  // namespace app
