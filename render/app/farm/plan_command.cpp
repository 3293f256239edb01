#include "render/app/farm/plan_command.h"

#include "render/app/farm/job_plan.h"

#include <fmt/format.h>

namespace app {
namespace {

constexpr const char* kPlanUsage =
    R"(usage: whittle plan SCENE [--tasks=N] [--cores=N] [--json] [--from=FOLDER] [options]

What a picture or an animation costs on many machines: tasks with cores, MiB and seconds each, their sum, the critical path, and how
far off that may be. It renders small pictures, of an animation every k-th frame.

  --tasks=N      at most; usual: 200 of an animation, 16 parts of a still
  --cores=N      of each task; usual: 1
  --from=FOLDER  go by the --json files of tasks that are finished instead
  --json         the plan as JSON

All else is as for a render: +W +H +A, +KFF, --frames=LIST, INI files. Seconds are those of this machine's processors.
Exit status: as for a render (docs/farm.md).
)";

}  // namespace

std::string plan_help() { return kPlanUsage; }

int plan_command(const std::vector<std::string>& arguments, Cancellation& cancel)
{
    FarmJob job;
    bool as_json = false;
    std::vector<std::string> others;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (arguments[i] == "--json") as_json = true;
        else if (!take_job_word(arguments, i, job)) others.push_back(arguments[i]);
    }
    complete(job, std::move(others));
    const JobEstimate estimate = estimate_job(job, cancel);
    if (estimate.frames.empty()) return kCancelled;
    const JobPlan plan = plan_of(job, estimate);
    fmt::print("{}", as_json ? plan_json(job, plan) : plan_text(job, plan));
    return kSuccess;
}

}  // namespace app
