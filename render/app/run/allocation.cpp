#include "render/app/run/allocation.h"

#include "render/app/base/text.h"
#include "render/files/whole_file.h"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace app {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// The number that a text begins with; infinite for "max", none, and what version 1 writes for no limit.
double number_of(const std::string& text)
{
    constexpr double kNoLimit = 1e18;
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    return end == text.c_str() || number < 0.0 || number > kNoLimit ? kUnlimited : number;
}

/// A folder below which the group's own and those above it lie, and the path from there.
struct Group {
    std::string root, path;
};

/// The groups of the process that rule `controller`.
std::vector<Group> groups_of(const std::string& membership, const std::string& controller)
{
    std::vector<Group> groups;
    for (const std::string_view line : pieces_of(membership, '\n')) {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string names(line.substr(first + 1, second - first - 1)), path(line.substr(second + 1));
        if (names.empty()) groups.push_back({"/sys/fs/cgroup", path});  // version 2
        else if (("," + names + ",").find("," + controller + ",") != std::string::npos)
            groups.push_back({"/sys/fs/cgroup/" + controller, path});
    }
    return groups;
}

/// Calls `look` with the folder of each group, from the process's own to the root. A container may see its own group as
/// the root while the path names the host's: the root is always asked.
template <class Look>
void for_each_folder(const Group& group, Look look)
{
    for (std::string path = group.path; path.size() > 1; path.resize(path.rfind('/'))) look(group.root + path);
    look(group.root);
}

/// Files that were read and can go again count as used in a group: they are left.
double left_of(double limit, double used, const std::string& statistics, const char* kept)
{
    return std::isinf(limit)
               ? limit
               : std::max(0.0, limit - (std::isinf(used) ? 0.0 : used) + number_after(statistics, kept).value_or(0.0));
}

double memory_of_groups(const SystemFile& file, const std::string& membership)
{
    double least = kUnlimited;
    for (const Group& group : groups_of(membership, "memory"))
        for_each_folder(group, [&](const std::string& folder) {
            const std::string statistics = file(folder + "/memory.stat");
            least = std::min(
                {least,
                 left_of(number_of(file(folder + "/memory.max")), number_of(file(folder + "/memory.current")),
                         statistics, "inactive_file"),
                 left_of(number_of(file(folder + "/memory.limit_in_bytes")),
                         number_of(file(folder + "/memory.usage_in_bytes")), statistics, "total_inactive_file")});
        });
    return least;
}

/// Of a quota in a period, both in microseconds.
double cores_of(double quota, double period)
{
    return std::isinf(quota) || std::isinf(period) || period <= 0.0 ? kUnlimited : quota / period;
}

double cores_of_groups(const SystemFile& file, const std::string& membership)
{
    double least = kUnlimited;
    for (const Group& group : groups_of(membership, "cpu"))
        for_each_folder(group, [&](const std::string& folder) {
            const std::string both = file(folder + "/cpu.max");
            const std::size_t blank = both.find(' ');
            if (blank != std::string::npos)
                least = std::min(least, cores_of(number_of(both), number_of(both.substr(blank))));
            least = std::min(least, cores_of(number_of(file(folder + "/cpu.cfs_quota_us")),
                                             number_of(file(folder + "/cpu.cfs_period_us"))));
        });
    return least;
}

/// What Slurm reserved for the task, where no group of the system holds it to that.
double memory_of_slurm(const Variable& variable, double cores)
{
    constexpr double kMega = 1024.0 * 1024.0;
    const double node = number_of(variable("SLURM_MEM_PER_NODE")), core = number_of(variable("SLURM_MEM_PER_CPU"));
    if (!std::isinf(node) && node > 0.0) return node * kMega;  // 0 stands for all that the machine has
    return std::isinf(core) || core <= 0.0 ? kUnlimited : core * kMega * (std::isinf(cores) ? 1.0 : cores);
}

double cores_of_task(const Variable& variable) { return number_of(variable("SLURM_CPUS_PER_TASK")); }

std::string text_of_system(const std::string& path) { return files::whole_file_if(path).value_or(std::string()); }

std::string variable_of_process(const char* name)
{
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
}

}  // namespace

std::optional<double> number_after(std::string_view text, std::string_view word)
{
    for (const std::string_view line : pieces_of(text, '\n'))
        if (line.size() > word.size() && line.starts_with(word) && is_blank(line[word.size()]))
            return std::strtod(std::string(line.substr(word.size())).c_str(), nullptr);
    return {};
}

int threads_of_task(const SystemFile& file, const Variable& variable)
{
    const double cores = std::min(cores_of_groups(file, file("/proc/self/cgroup")), cores_of_task(variable));
    return std::isinf(cores) ? 0 : std::max(1, static_cast<int>(std::ceil(cores)));
}

double memory_of_task(const SystemFile& file, const Variable& variable)
{
    return std::min(memory_of_groups(file, file("/proc/self/cgroup")),
                    memory_of_slurm(variable, cores_of_task(variable)));
}

int allocated_threads()
{
    static const int threads = [] {
        const int limit = threads_of_task(text_of_system, variable_of_process);
        cpu_set_t may_run;
        CPU_ZERO(&may_run);
        const int bound = sched_getaffinity(0, sizeof may_run, &may_run) == 0 ? CPU_COUNT(&may_run) : 0;
        return bound > 0 ? std::min(limit, bound) : limit;
    }();
    return threads;
}

double allocated_memory()
{
    static const double memory = memory_of_task(text_of_system, variable_of_process);
    return memory;
}

}  // namespace app
