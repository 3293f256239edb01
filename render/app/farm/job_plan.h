#pragma once

#include "render/app/farm/estimate.h"

#include <optional>
#include <string>
#include <vector>

namespace app {

inline constexpr double kMebibyte = 1024.0 * 1024.0;

/// A task of a farm: one start of the renderer.
struct FarmTask {
    std::string what;      ///< frames "1-10" or a part "3/16", as the renderer's option has it
    double seconds = 0.0;  ///< with the job's cores
    double memory = 0.0;   ///< bytes
};

struct JobPlan {
    bool parts = false;             ///< of one picture; else frames
    std::vector<FarmTask> tasks;    ///< that need nothing of each other
    std::optional<FarmTask> first;  ///< what they wait for: photons and radiosity, found once
    FarmTask join;
    double sum = 0.0, critical_path = 0.0;  ///< seconds of all, and with as many machines as there are tasks
    double memory = 0.0;                    ///< bytes that a task needs, with a reserve
    std::optional<double> error;            ///< share; none where nothing tells it
    int measured = 0;
    double spent = 0.0;
};

/// Frames go together so that the tasks take about as long as each other.
JobPlan plan_of(const FarmJob& job, const JobEstimate& estimate);

std::string plan_text(const FarmJob& job, const JobPlan& plan);
std::string plan_json(const FarmJob& job, const JobPlan& plan);

/// "1-10,12" of frames in order.
std::string frames_text(const std::vector<int>& numbers);

}  // namespace app
