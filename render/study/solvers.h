#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace study {

/// What the laboratory of numbers (docs/numerics.md) found of one solid in one row of a sweep.
struct SolverRow {
    std::string sweep, solid;
    double value = 0.0;         ///< of what the sweep varies
    double worst = 0.0;         ///< largest error of a crossing, relative to the larger of distance and size
    double median = 0.0;        ///< of the errors
    double ns = 0.0;            ///< time for a ray
    int missed = 0, wrong = 0;  ///< crossings that were not told, and told where none is
};

/// The table that `numerics_lab --csv` writes. Throws std::runtime_error where it can't be read or isn't one.
std::vector<SolverRow> read_solvers(const std::filesystem::path& file);

/// HTML: error against nanoseconds, one plot for each group of solids, a point for each row.
std::string solver_plots(const std::vector<SolverRow>& rows);

}  // namespace study
