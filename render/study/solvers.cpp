#include "render/study/solvers.h"

#include "render/study/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>

namespace study {
namespace {

std::vector<std::string> cells(const std::string& line)
{
    std::vector<std::string> out(1);
    for (const char c : line) {
        if (c == ',') out.emplace_back();
        else if (c != '\r') out.back() += c;
    }
    return out;
}

/// Which plot a solid is in: by how its crossings are found.
enum class Group { Quadric, Flat, Polynomial, Outline, Iterated, Count };

constexpr std::array<std::string_view, static_cast<std::size_t>(Group::Count)> kGroupNames{
    "Quadrics", "Flat faces", "Polynomials of degree 3 to 35", "Outlines that are turned or swept", "Iterated"};

Group group_of(std::string_view solid)
{
    struct Entry {
        std::string_view solid;
        Group group;
    };
    static constexpr Entry kGroups[] = {{"sphere", Group::Quadric},
                                        {"ellipsoid", Group::Quadric},
                                        {"cylinder", Group::Quadric},
                                        {"cone", Group::Quadric},
                                        {"paraboloid", Group::Quadric},
                                        {"hyperboloid", Group::Quadric},
                                        {"disc", Group::Flat},
                                        {"box", Group::Flat},
                                        {"oriented_box", Group::Flat},
                                        {"polygon", Group::Flat},
                                        {"triangle", Group::Flat},
                                        {"smooth_triangle", Group::Flat},
                                        {"mesh", Group::Flat},
                                        {"height_field", Group::Flat},
                                        {"torus", Group::Polynomial},
                                        {"cubic", Group::Polynomial},
                                        {"quartic", Group::Polynomial},
                                        {"degree6", Group::Polynomial},
                                        {"degree10", Group::Polynomial},
                                        {"degree20", Group::Polynomial},
                                        {"degree35", Group::Polynomial},
                                        {"blob", Group::Polynomial},
                                        {"lathe", Group::Outline},
                                        {"sor", Group::Outline},
                                        {"ovus", Group::Outline},
                                        {"prism", Group::Outline},
                                        {"conic_prism", Group::Outline},
                                        {"text", Group::Outline},
                                        {"sweep_linear", Group::Outline},
                                        {"sweep_b_spline", Group::Outline}};
    const auto* const found = std::find_if(std::begin(kGroups), std::end(kGroups),
                                           [solid](const Entry& entry) { return entry.solid == solid; });
    return found == std::end(kGroups) ? Group::Iterated : found->group;
}

std::vector<Series> series_of(const std::vector<const SolverRow*>& rows)
{
    std::vector<Series> out;
    for (const SolverRow* row : rows) {
        auto found = std::find_if(out.begin(), out.end(), [&](const Series& s) { return s.name == row->solid; });
        if (found == out.end()) {
            Series one;
            one.name = row->solid;
            one.look = look(out.size());
            one.line = false;
            out.push_back(std::move(one));
            found = out.end() - 1;
        }
        found->points.push_back({row->ns, row->worst, fmt::format("{} {} {:g}", row->solid, row->sweep, row->value)});
    }
    return out;
}

std::string told_of(const std::vector<const SolverRow*>& rows)
{
    const auto by_worst = [](const SolverRow* a, const SolverRow* b) { return a->worst < b->worst; };
    const auto by_time = [](const SolverRow* a, const SolverRow* b) { return a->ns < b->ns; };
    const SolverRow& worst = **std::max_element(rows.begin(), rows.end(), by_worst);
    const SolverRow& slowest = **std::max_element(rows.begin(), rows.end(), by_time);
    int missed = 0, wrong = 0;
    for (const SolverRow* row : rows) missed += row->missed, wrong += row->wrong;
    return fmt::format("<p>Worst error: {:.2g}, {} at {} {:g}. Slowest: {:.0f} ns a ray, {} at {} {:g}. Crossings "
                       "missed: {}, told where "
                       "none is: {}.</p>\n",
                       worst.worst, escaped(worst.solid), escaped(worst.sweep), worst.value, slowest.ns,
                       escaped(slowest.solid), escaped(slowest.sweep), slowest.value, missed, wrong);
}

}  // namespace

std::vector<SolverRow> read_solvers(const std::filesystem::path& file)
{
    std::ifstream in(file);
    std::string line;
    if (!in || !std::getline(in, line)) throw std::runtime_error(fmt::format("cannot read '{}'", file.string()));
    std::map<std::string, std::size_t> column;
    const std::vector<std::string> names = cells(line);
    for (std::size_t i = 0; i < names.size(); ++i) column[names[i]] = i;
    const auto of = [&](const std::vector<std::string>& row, const char* name) -> const std::string& {
        const auto found = column.find(name);
        if (found == column.end() || found->second >= row.size())
            throw std::runtime_error(
                fmt::format("'{}' is no table of numerics_lab: it has no '{}'", file.string(), name));
        return row[found->second];
    };
    std::vector<SolverRow> out;
    while (std::getline(in, line)) {
        const std::vector<std::string> row = cells(line);
        const auto number = [&](const char* name) { return std::strtod(of(row, name).c_str(), nullptr); };
        out.push_back({of(row, "sweep"), of(row, "solid"), number("value"), number("worst"), number("median"),
                       number("ns"), static_cast<int>(number("missed")), static_cast<int>(number("false"))});
    }
    return out;
}

std::string solver_plots(const std::vector<SolverRow>& rows)
{
    std::string out =
        "<h2 id='solvers'>Solvers</h2>\n<p>Worst error of a crossing, relative to the larger of the ray's distance "
        "and the solid's size, judged in 113-bit arithmetic, against the time of a ray. A point is one row of a "
        "sweep: scale, distance, offset, aspect from 1e-9 to 1e9.</p>\n";
    for (std::size_t g = 0; g < kGroupNames.size(); ++g) {
        std::vector<const SolverRow*> group;
        for (const SolverRow& row : rows)
            if (group_of(row.solid) == static_cast<Group>(g) && row.ns > 0.0) group.push_back(&row);
        if (group.empty()) continue;
        out += fmt::format("<h3>{}</h3>\n", kGroupNames[g]);
        out += plot(series_of(group), {"nanoseconds a ray", "worst relative error", "ns"}) + told_of(group);
    }
    return out;
}

}  // namespace study
