#include "bench/numerics/csg_checks.h"
#include "bench/numerics/measure.h"
#include "bench/numerics/oracle.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

/// The laboratory: error of every solver against a 113-bit oracle, beside its time (docs/numerics.md).
int main(int count, char** words)
{
    std::map<std::string, std::string> options{{"--rays", "20000"}, {"--sweep", ""}, {"--solid", ""}, {"--value", ""}, {"--csv", ""}, {"--asked", ""}};
    bool check = false, timed = true;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        const auto option = options.find(word);
        if (word == "--check") {
            check = true;
        } else if (word == "--untimed") {
            timed = false;
        } else if (word == "--slow") {
            numerics::plain_judge = true;
        } else if (option != options.end() && i + 1 < count) {
            option->second = words[++i];
        } else {
            fmt::print(stderr, "usage: numerics_lab [--rays N] [--sweep NAME] [--solid NAME] [--value V] [--csv FILE] [--asked FOLDER] [--check] [--untimed]\n");
            return 2;
        }
    }
    const long rays = std::atol(options["--rays"].c_str());
    const std::string only_sweep = options["--sweep"], only_solid = options["--solid"], csv = options["--csv"], asked_folder = options["--asked"];

    std::FILE* table = csv.empty() ? nullptr : std::fopen(csv.c_str(), "w");
    if (!csv.empty() && table == nullptr) return fmt::print(stderr, "cannot write {}\n", csv), 2;
    if (table) fmt::print(table, "sweep,value,solid,rays,hits,missed,false,worst,median,grazing,ns,spawn,acne_per_million,lost_per_million,disagree,bar,passes\n");
    fmt::print("{:9} {:>7} {:19} {:>6} {:>6} {:>6} {:>9} {:>9} {:>9} {:>7} {:>9} {:>8} {:>8} {:>5}\n", "sweep", "value", "solid", "hits", "missed",
               "false", "worst", "median", "grazing", "ns", "spawn", "acne/M", "lost/M", "in/out");
    int failed = 0;
    for (const numerics::Sweep& sweep : numerics::sweeps()) {
        if (!only_sweep.empty() && sweep.name != only_sweep) continue;
        for (const std::string& solid : sweep.solids)
            for (const double value : sweep.values) {
                if (!only_solid.empty() && solid != only_solid) continue;
                if (!options["--value"].empty() && std::abs(value / std::atof(options["--value"].c_str()) - 1.0) > 1e-9) continue;
                std::vector<numerics::Asked> asked;
                const numerics::Row r = numerics::measure(sweep, solid, value, rays, timed, asked_folder.empty() ? nullptr : &asked);
                failed += r.passes() ? 0 : 1;
                fmt::print("{:9} {:7.0e} {:19} {:6} {:6} {:6} {:9.1e} {:9.1e} {:9.1e} {:7.0f} {:9.1e} {:8.0f} {:8.0f} {:5}{}\n", r.sweep, r.value, r.solid, r.hits,
                           r.missed, r.wrong, r.worst, r.median, r.grazing, r.ns, r.spawn, r.acne, r.lost, r.disagree, r.passes() ? "" : "  !");
                if (table)
                    fmt::print(table, "{},{:g},{},{},{},{},{},{:.3g},{:.3g},{:.3g},{:.1f},{:.3g},{:.1f},{:.1f},{},{:g},{}\n", r.sweep, r.value, r.solid, r.rays, r.hits,
                               r.missed, r.wrong, r.worst, r.median, r.grazing, r.ns, r.spawn, r.acne, r.lost, r.disagree, numerics::bar_of(r.solid), r.passes() ? 1 : 0);
                if (asked.empty() || sweep.make(solid, value).sdl.empty()) continue;
                const std::string path = fmt::format("{}/{}_{}_{:g}.csv", asked_folder, sweep.name, solid, value);
                std::FILE* file = std::fopen(path.c_str(), "w");
                if (file == nullptr) return fmt::print(stderr, "cannot write {}\n", path), 2;
                fmt::print(file, "{}\n", sweep.make(solid, value).sdl);
                for (const numerics::Asked& a : asked)
                    fmt::print(file, "{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{},{},{:.17g}\n", a.ray.origin.x, a.ray.origin.y, a.ray.origin.z,
                               a.ray.direction.x, a.ray.direction.y, a.ray.direction.z, a.hit ? 1 : 0, a.clear ? 1 : 0, a.t);
                std::fclose(file);
            }
    }
    if (table) std::fclose(table);
    if (only_sweep.empty() || only_sweep == "csg") {
        fmt::print("\n{:20} {:>9} {:>8} {:>8}\n", "csg", "value", "rays", "wrong");
        for (const numerics::CsgRow& r : numerics::csg_checks(rays)) {
            failed += r.wrong > 0 ? 1 : 0;
            fmt::print("{:20} {:9.0e} {:8} {:8}{}\n", r.name, r.value, r.rays, r.wrong, r.wrong > 0 ? "  !" : "");
        }
    }
    fmt::print("{} rows miss their bar\n", failed);
    return check && failed > 0 ? 1 : 0;
}
