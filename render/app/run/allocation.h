#pragma once

#include <functional>
#include <limits>
#include <string>

namespace app {

/// What a queue, a container or the system leaves to this process.
struct Allocation {
    int threads = 0;                                          ///< 0: nothing limits them
    double memory = std::numeric_limits<double>::infinity();  ///< bytes that are left of it
};

/// Reads a file of the system by its path; empty where there is none.
using SystemFile = std::function<std::string(const std::string& path)>;
/// A variable of the environment; empty where there is none.
using Variable = std::function<std::string(const char* name)>;

/// By the control groups of the process (version 1 and 2, each with those above it) and by what Slurm says of the task.
/// OMP_NUM_THREADS is for other programs: shells set it to 1 for all that they start.
Allocation allocation_of(const SystemFile& file, const Variable& variable);

/// Of this process, with the processors that it may run on.
const Allocation& allocation();

}  // namespace app
