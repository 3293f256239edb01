#pragma once

#include "render/study/solvers.h"
#include "render/study/study.h"

#include <functional>

namespace study {

/// One scene's part of a report.
struct Section {
    std::string scene;  ///< file
    int width = 0, height = 0;
    Truth truth;
    std::vector<Result> results;
    std::string unmeasured;   ///< why there is nothing; empty: there is
    std::string povray_note;  ///< why POV-Ray's curves are short; empty: nothing to say
};

/// What a report was made with.
struct Circumstances {
    std::string command, machine, version, povray;  ///< povray: its version; empty: not measured
    int threads = 1;
    double wanted = 1.0;             ///< levels of error that the page recommends a setting for
    std::vector<SolverRow> solvers;  ///< of the laboratory of numbers; empty: not asked for
};

/// A PNG of a picture, for the page to hold.
using PngOf = std::function<std::string(const Shown&)>;

/// The report as one page that needs nothing else: for each scene plot, recommendation, table, pictures, differences.
std::string page(const std::vector<Section>& sections, const Circumstances& circumstances, const PngOf& png);

/// The table as CSV: one line a result.
std::string csv(const std::vector<Section>& sections);

/// Five times as far from the truth as the picture is, around grey.
Shown difference(const Shown& truth, const Shown& picture);

}  // namespace study
