#include "render/app/run/allocation.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <map>

namespace {

using Texts = std::map<std::string, std::string>;

std::string found(const Texts& texts, const std::string& name)
{
    const auto at = texts.find(name);
    return at == texts.end() ? std::string() : at->second;
}

struct Allocation {
    int threads;
    double memory;
};

Allocation allocation(const Texts& files, const Texts& variables = {})
{
    const auto file = [&](const std::string& path) { return found(files, path); };
    const auto variable = [&](const char* name) { return found(variables, name); };
    return {app::threads_of_task(file, variable), app::memory_of_task(file, variable)};
}

const std::string kGroups = "/sys/fs/cgroup";

}  // namespace

TEST_CASE("nothing limits a process of its own", "[app][allocation]")
{
    CHECK(allocation({}).threads == 0);
    CHECK(std::isinf(allocation({}).memory));
    const Texts unlimited = {{"/proc/self/cgroup", "0::/user.slice\n"},
                             {kGroups + "/user.slice/memory.max", "max\n"},
                             {kGroups + "/user.slice/memory.current", "5000\n"},
                             {kGroups + "/user.slice/cpu.max", "max 100000\n"}};
    CHECK(allocation(unlimited).threads == 0);
    CHECK(std::isinf(allocation(unlimited).memory));
}

TEST_CASE("control groups of version 2 limit with all that stand above them", "[app][allocation]")
{
    const Texts files = {{"/proc/self/cgroup", "0::/slurm/job_7/step_0\n"},
                         {kGroups + "/slurm/job_7/step_0/memory.max", "max\n"},
                         {kGroups + "/slurm/job_7/memory.max", "1000000\n"},
                         {kGroups + "/slurm/job_7/memory.current", "700000\n"},
                         {kGroups + "/slurm/job_7/memory.stat", "anon 300000\ninactive_file 400000\n"},
                         {kGroups + "/slurm/memory.max", "5000000\n"},
                         {kGroups + "/slurm/memory.current", "4900000\n"},
                         {kGroups + "/slurm/job_7/step_0/cpu.max", "250000 100000\n"},
                         {kGroups + "/slurm/cpu.max", "800000 100000\n"}};
    CHECK(allocation(files).threads == 3);      // a thread that is held back half of the time is worth having
    CHECK(allocation(files).memory == 100000);  // of the group above: it has less left
}

TEST_CASE("control groups of version 1, and one that a container shows as the root", "[app][allocation]")
{
    const Texts files = {{"/proc/self/cgroup", "5:memory:/docker/abc\n3:cpu,cpuacct:/docker/abc\n1:name=systemd:/x\n"},
                         {kGroups + "/memory/memory.limit_in_bytes", "2000000\n"},
                         {kGroups + "/memory/memory.usage_in_bytes", "1500000\n"},
                         {kGroups + "/memory/memory.stat", "total_inactive_file 250000\n"},
                         {kGroups + "/memory/docker/memory.limit_in_bytes", "9223372036854771712\n"},
                         {kGroups + "/cpu/cpu.cfs_quota_us", "200000\n"},
                         {kGroups + "/cpu/cpu.cfs_period_us", "100000\n"},
                         {kGroups + "/cpu/docker/cpu.cfs_quota_us", "-1\n"},
                         {kGroups + "/cpu/docker/cpu.cfs_period_us", "100000\n"}};
    CHECK(allocation(files).threads == 2);
    CHECK(allocation(files).memory == 750000);
}

TEST_CASE("what Slurm reserves counts, and the variable of another program does not", "[app][allocation]")
{
    CHECK(allocation({}, {{"SLURM_CPUS_PER_TASK", "4"}}).threads == 4);
    CHECK(allocation({}, {{"OMP_NUM_THREADS", "1"}}).threads == 0);
    CHECK(allocation({}, {{"SLURM_CPUS_PER_TASK", "many"}}).threads == 0);
    CHECK(allocation({}, {{"SLURM_MEM_PER_NODE", "2"}}).memory == 2.0 * 1024 * 1024);
    CHECK(std::isinf(allocation({}, {{"SLURM_MEM_PER_NODE", "0"}}).memory));
    CHECK(allocation({}, {{"SLURM_MEM_PER_CPU", "2"}, {"SLURM_CPUS_PER_TASK", "3"}}).memory == 6.0 * 1024 * 1024);
}

TEST_CASE("numbers of a file of the system are found by the word that begins their line", "[app][allocation]")
{
    const std::string text = "MemTotal:       24683620 kB\nMemFree:         123 kB\nMemAvailable:   456 kB\nx 7";
    CHECK(app::number_after(text, "MemAvailable:") == 456.0);
    CHECK(app::number_after(text, "x") == 7.0);
    CHECK_FALSE(app::number_after(text, "Mem"));
    CHECK_FALSE(app::number_after(text, "kB"));
    CHECK_FALSE(app::number_after("", "x"));
}
