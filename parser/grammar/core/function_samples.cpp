#include "parser/grammar/core/function_samples.h"

#include "parser/base/queries.h"

#include <algorithm>
#include <cmath>

namespace parser {
namespace {

constexpr double kMost = 65535.0;
constexpr std::size_t kMostAsked = 1u << 16;  // points at a time

double number(double v) { return std::isnan(v) ? 0.0 : v; }

std::uint16_t wrapped(double v)
{
    return static_cast<std::uint16_t>(static_cast<std::int64_t>(std::clamp(number(v * kMost), -0x1p31, 0x1p31)));
}

std::uint16_t cut_off(double v) { return static_cast<std::uint16_t>(std::clamp(number(v), 0.0, 1.0) * kMost + 0.5); }

}  // namespace

std::size_t sampled_channels(const function::Function& called) { return called.components > 1 ? 4 : 1; }

std::optional<std::vector<std::uint16_t>> sampled_levels(SceneBuilder& build, const function::FunctionPtr& called,
                                                         std::uint32_t columns, std::uint32_t rows)
{
    const std::size_t channels = sampled_channels(*called);
    std::vector<std::uint16_t> levels;
    levels.reserve(std::size_t{columns} * rows * channels);
    const auto add = [&](const function::Values& v) {
        if (channels == 1) levels.push_back(wrapped(v[0]));
        else
            for (const double part : {v[0], v[1], v[2], 1.0 - v[4]}) levels.push_back(cut_off(part));
    };
    std::vector<glm::dvec3> points;
    std::vector<function::Values> values;
    for (std::uint32_t y = 0; y < rows; ++y)
        for (std::uint32_t x = 0; x < columns; ++x) {
            const glm::dvec3 at{x / (columns - 1.0), y / (rows - 1.0), 0.0};
            points.push_back(at);
            if (points.size() < kMostAsked && (y + 1 < rows || x + 1 < columns)) continue;
            values.resize(points.size());
            if (!build.evaluate(called, points, values)) return std::nullopt;
            std::for_each(values.begin(), values.end(), add);
            points.clear();
        }
    return levels;
}

}  // namespace parser
