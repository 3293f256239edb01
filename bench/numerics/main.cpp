#include "bench/numerics/csg_checks.h"
#include "bench/numerics/measure.h"
#include "bench/numerics/oracle.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <sstream>
#include <thread>

namespace {

using numerics::Row;

constexpr const char* kUsage = "usage: numerics_lab [--rays N | --rays-per-sweep N] [--sweep NAMES] [--solid NAMES] "
                               "[--value V] [--threads N] [--csv FILE]\n"
                               "                    [--asked FOLDER] [--check] [--untimed] [--slow] [--spoiled]\n"
                               "NAMES: one or more, with commas between\n";

/// Names with commas between; none stand for all.
class Chosen {
public:
    explicit Chosen(const std::string& list)
    {
        std::istringstream names(list);
        for (std::string name; std::getline(names, name, ',');) names_.push_back(name);
    }
    bool all() const { return names_.empty(); }
    bool named(const std::string& name) const { return std::find(names_.begin(), names_.end(), name) != names_.end(); }
    bool operator()(const std::string& name) const { return all() || named(name); }

private:
    std::vector<std::string> names_;
};

/// One line of the table to be.
struct Job {
    const numerics::Sweep* sweep;
    std::string solid;
    double value;
    long rays;
    Row row = {};
    std::vector<numerics::Asked> asked = {};
    bool done = false;
};

void print(const Row& r)
{
    fmt::print("{:9} {:7.0e} {:19} {:6} {:6} {:6} {:9.1e} {:9.1e} {:9.1e} {:7.0f} {:9.1e} {:8.0f} {:8.0f} {:5}{}\n",
               r.sweep, r.value, r.solid, r.hits, r.missed, r.wrong, r.worst, r.median, r.grazing, r.ns, r.spawn,
               r.acne, r.lost, r.disagree, r.passes() ? "" : "  !");
}

void write(std::FILE* table, const Row& r)
{
    fmt::print(table, "{},{:g},{},{},{},{},{},{:.3g},{:.3g},{:.3g},{:.1f},{:.3g},{:.1f},{:.1f},{},{:g},{}\n", r.sweep,
               r.value, r.solid, r.rays, r.hits, r.missed, r.wrong, r.worst, r.median, r.grazing, r.ns, r.spawn, r.acne,
               r.lost, r.disagree, numerics::bar_of(r.solid), r.passes() ? 1 : 0);
}

/// The rays of a row for another program; false if the file cannot be written.
bool write_asked(const std::string& folder, const Job& job)
{
    const std::string sdl = job.sweep->make(job.solid, job.value).sdl;
    if (job.asked.empty() || sdl.empty()) return true;
    const std::string path = fmt::format("{}/{}_{}_{:g}.csv", folder, job.sweep->name, job.solid, job.value);
    std::FILE* file = std::fopen(path.c_str(), "w");
    if (file == nullptr) return fmt::print(stderr, "cannot write {}\n", path), false;
    fmt::print(file, "{}\n", sdl);
    for (const numerics::Asked& a : job.asked)
        fmt::print(file, "{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{},{},{:.17g}\n", a.ray.origin.x,
                   a.ray.origin.y, a.ray.origin.z, a.ray.direction.x, a.ray.direction.y, a.ray.direction.z,
                   a.hit ? 1 : 0, a.clear ? 1 : 0, a.t);
    std::fclose(file);
    return true;
}

/// Takes jobs as threads come free; each is told to `finished` in the order of the list.
template <class F>
void run(std::vector<Job>& jobs, int threads, bool timed, bool ask, F&& finished)
{
    std::atomic<std::size_t> next{0};
    std::size_t told = 0;
    std::mutex telling;
    const auto work = [&] {
        for (std::size_t i; (i = next++) < jobs.size();) {
            Job& job = jobs[i];
            Row row = numerics::measure(*job.sweep, job.solid, job.value, job.rays, timed, ask ? &job.asked : nullptr);
            const std::lock_guard lock(telling);
            job.row = std::move(row);
            job.done = true;
            for (; told < jobs.size() && jobs[told].done; ++told) finished(jobs[told]);
        }
    };
    std::vector<std::jthread> more;
    for (int i = 1; i < threads; ++i) more.emplace_back(work);
    work();
}

}  // namespace

/// The laboratory: error of every solver against a 113-bit oracle, beside its time (docs/numerics.md).
int main(int count, char** words)
{
    std::map<std::string, std::string> options{{"--rays", "20000"}, {"--rays-per-sweep", ""}, {"--sweep", ""},
                                               {"--solid", ""},     {"--value", ""},          {"--threads", "1"},
                                               {"--csv", ""},       {"--asked", ""}};
    std::map<std::string, bool> flags{
        {"--check", false}, {"--untimed", false}, {"--slow", false}, {"--spoiled", false}};
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        if (const auto flag = flags.find(word); flag != flags.end()) {
            flag->second = true;
        } else if (const auto option = options.find(word); option != options.end() && i + 1 < count) {
            option->second = words[++i];
        } else {
            return fmt::print(stderr, "{}", kUsage), 2;
        }
    }
    numerics::plain_judge = flags["--slow"];
    numerics::spoiled = flags["--spoiled"];
    const long rays = std::atol(options["--rays"].c_str()), shared = std::atol(options["--rays-per-sweep"].c_str());
    const Chosen sweeps(options["--sweep"]), solids(options["--solid"]);
    const std::string csv = options["--csv"], folder = options["--asked"];

    const std::vector<numerics::Sweep> all = numerics::sweeps();
    std::vector<Job> jobs;
    for (const numerics::Sweep& sweep : all)
        for (const std::string& solid : sweep.solids)
            for (const double value : sweep.values) {
                if (!sweeps(sweep.name) || !solids(solid)) continue;
                if (!options["--value"].empty() && std::abs(value / std::atof(options["--value"].c_str()) - 1.0) > 1e-9)
                    continue;
                const long rows = static_cast<long>(sweep.values.size());
                jobs.push_back({&sweep, solid, value, shared > 0 ? (shared + rows - 1) / rows : rays});
            }

    std::FILE* table = csv.empty() ? nullptr : std::fopen(csv.c_str(), "w");
    if (!csv.empty() && table == nullptr) return fmt::print(stderr, "cannot write {}\n", csv), 2;
    if (table)
        fmt::print(table, "sweep,value,solid,rays,hits,missed,false,worst,median,grazing,ns,spawn,acne_per_million,"
                          "lost_per_million,disagree,bar,passes\n");
    fmt::print("{:9} {:>7} {:19} {:>6} {:>6} {:>6} {:>9} {:>9} {:>9} {:>7} {:>9} {:>8} {:>8} {:>5}\n", "sweep", "value",
               "solid", "hits", "missed", "false", "worst", "median", "grazing", "ns", "spawn", "acne/M", "lost/M",
               "in/out");
    int failed = 0;
    bool written = true;
    run(jobs, std::max(1, std::atoi(options["--threads"].c_str())), !flags["--untimed"], !folder.empty(),
        [&](Job& job) {
            failed += job.row.passes() ? 0 : 1;
            print(job.row);
            if (table) write(table, job.row);
            written = write_asked(folder, job) && written;
            job.asked = {};
            std::fflush(nullptr);  // a run of an hour can be watched, and cut short
        });
    if (table) std::fclose(table);
    if (!written) return 2;
    if (sweeps.named("csg") || (sweeps.all() && solids.all())) {
        fmt::print("\n{:20} {:>9} {:>8} {:>8}\n", "csg", "value", "rays", "wrong");
        for (const numerics::CsgRow& r : numerics::csg_checks(shared > 0 ? shared : rays)) {
            failed += r.wrong > 0 ? 1 : 0;
            fmt::print("{:20} {:9.0e} {:8} {:8}{}\n", r.name, r.value, r.rays, r.wrong, r.wrong > 0 ? "  !" : "");
        }
    }
    fmt::print("{} rows miss their bar\n", failed);
    return flags["--check"] && failed > 0 ? 1 : 0;
}
