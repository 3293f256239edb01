#include "render/texture/patterns/patterns.h"

#include <algorithm>
#include <cmath>

/// Samples in a unit cube (spec 4, 5.7).
namespace texture {
namespace {

using scene::Volume;

double sample(const Volume& v, std::uint64_t x, std::uint64_t y, std::uint64_t z)
{
    return v.samples[(z * v.size[1] + y) * v.size[0] + x] / v.most;
}

/// Corner below the point and how far the point is from it, on each axis.
struct Corner {
    std::array<std::uint64_t, 3> at{};
    std::array<double, 3> beyond{};
};

Corner corner_of(const Volume& v, const glm::dvec3& p)
{
    Corner corner;
    for (int k = 0; k < 3; ++k) {
        const auto axis = static_cast<std::size_t>(k);
        const double t = p[k] * v.size[axis];
        corner.at[axis] = std::min<std::uint64_t>(static_cast<std::uint64_t>(t), v.size[axis] - 1);
        corner.beyond[axis] = t - static_cast<double>(corner.at[axis]);
    }
    return corner;
}

double trilinear(const Volume& v, const Corner& c)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < 8; ++k) {
        std::array<std::uint64_t, 3> at{};
        double share = 1.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const bool upper = (k >> axis) & 1;
            at[axis] = upper ? (c.at[axis] + 1) % v.size[axis] : c.at[axis];
            share *= upper ? c.beyond[axis] : 1.0 - c.beyond[axis];
        }
        sum += share * sample(v, at[0], at[1], at[2]);
    }
    return sum;
}

/// Catmull-Rom through b and c.
float cubic(float a, float b, float c, float d, float t)
{
    const float from = (c - a) / 2.0f, to = (d - b) / 2.0f;
    return ((2.0f * (b - c) + from + to) * t + (3.0f * (c - b) - 2.0f * from - to)) * t * t + from * t + b;
}

double tricubic(const Volume& v, const Corner& c)
{
    // The neighbour below 0 is counted in 64 bits without sign: the last one only if the size is a power of two.
    const auto neighbour = [&](std::size_t axis, std::uint64_t k) { return (c.at[axis] + k - 1) % v.size[axis]; };
    const auto t = [&](std::size_t axis) { return static_cast<float>(c.beyond[axis]); };
    std::array<float, 4> rows{}, planes{}, along{};
    for (std::uint64_t i = 0; i < 4; ++i) {
        for (std::uint64_t j = 0; j < 4; ++j) {
            for (std::uint64_t k = 0; k < 4; ++k)
                rows[k] = static_cast<float>(sample(v, neighbour(0, i), neighbour(1, j), neighbour(2, k)));
            planes[j] = cubic(rows[0], rows[1], rows[2], rows[3], t(2));
        }
        along[i] = cubic(planes[0], planes[1], planes[2], planes[3], t(1));
    }
    return std::max(0.0, static_cast<double>(cubic(along[0], along[1], along[2], along[3], t(0))));
}

}  // namespace

double density(const Pattern& pattern, const Volume& volume, const glm::dvec3& p)
{
    if (!(p.x >= 0.0 && p.x < 1.0 && p.y >= 0.0 && p.y < 1.0 && p.z >= 0.0 && p.z < 1.0)) return 0.0;
    const Corner corner = corner_of(volume, p);
    switch (static_cast<int>(pattern.numbers[0]) % 10) {
    case 0: return sample(volume, corner.at[0], corner.at[1], corner.at[2]);
    case 1: return trilinear(volume, corner);
    default: return tricubic(volume, corner);
    }
}

}  // namespace texture
