#include "numbers/functions/functions.h"
#include "numbers/lanes.h"
#include "csg/base/types.h"
#include "render/texture/points/angle.h"
#include "render/texture/noise/nearest_cells.h"
#include "render/texture/noise/nearest_lanes.h"
#include "render/texture/noise/noise.h"
#include "render/texture/noise/noise_points.h"
#include "render/texture/patterns/patterns.h"

#include <algorithm>
#include <cmath>

/// vector: form; numbers: metric, offset, solid, repeat of each axis (whole numbers from 0 on).
namespace texture {
namespace {

using numbers::lanes::Double;

glm::ivec3 repeat(const Pattern& pattern)
{
    return {static_cast<int>(pattern.numbers[3]), static_cast<int>(pattern.numbers[4]),
            static_cast<int>(pattern.numbers[5])};
}

glm::dvec3 base_cell(const glm::dvec3& p) { return glm::floor(p - kTiny); }

/// Whose noise is the value of a solid cell: the nearest point, moved as the place that asks has to be to lie among the
/// first cells (spec 7b, 4).
glm::dvec3 solid_point(const Pattern& pattern, const glm::dvec3& p, CellPoints& cells)
{
    glm::dvec3 point = nearest_cells(p, cells, pattern.numbers[0], false, 1).point;
    const glm::ivec3 cycle = repeat(pattern);
    for (int k = 0; k < 3; ++k)
        if (const double size = cycle[k]; size > 0.0) point[k] -= size * std::floor(p[k] / size);
    return point;
}

bool solid(const Pattern& pattern) { return pattern.numbers[2] != 0.0; }

/// How many of the nearest distances count.
int wanted(const Pattern& pattern)
{
    if (solid(pattern)) return 1;
    return pattern.vector.z != 0.0 ? 3 : pattern.vector.y != 0.0 ? 2 : 1;
}

double value_of(const Pattern& pattern, const std::array<double, 3>& powered, int count)
{
    const double metric = pattern.numbers[0], offset = pattern.numbers[1];
    double v = 0.0;
    for (int i = 0; i < count; ++i) {
        double s = powered[static_cast<std::size_t>(i)];
        if (offset != 0.0) s += metric == 2.0 ? offset * offset : metric == 1.0 ? offset : numbers::pow(offset, metric);
        v += pattern.vector[i] * (metric == 2.0 ? std::sqrt(s) : metric == 1.0 ? s : numbers::pow(s, 1.0 / metric));
    }
    return std::clamp(v, 0.0, 1.0);
}

double crackle_in(const Pattern& pattern, const glm::dvec3& p, CellPoints& cells)
{
    const double metric = pattern.numbers[0];
    const int count = wanted(pattern);
    if (!solid(pattern)) return value_of(pattern, nearest_distances(p, cells, metric, count), count);
    return std::clamp(noise(solid_point(pattern, p, cells), pattern.noise_generator), 0.0, 1.0);
}

/// value_of() for lengths: metric 1 or 2, no offset.
template <int Count, bool Squared>
Double length_sum(const Pattern& pattern, const NearestLanes<Count>& found)
{
    const auto term = [&](int i, const Double& d) {
        return Double(pattern.vector[i]) * (Squared ? xsimd::sqrt(d) : d);
    };
    Double v = Double(0.0) + term(0, found.first);
    if constexpr (Count > 1) v = v + term(1, found.second);
    if constexpr (Count > 2) v = v + term(2, found.third);
    return xsimd::select(v < Double(0.0), Double(0.0), xsimd::select(Double(1.0) < v, Double(1.0), v));
}

/// Points of one cell in lanes; metric 1 or 2, no offset.
template <int Count, bool Squared>
void shared_cell(const Pattern& pattern, const Points& p, CellPoints& cells, Values& out)
{
    for (std::size_t i = 0; i < p.size(); i += numbers::lanes::kDoubles) {
        const Double x = Double::load_aligned(p.x.data() + i), y = Double::load_aligned(p.y.data() + i),
                     z = Double::load_aligned(p.z.data() + i);
        NearestLanes<Count> found;
        const auto search = [&](std::size_t begin, std::size_t end) {
            for (std::size_t c = begin; c < end; ++c) {
                const Double dx = x - Double(cells.x[c]), dy = y - Double(cells.y[c]), dz = z - Double(cells.z[c]);
                found.take(Squared ? dx * dx + dy * dy + dz * dz : xsimd::abs(dx) + xsimd::abs(dy) + xsimd::abs(dz));
            }
        };
        search(0, CellPoints::kNear);
        if (numbers::lanes::mask(found.last() >= Double(kOuterCells)) != 0) {
            cells.complete();
            search(CellPoints::kNear, CellPoints::kAll);
        }
        length_sum<Count, Squared>(pattern, found).store_aligned(out.data() + i);
    }
}

template <bool Squared>
void shared_cell(const Pattern& pattern, const Points& p, CellPoints& cells, int count, Values& out)
{
    if (count == 1) shared_cell<1, Squared>(pattern, p, cells, out);
    else if (count == 2) shared_cell<2, Squared>(pattern, p, cells, out);
    else shared_cell<3, Squared>(pattern, p, cells, out);
}

/// crackle_in() of points with `solid`: the noise of their nearest cells' points.
void solid_values(const Pattern& pattern, const Points& p, CellPoints& cells, Values& out)
{
    Points nearest;
    for (std::size_t i = 0; i < p.size(); ++i) nearest.add(solid_point(pattern, p.at(i), cells));
    nearest.pad();
    noise_points(nearest, pattern.noise_generator, out);
    for (std::size_t i = 0; i < p.size(); ++i) out[i] = std::clamp(out[i], 0.0, 1.0);
}

/// All points lie in the cell `base`.
void values_in(const Pattern& pattern, const glm::dvec3& base, Points& p, Values& out)
{
    constexpr int kFew = 2;  // up to so many points cells fill the lanes better
    CellPoints& cells = cell_points(base, repeat(pattern));
    const double metric = pattern.numbers[0];
    const bool lengths = (metric == 1.0 || metric == 2.0) && pattern.numbers[1] == 0.0;
    if (solid(pattern)) return solid_values(pattern, p, cells, out);
    if (!lengths || p.count <= kFew) {
        for (std::size_t i = 0; i < p.size(); ++i) out[i] = crackle_in(pattern, p.at(i), cells);
        return;
    }
    p.pad();
    if (metric == 2.0) shared_cell<true>(pattern, p, cells, wanted(pattern), out);
    else shared_cell<false>(pattern, p, cells, wanted(pattern), out);
}

}  // namespace

double crackle(const Pattern& pattern, const glm::dvec3& p)
{
    return crackle_in(pattern, p, cell_points(base_cell(p), repeat(pattern)));
}

void crackle_values(const Pattern& pattern, const Points& p, Values& out)
{
    std::array<glm::dvec3, kMostPoints> base;
    std::array<std::uint8_t, kMostPoints> left, owner;
    std::size_t count = p.size();
    for (std::size_t i = 0; i < count; ++i) {
        base[i] = base_cell(p.at(i));
        left[i] = static_cast<std::uint8_t>(i);
    }
    Points group;
    Values found;
    while (count != 0) {
        const glm::dvec3 cell = base[left[0]];
        group.count = 0;
        std::size_t kept = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint8_t i = left[k];
            if (base[i] == cell) {
                owner[group.size()] = i;
                group.add(p.at(i));
            } else {
                left[kept++] = i;
            }
        }
        if (kept == count) break;  // a point that is no number is in no cell
        count = kept;
        values_in(pattern, cell, group, found);
        for (std::size_t k = 0; k < group.size(); ++k) out[owner[k]] = found[k];
    }
    for (std::size_t k = 0; k < count; ++k) out[left[k]] = crackle(pattern, p.at(left[k]));
}

}  // namespace texture
