#include "parser/grammar/core/function_samples.h"

#include "parser/base/queries.h"

#include <algorithm>
#include <cmath>

namespace parser {
namespace {

constexpr double kMost = 65535.0;
constexpr std::size_t kMostAsked = 1u << 14;  // points at a time, which stay in the cache

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
    const std::size_t all = std::size_t{columns} * rows;
    std::vector<std::uint16_t> levels(all * channels);
    std::uint16_t* to = levels.data();
    const auto add = [&](const function::Values& v) {
        if (channels == 1) {
            *to++ = wrapped(v[0]);
            return;
        }
        for (const double part : {v[0], v[1], v[2], 1.0 - v[4]}) *to++ = cut_off(part);
    };
    std::vector<glm::dvec3> points;
    std::vector<function::Values> values;
    std::uint32_t x = 0, y = 0;
    for (std::size_t first = 0; first < all; first += points.size()) {
        points.resize(std::min(all - first, kMostAsked));
        values.resize(points.size());
        for (glm::dvec3& at : points) {
            at = {x / (columns - 1.0), y / (rows - 1.0), 0.0};
            if (++x == columns) x = 0, ++y;
        }
        if (!build.evaluate(called, points, values)) return std::nullopt;
        std::for_each(values.begin(), values.end(), add);
    }
    return levels;
}

}  // namespace parser
