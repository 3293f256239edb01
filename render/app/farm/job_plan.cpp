#include "render/app/farm/job_plan.h"

#include "render/app/report/json_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

/// Of memory beyond what was seen: a frame that was not measured may take more.
constexpr double kReserve = 1.25, kLeastReserve = 64.0 * kMebibyte;
constexpr double kJoinStart = 0.05, kJoinPixel = 1e-7;  // seconds: to start, and to read and write a pixel

double task_seconds(const FarmJob& job, double reading, double traced) { return reading + traced / job.cores; }

void cut_frames(const FarmJob& job, const JobEstimate& estimate, JobPlan& plan)
{
    double whole = 0.0;
    for (const FrameCost& frame : estimate.frames) whole += frame.seconds();
    // A task ends where its share of the seconds does.
    const std::size_t count = estimate.frames.size();
    const std::size_t tasks = std::min(count, static_cast<std::size_t>(job.tasks));
    double so_far = 0.0;
    std::vector<int> numbers;
    FarmTask task;
    for (std::size_t i = 0; i < count; ++i) {
        const FrameCost& frame = estimate.frames[i];
        numbers.push_back(job.list.frames[i].number);
        so_far += frame.seconds();
        task.seconds += task_seconds(job, frame.reading, frame.passes + frame.picture);
        task.memory = std::max(task.memory, frame.memory);
        const std::size_t made = plan.tasks.size() + 1, left = count - i - 1;
        const double due = whole * static_cast<double>(made) / static_cast<double>(tasks);
        // Ends before the due place if the next frame would go farther beyond it, and where the tasks to come need all
        // frames that are left: seconds are measured, but the number of tasks is what was asked for.
        const double next = left > 0 ? 0.5 * estimate.frames[i + 1].seconds() : 0.0;
        if (left > 0 && left + made > tasks && so_far + next < due) continue;
        task.what = frames_text(numbers);
        plan.tasks.push_back(task);
        task = {};
        numbers.clear();
    }
}

void cut_still(const FarmJob& job, const FrameCost& still, JobPlan& plan)
{
    const auto parts = static_cast<double>(job.tasks);
    const bool once = still.passes * (parts - 1.0) > still.reading && job.tasks > 1;
    if (once) plan.first = FarmTask{"prepare", task_seconds(job, still.reading, still.passes), still.memory};
    const double traced = still.picture / parts + (once ? 0.0 : still.passes);
    for (int i = 1; i <= job.tasks; ++i)
        plan.tasks.push_back(
            {fmt::format("{}/{}", i, job.tasks), task_seconds(job, still.reading, traced), still.memory});
}

/// In two digits that count, but whole from ten on.
std::string seconds_text(double seconds)
{
    return seconds >= 10.0 ? fmt::format("{:.0f}", seconds) : fmt::format("{:.2g}", seconds);
}

void put_task(JsonWriter& json, const FarmJob& job, const FarmTask& task)
{
    json.begin_object();
    json.key("what").text(task.what);
    json.key("cores").integer(job.cores);
    json.key("mib").integer(static_cast<std::int64_t>(std::ceil(task.memory / kMebibyte)));
    json.key("seconds").number(task.seconds);
    json.end();
}

}  // namespace

std::string frames_text(const std::vector<int>& numbers)
{
    std::string text;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t end = i + 1;
        while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
        text += (text.empty() ? "" : ",") + std::to_string(numbers[i]);
        if (end - i > 1) text += "-" + std::to_string(numbers[end - 1]);
        i = end;
    }
    return text;
}

JobPlan plan_of(const FarmJob& job, const JobEstimate& estimate)
{
    JobPlan plan;
    plan.parts = !job.list.animation;
    if (plan.parts) cut_still(job, estimate.frames.front(), plan);
    else cut_frames(job, estimate, plan);
    const double pixels = static_cast<double>(job.settings.width) * job.settings.height;
    plan.join = {"join", kJoinStart + (plan.parts ? kJoinPixel * pixels : 0.0), kLeastReserve};
    double longest = 0.0, largest = 0.0;
    for (const FarmTask& task : plan.tasks) {
        plan.sum += task.seconds;
        longest = std::max(longest, task.seconds);
        largest = std::max(largest, task.memory);
    }
    const double first = plan.first ? plan.first->seconds : 0.0;
    plan.sum += first + plan.join.seconds;
    plan.critical_path = first + longest + plan.join.seconds;
    plan.memory = std::max(kReserve * largest, largest + kLeastReserve);
    plan.error = estimate.error;
    plan.measured = estimate.measured;
    plan.spent = estimate.spent;
    return plan;
}

std::string plan_text(const FarmJob& job, const JobPlan& plan)
{
    std::string text =
        fmt::format("{:<20} {:>5} {:>8} {:>9}\n", plan.parts ? "part" : "frames", "cores", "MiB", "seconds");
    const auto line = [&](const FarmTask& task) {
        text += fmt::format("{:<20} {:>5} {:>8.0f} {:>9}\n", task.what, job.cores, std::ceil(task.memory / kMebibyte),
                            seconds_text(task.seconds));
    };
    if (plan.first) line(*plan.first);
    for (const FarmTask& task : plan.tasks) line(task);
    line(plan.join);
    text += fmt::format("sum {} s, critical path {} s, give a task {:.0f} MiB; ", seconds_text(plan.sum),
                        seconds_text(plan.critical_path), std::ceil(plan.memory / kMebibyte));
    const char* const how = job.from.empty() ? "small" : "finished";
    text += plan.error ? fmt::format("expected to be off by {:.0f} %", 100.0 * *plan.error)
                       : std::string("how far off is not known");
    return text + fmt::format(", told by {} {} frame{} in {} s\n", plan.measured, how, plan.measured == 1 ? "" : "s",
                              seconds_text(plan.spent));
}

std::string plan_json(const FarmJob& job, const JobPlan& plan)
{
    JsonWriter json;
    json.begin_object();
    json.key("scene").text(job.settings.input_file);
    json.key("kind").text(plan.parts ? "still" : "animation");
    json.key("frames").integer(static_cast<std::int64_t>(job.list.frames.size()));
    json.key("width").integer(job.settings.width);
    json.key("height").integer(job.settings.height);
    json.key("tasks").begin_array();
    for (const FarmTask& task : plan.tasks) put_task(json, job, task);
    json.end();
    json.key("prepare");
    if (plan.first) put_task(json, job, *plan.first);
    else json.null();
    json.key("join");
    put_task(json, job, plan.join);
    json.key("sum_seconds").number(plan.sum);
    json.key("critical_path_seconds").number(plan.critical_path);
    json.key("task_mib").integer(static_cast<std::int64_t>(std::ceil(plan.memory / kMebibyte)));
    json.key("expected_error");
    if (plan.error) json.number(*plan.error);
    else json.null();
    json.key("measured_frames").integer(plan.measured);
    json.key("measuring_seconds").number(plan.spent);
    json.end();
    return json.take();
}

}  // namespace app
