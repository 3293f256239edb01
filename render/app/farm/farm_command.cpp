#include "render/app/farm/farm_command.h"

#include "render/app/farm/engines.h"
#include "render/app/output/output_name.h"
#include "render/app/output/whole_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace app {
namespace {

constexpr const char* kFarmUsage =
    R"(usage: whittle farm SCENE --for=slurm|openjd|make|shell [--tasks=N] [--cores=N] [-o FOLDER] [--movie=FILE] [options]

Writes a folder that renders the scene on many machines: the tasks, a script a kind of them, what the engine reads, the plan, a README.
`bash FOLDER/submit` hands it in: what is needed once, the tasks, the joining, each after the one before. The files can be read and changed.

  --for=ENGINE   slurm: jobs of sbatch; openjd: a template of Open Job Description; make: a Makefile; shell: xargs, over ssh too
  --tasks=N      at most; usual: 200 of an animation, 16 parts of a still
  --cores=N      of each task; usual: 1
  --from=FOLDER  costs by the --json files of tasks that are finished
  -o FOLDER      usual: the picture's name with .farm
  --movie=FILE   join the frames to a film: .png (APNG), .gif, .mp4, .webm

All else is as for a render. The renderer of the scripts is this one, or that of the variable WHITTLE.
Exit status: as for a render (docs/farm.md).
)";

Engine engine_of(const std::string& name)
{
    constexpr std::string_view kNames[] = {"slurm", "openjd", "make", "shell"};
    const auto* const found = std::find(std::begin(kNames), std::end(kNames), name);
    if (found == std::end(kNames)) throw OptionError("--for wants slurm, openjd, make or shell, found '" + name + "'");
    return static_cast<Engine>(found - std::begin(kNames));
}

std::string usual_folder(const FarmJob& job)
{
    FrameList still = job.list;
    still.animation = false;
    const std::string picture = output_path(job.settings, still, job.list.frames.front());
    return std::filesystem::path(picture).replace_extension(".farm").string();
}

void write_folder(const std::string& path, const std::vector<FarmFile>& files)
{
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) throw OptionError(fmt::format("cannot make the folder '{}': {}", path, error.message()));
    for (const FarmFile& file : files) put_bytes(path + "/" + file.name, file.text);
}

}  // namespace

std::string farm_help() { return kFarmUsage; }

int farm_command(const std::vector<std::string>& arguments, Cancellation& cancel)
{
    FarmJob job;
    FarmFolder folder{};
    std::string engine, path;
    std::vector<std::string> others;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (take_word_value(arguments, i, "--for", engine) || take_word_value(arguments, i, "-o", path) ||
            take_word_value(arguments, i, "--movie", folder.movie) || take_job_word(arguments, i, job))
            continue;
        others.push_back(arguments[i]);
    }
    if (engine.empty())
        throw OptionError("for which engine? whittle farm scene.pov --for=slurm (or openjd, make, shell)");
    folder.engine = engine_of(engine);
    complete(job, std::move(others));
    if (!folder.movie.empty() && !job.list.animation) throw OptionError("--movie is for an animation");
    const JobEstimate estimate = estimate_job(job, cancel);
    if (estimate.frames.empty()) return kCancelled;
    const JobPlan plan = plan_of(job, estimate);
    folder.path = std::filesystem::absolute(path.empty() ? usual_folder(job) : path).lexically_normal().string();
    write_folder(folder.path, farm_files(job, plan, folder));
    fmt::print("bash {}/submit\n", folder.path);
    return kSuccess;
}

}  // namespace app
