#include "parser/grammar/function_samples.h"

#include "parser/queries.h"

#include <algorithm>
#include <cmath>

namespace parser {
namespace {

constexpr double kMost = 65535.0;

double number(double v) { return std::isnan(v) ? 0.0 : v; }

std::uint16_t wrapped(double v) { return static_cast<std::uint16_t>(static_cast<std::int64_t>(std::clamp(number(v * kMost), -0x1p31, 0x1p31))); }

std::uint16_t cut_off(double v) { return static_cast<std::uint16_t>(std::clamp(number(v), 0.0, 1.0) * kMost + 0.5); }

}  // namespace

std::size_t sampled_channels(const function::Function& called) { return called.components > 1 ? 4 : 1; }

std::optional<std::vector<std::uint16_t>> sampled_levels(SceneBuilder& build, const function::FunctionPtr& called, std::uint32_t columns,
                                                         std::uint32_t rows)
{
    const std::size_t channels = sampled_channels(*called);
    std::vector<std::uint16_t> levels;
    levels.reserve(std::size_t{columns} * rows * channels);
    for (std::uint32_t y = 0; y < rows; ++y)
        for (std::uint32_t x = 0; x < columns; ++x) {
            const double at[3] = {x / (columns - 1.0), y / (rows - 1.0), 0.0};
            const auto value = called->asks_scene ? build.evaluate(called, at) : std::optional(function::evaluate_all(*called, at, function::no_host()));
            if (!value) return std::nullopt;
            const function::Values& v = *value;
            if (channels == 1) levels.push_back(wrapped(v[0]));
            else for (const double part : {v[0], v[1], v[2], 1.0 - v[4]}) levels.push_back(cut_off(part));
        }
    return levels;
}

}  // namespace parser
