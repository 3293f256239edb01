#include "render/study/between_surfaces.h"

#include "render/study/kinds.h"
#include "render/study/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace study {
namespace {

/// The nearest picture of a kind that takes no longer; null: none is so fast.
const Result* nearest(const std::vector<Result>& results, const std::string& family, double seconds)
{
    const Result* best = nullptr;
    for (const Result& r : results)
        if (r.family == family && r.seconds <= seconds && (!best || r.error.levels < best->error.levels)) best = &r;
    return best;
}

/// Times of 1, 2 and 5 that begin with the fastest of all and end with the slowest.
std::vector<double> times_of(const std::vector<Series>& series)
{
    double least = 1e9, most = 0.0;
    for (const Series& one : series)
        for (const Series::Point& p : one.points) least = std::min(least, p.x), most = std::max(most, p.x);
    std::vector<double> out;
    for (int decade = static_cast<int>(std::floor(std::log10(least))); std::pow(10.0, decade) < most; ++decade)
        for (const int step : {1, 2, 5}) {
            const double at = step * std::pow(10.0, decade);
            if (at >= least) out.push_back(at);
            if (at >= most) return out;
        }
    return out;
}

}  // namespace

std::string between_surfaces(const Section& section, double wanted)
{
    const std::vector<Series> series = series_of(section.results, true);
    if (series.empty()) return {};
    std::string out =
        "<p>Light between surfaces: what stands in for it and paths, against the same truth of paths.</p>\n";
    out += plot(series, {"seconds", "error, levels of 255 (RMS)", "s", section.truth.expected_error, wanted});
    out += "<p>In equal time: the error of the nearest picture of each kind that takes no longer.</p>\n<table><tr>"
           "<th>seconds</th>";
    for (const Series& one : series) out += fmt::format("<th>{}</th>", escaped(one.name));
    out += "</tr>\n";
    for (const double seconds : times_of(series)) {
        out += fmt::format("<tr><td>{:g}</td>", seconds);
        for (const Series& one : series) {
            const Result* const best = nearest(section.results, one.name, seconds);
            out += best ? fmt::format("<td>{:.2f}</td>", best->error.levels) : "<td></td>";
        }
        out += "</tr>\n";
    }
    return out + "</table>\n";
}

}  // namespace study
