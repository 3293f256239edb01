#pragma once

#include "render/app/farm/job_plan.h"

#include <string>
#include <vector>

namespace app {

/// What hands the tasks out.
enum class Engine { Slurm, OpenJd, Make, Shell };

/// A file of the folder that hands a job in.
struct FarmFile {
    std::string name, text;
};

struct FarmFolder {
    Engine engine;
    std::string path;   ///< of the folder, absolute
    std::string movie;  ///< that the frames are joined to; empty: none
};

/// All files of the folder: the tasks, a script for each kind of them, the plan, what the engine reads, `submit`, a
/// README.
std::vector<FarmFile> farm_files(const FarmJob& job, const JobPlan& plan, const FarmFolder& folder);

/// A template of Open Job Description (2023-09).
std::string openjd_template(const FarmJob& job, const JobPlan& plan, const FarmFolder& folder);

}  // namespace app
