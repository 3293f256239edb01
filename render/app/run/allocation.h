#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace app {

/// Reads a file of the system by its path; empty where there is none.
using SystemFile = std::function<std::string(const std::string& path)>;
/// A variable of the environment; empty where there is none.
using Variable = std::function<std::string(const char* name)>;

/// Threads that the control groups of a process (version 1 and 2, each with those above it) and Slurm's words of its
/// task leave to it; 0: nothing limits them. OMP_NUM_THREADS is for other programs: shells set it to 1 for all that
/// they start.
int threads_of_task(const SystemFile& file, const Variable& variable);
/// Bytes that they leave to it; infinite where nothing limits them.
double memory_of_task(const SystemFile& file, const Variable& variable);

/// Those of this process, no more than the processors that it may run on. Read once, when first asked for.
int allocated_threads();
/// The same; small pictures never ask.
double allocated_memory();

/// The number behind a word that begins a line of a text.
std::optional<double> number_after(std::string_view text, std::string_view word);

}  // namespace app
