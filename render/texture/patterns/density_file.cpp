#include "render/texture/patterns/patterns.h"
#include "render/texture/points/point_lanes.h"

#include <algorithm>
#include <cmath>

/// Samples in a unit cube (spec 4, 5.7).
namespace texture {
namespace {

using scene::Volume;

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

/// Where the samples before a corner, at it and the two behind it lie along an axis, which ends where it begins.
using AxisPlaces = std::array<std::uint64_t, 4>;
AxisPlaces places_along(const Volume& v, const Corner& c, std::size_t axis)
{
    const std::uint64_t at = c.at[axis], size = v.size[axis];
    const auto inside = [&](std::uint64_t place) { return place < size ? place : place % size; };
    std::uint64_t stride = 1;
    for (std::size_t k = 0; k < axis; ++k) stride *= v.size[k];
    // The one before 0 is counted in 64 bits without sign: the last one only if the size is a power of two.
    return {inside(at - 1) * stride, at * stride, inside(at + 1) * stride, inside(at + 2) * stride};
}

double sample(const Volume& v, std::uint64_t place) { return v.samples[place] / v.most; }

/// Catmull-Rom through b and c.
float cubic(float a, float b, float c, float d, float t)
{
    const float from = (c - a) / 2.0f, to = (d - b) / 2.0f;
    return ((2.0f * (b - c) + from + to) * t + (3.0f * (c - b) - 2.0f * from - to)) * t * t + from * t + b;
}

/// So many curves beside each other.
template <std::size_t Count>
std::array<float, Count> cubics(const std::array<std::array<float, Count>, 4>& through, float t)
{
    std::array<float, Count> out;
    for (std::size_t i = 0; i < Count; ++i)
        out[i] = cubic(through[0][i], through[1][i], through[2][i], through[3][i], t);
    return out;
}

double tricubic(const Volume& v, const Corner& c)
{
    const AxisPlaces x = places_along(v, c, 0), y = places_along(v, c, 1), z = places_along(v, c, 2);
    const auto t = [&](std::size_t axis) { return static_cast<float>(c.beyond[axis]); };
    std::array<std::array<float, 16>, 4> columns;  // by z: those of the same y side by side
    for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t i = 0; i < 4; ++i)
                columns[k][4 * j + i] = static_cast<float>(sample(v, x[i] + y[j] + z[k]));
    const std::array<float, 16> at_z = cubics(columns, t(2));
    std::array<std::array<float, 4>, 4> rows;
    for (std::size_t j = 0; j < 4; ++j)
        std::copy_n(at_z.begin() + static_cast<std::ptrdiff_t>(4 * j), 4, rows[j].begin());
    const std::array<float, 4> along = cubics(rows, t(1));
    return std::max(0.0, static_cast<double>(cubic(along[0], along[1], along[2], along[3], t(0))));
}

constexpr int kTrilinear = 1;
int interpolation(const Pattern& pattern) { return static_cast<int>(pattern.numbers[0]) % 10; }

/// On one axis: where the samples below a point and above it lie, as whole numbers, and the shares that both have. V is
/// double, or Double for as many points as there are lanes.
template <class V>
struct Between {
    V place[2], share[2];

    Between(const V& t, std::uint32_t size, double stride)
    {
        using numbers::lanes::choose, std::trunc, xsimd::trunc;
        const V last(static_cast<double>(size) - 1.0), zero(0.0), one(1.0), by(stride), whole = trunc(t);
        const V at = choose(whole < last, whole, last), beyond = t - at;
        place[0] = at * by, place[1] = choose(at < last, at + one, zero) * by;
        share[0] = one - beyond, share[1] = beyond;
    }
};

double sample(const Volume& v, double place)
{
    return sample(v, static_cast<std::uint64_t>(static_cast<std::int64_t>(place)));
}
Double sample(const Volume& v, const Double& place)
{
    alignas(64) double places[kLanes], samples[kLanes];
    place.store_aligned(places);
    for (std::size_t lane = 0; lane < kLanes; ++lane)
        samples[lane] = v.samples[static_cast<std::size_t>(static_cast<std::int64_t>(places[lane]))];
    return Double::load_aligned(samples) / Double(v.most);
}

/// Of points in the unit cube.
template <class V>
V trilinear(const Volume& v, const V& px, const V& py, const V& pz)
{
    const double row = v.size[0], plane = row * v.size[1];
    const auto axis = [&](const V& p, std::size_t k, double stride) {
        return Between<V>(p * V(static_cast<double>(v.size[k])), v.size[k], stride);
    };
    const Between<V> x = axis(px, 0, 1.0), y = axis(py, 1, row), z = axis(pz, 2, plane);
    V sum(0.0);
    for (std::size_t k = 0; k < 8; ++k) {
        const std::size_t a = k & 1, b = k >> 1 & 1, c = k >> 2;
        sum = sum + x.share[a] * y.share[b] * z.share[c] * sample(v, x.place[a] + y.place[b] + z.place[c]);
    }
    return sum;
}

void trilinear_values(const Volume& v, const Points& p, Values& out)
{
    const Double zero(0.0), one(1.0);
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        const Double px = get(p.x, i), py = get(p.y, i), pz = get(p.z, i);
        const auto within = [&](const Double& c) { return (c >= zero) & (c < one); };
        const auto inside = within(px) & within(py) & within(pz);
        const auto kept = [&](const Double& c) { return xsimd::select(inside, c, zero); };
        Double value = zero;
        if (xsimd::any(inside)) value = xsimd::select(inside, trilinear(v, kept(px), kept(py), kept(pz)), zero);
        value.store_aligned(out.data() + i);
    }
}

}  // namespace

void density_values(const Pattern& pattern, const Volume& volume, const Points& p, Values& out)
{
    if (interpolation(pattern) == kTrilinear) return trilinear_values(volume, p, out);
    for (std::size_t i = 0; i < p.size(); ++i) out[i] = density(pattern, volume, p.at(i));
}

double density(const Pattern& pattern, const Volume& volume, const glm::dvec3& p)
{
    if (!(p.x >= 0.0 && p.x < 1.0 && p.y >= 0.0 && p.y < 1.0 && p.z >= 0.0 && p.z < 1.0)) return 0.0;
    const Corner corner = corner_of(volume, p);
    switch (interpolation(pattern)) {
    case 0: return sample(volume, (corner.at[2] * volume.size[1] + corner.at[1]) * volume.size[0] + corner.at[0]);
    case kTrilinear: return trilinear(volume, p.x, p.y, p.z);
    default: return tricubic(volume, corner);
    }
}

}  // namespace texture
