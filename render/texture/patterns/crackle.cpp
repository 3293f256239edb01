#include "render/texture/angle.h"
#include "render/texture/nearest_cells.h"
#include "render/texture/noise.h"
#include "render/texture/patterns/patterns.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace texture {
namespace {

double powered_distance(const glm::dvec3& delta, double metric, bool signed_sum)
{
    if (metric == 2.0) return glm::dot(delta, delta);
    if (metric == 1.0 && signed_sum) return -(delta.x + delta.y + delta.z);
    const glm::dvec3 a = glm::abs(delta);
    if (metric == 1.0) return a.x + a.y + a.z;
    return std::pow(a.x, metric) + std::pow(a.y, metric) + std::pow(a.z, metric);
}

}  // namespace

NearestCells nearest_cells(const glm::dvec3& p, const glm::dvec3& base_cell, double metric, bool signed_sum)
{
    NearestCells found{{csg::kInfinity, csg::kInfinity, csg::kInfinity}, p};
    for (int a = -2; a <= 2; ++a)
        for (int b = -2; b <= 2; ++b)
            for (int c = -2; c <= 2; ++c) {
                if ((std::abs(a) == 2) + (std::abs(b) == 2) + (std::abs(c) == 2) > 1) continue;
                const glm::dvec3 cell = base_cell + glm::dvec3(a, b, c);
                const int seed = cell_hash(static_cast<long long>(cell.x), static_cast<long long>(cell.y),
                                           static_cast<long long>(cell.z));
                const glm::dvec3 point =
                    cell + glm::dvec3(pattern_random(seed), pattern_random(seed + 1), pattern_random(seed + 2));
                const double d = powered_distance(p - point, metric, signed_sum);
                auto& best = found.powered;
                if (d < best[0]) {
                    best = {d, best[0], best[1]};
                    found.point = point;
                } else if (d < best[1]) {
                    best = {best[0], d, best[1]};
                } else if (d < best[2]) {
                    best[2] = d;
                }
            }
    return found;
}

/// vector: form; numbers: metric, offset, solid.
double crackle(const Pattern& pattern, const glm::dvec3& p)
{
    const double metric = pattern.numbers[0], offset = pattern.numbers[1];
    NearestCells found = nearest_cells(p, glm::floor(p - kTiny), metric, false);
    if (pattern.numbers[2] != 0.0) return std::clamp(noise(found.point, pattern.noise_generator), 0.0, 1.0);
    const glm::dvec3& form = pattern.vector;
    double v = 0.0;
    for (int i = 0; i < 3; ++i) {
        double s = found.powered[static_cast<std::size_t>(i)];
        if (offset != 0.0) s += metric == 2.0 ? offset * offset : metric == 1.0 ? offset : std::pow(offset, metric);
        v += form[i] * (metric == 2.0 ? std::sqrt(s) : metric == 1.0 ? s : std::pow(s, 1.0 / metric));
    }
    return std::clamp(v, 0.0, 1.0);
}

}  // namespace texture
