#include "render/study/kinds.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace study {
namespace {

struct Kind {
    std::string_view family;
    std::size_t color, mark;  ///< of look()
    bool between = false;
};

// Kinds that stand in one plot differ in color as far as there are colors.
constexpr Kind kKinds[] = {{"antialiasing", 6, 0},
                           {"antialiasing, method 1", 0, 0},
                           {"antialiasing, method 2", 1, 0},
                           {"antialiasing, method 3", 1, 3},
                           {"samples", 2, 0},
                           {"samples where needed", 3, 0},
                           {"samples in a time", 4, 0},
                           {"area lights, all lamps", 5, 0},
                           {"area lights, adaptive 1", 5, 1},
                           {"lens", 4, 1},
                           {"depth of reflection", 6, 1},
                           {"adc_bailout", 6, 2},
                           {"radiosity, rays", 0, 2},
                           {"radiosity, error_bound", 0, 3},
                           {"radiosity, bounces", 4, 2},
                           {"photons", 5, 2},
                           {"media", 2, 1},
                           {"accuracy of isosurfaces, parametric surfaces and julia sets", 3, 1},
                           {"radiosity alone", 0, 1, true},
                           {"photons alone", 5, 3, true},
                           {"radiosity and photons", 2, 2, true},
                           {"paths", 1, 1, true},
                           {"paths where needed", 1, 2, true},
                           {"paths, filtered", 3, 2, true}};

const Kind* kind_of(const std::string& family)
{
    const Kind* const found =
        std::find_if(std::begin(kKinds), std::end(kKinds), [&](const Kind& kind) { return kind.family == family; });
    return found == std::end(kKinds) ? nullptr : found;
}

}  // namespace

Look look_of(const std::string& family)
{
    const Kind* const kind = kind_of(family);
    return kind == nullptr ? look(6, Mark::Diamond) : look(kind->color, static_cast<Mark>(kind->mark));
}

bool is_between_surfaces(const std::string& family)
{
    const Kind* const kind = kind_of(family);
    return kind != nullptr && kind->between;
}

std::vector<Series> series_of(const std::vector<Result>& results, bool between)
{
    std::vector<Series> out;
    for (const Result& result : results) {
        if (is_between_surfaces(result.family) != between) continue;
        const std::string name = (result.povray ? "POV-Ray, " : "") + result.family;
        auto found = std::find_if(out.begin(), out.end(), [&](const Series& s) { return s.name == name; });
        if (found == out.end()) {
            Series one;
            one.name = name;
            one.look = look_of(result.family);
            one.dashed = result.povray;
            out.push_back(std::move(one));
            found = out.end() - 1;
        }
        found->points.push_back({result.seconds, result.error.levels, result.name});
    }
    return out;
}

}  // namespace study
