#include "render/texture/noise/nearest_cells.h"

#include "csg/base/lanes.h"
#include "csg/base/types.h"
#include "render/texture/noise/noise.h"

#include <cmath>

namespace texture {
namespace {

using csg::lanes::Double;

struct Offset {
    std::int8_t x = 0, y = 0, z = 0;
    std::uint8_t order = 0;  ///< of POV-Ray's search
};

constexpr int absolute(int v) { return v < 0 ? -v : v; }

constexpr std::array<Offset, CellPoints::kAll> offsets()
{
    std::array<Offset, CellPoints::kAll> all{};
    std::size_t near = 0, far = CellPoints::kNear;
    std::uint8_t order = 0;
    for (int a = -2; a <= 2; ++a)
        for (int b = -2; b <= 2; ++b)
            for (int c = -2; c <= 2; ++c) {
                const int outer = (absolute(a) == 2) + (absolute(b) == 2) + (absolute(c) == 2);
                if (outer > 1) continue;
                all[outer == 0 ? near++ : far++] = {static_cast<std::int8_t>(a), static_cast<std::int8_t>(b),
                                                    static_cast<std::int8_t>(c), order++};
            }
    return all;
}

constexpr auto kOffsets = offsets();

double powered_distance(const glm::dvec3& delta, double metric, bool signed_sum)
{
    if (metric == 2.0) return glm::dot(delta, delta);
    if (metric == 1.0 && signed_sum) return -(delta.x + delta.y + delta.z);
    const glm::dvec3 a = glm::abs(delta);
    if (metric == 1.0) return a.x + a.y + a.z;
    return std::pow(a.x, metric) + std::pow(a.y, metric) + std::pow(a.z, metric);
}

/// Takes distances in any order.
struct Finder {
    std::array<double, 3> best{csg::kInfinity, csg::kInfinity, csg::kInfinity};
    std::size_t nearest = CellPoints::kAll;

    void take(double d, std::size_t cell)
    {
        if (!(d < best[2])) return;
        if (d < best[0]) {
            best = {d, best[0], best[1]};
            nearest = cell;
        } else {
            if (d == best[0] && kOffsets[cell].order < kOffsets[nearest].order) nearest = cell;
            if (d < best[1]) best = {best[0], d, best[1]};
            else best[2] = d;
        }
    }
};

/// Distances squared (or sums of absolute deltas) of cells in vector lanes, from whole vectors on.
template <bool Squared>
void distances(const glm::dvec3& p, const CellPoints& cells, std::size_t first, double* out)
{
    for (std::size_t i = first; i < cells.count(); i += csg::lanes::kDoubles) {
        const Double x = Double(p.x) - Double::load_aligned(cells.x.data() + i),
                     y = Double(p.y) - Double::load_aligned(cells.y.data() + i),
                     z = Double(p.z) - Double::load_aligned(cells.z.data() + i);
        const Double d = Squared ? x * x + y * y + z * z : xsimd::abs(x) + xsimd::abs(y) + xsimd::abs(z);
        d.store_aligned(out + i);
    }
}

/// Metrics 1 and 2. The outer cells are looked at only if they can hold a nearer point.
template <bool Squared>
Finder nearest_plain(const glm::dvec3& p, CellPoints& cells, std::size_t wanted)
{
    alignas(64) std::array<double, CellPoints::kRoom> d;
    distances<Squared>(p, cells, 0, d.data());
    Finder found;
    for (std::size_t i = 0; i < CellPoints::kNear; ++i) found.take(d[i], i);
    if (found.best[wanted - 1] < kOuterCells) return found;
    cells.complete();
    constexpr std::size_t kWhole = CellPoints::kNear / csg::lanes::kDoubles * csg::lanes::kDoubles;
    distances<Squared>(p, cells, kWhole, d.data());
    for (std::size_t i = CellPoints::kNear; i < CellPoints::kAll; ++i) found.take(d[i], i);
    return found;
}

/// Any metric above 0. A sum of powers costs much, so only those are built that can be among the nearest: lengths by
/// the metric m and by 2 differ by a factor of up to 3^|1/2 - 1/m| (the inequality between power means).
Finder nearest_powered(const glm::dvec3& p, CellPoints& cells, double metric, std::size_t wanted)
{
    constexpr double kSlack = 1.0 + 1e-6;  // far above the rounding of lengths
    const Finder by_length = nearest_plain<true>(p, cells, wanted);
    const double limit = by_length.best[wanted - 1] * std::pow(9.0, std::abs(0.5 - 1.0 / metric)) * kSlack;
    if (!(limit < kOuterCells)) cells.complete();
    Finder found;
    for (std::size_t i = 0; i < cells.count(); ++i) {
        const glm::dvec3 delta = p - glm::dvec3(cells.x[i], cells.y[i], cells.z[i]);
        if (!(glm::dot(delta, delta) > limit)) found.take(powered_distance(delta, metric, false), i);
    }
    return found;
}

Finder nearest_of_all(const glm::dvec3& p, CellPoints& cells, double metric, bool signed_sum)
{
    cells.complete();
    Finder found;
    for (std::size_t i = 0; i < cells.count(); ++i)
        found.take(powered_distance(p - glm::dvec3(cells.x[i], cells.y[i], cells.z[i]), metric, signed_sum), i);
    return found;
}

Finder find(const glm::dvec3& p, CellPoints& cells, double metric, bool signed_sum, std::size_t wanted)
{
    constexpr double kSteep = 100.0;  // powers of lengths up to 1.7 and slightly below 1 keep their order
    if (metric == 2.0) return nearest_plain<true>(p, cells, wanted);
    if (metric == 1.0 && !signed_sum) return nearest_plain<false>(p, cells, wanted);
    if (metric > 0.0 && metric < kSteep && !signed_sum) return nearest_powered(p, cells, metric, wanted);
    return nearest_of_all(p, cells, metric, signed_sum);
}

}  // namespace

CellPoints::CellPoints(const glm::dvec3& base_cell) : base_(base_cell)
{
    fill(0, kNear);
    for (std::size_t i = kNear; i < 32; ++i) x[i] = y[i] = z[i] = csg::kInfinity;
}

void CellPoints::complete()
{
    if (completed()) return;
    fill(kNear, kAll);
    for (std::size_t i = kAll; i < kRoom; ++i) x[i] = y[i] = z[i] = csg::kInfinity;
}

void CellPoints::fill(std::size_t first, std::size_t last)
{
    for (std::size_t i = first; i < last; ++i) {
        const glm::dvec3 cell = base_ + glm::dvec3(kOffsets[i].x, kOffsets[i].y, kOffsets[i].z);
        const int seed =
            cell_hash(static_cast<long long>(cell.x), static_cast<long long>(cell.y), static_cast<long long>(cell.z));
        x[i] = cell.x + pattern_random(seed);
        y[i] = cell.y + pattern_random(seed + 1);
        z[i] = cell.z + pattern_random(seed + 2);
    }
    count_ = last;
}

NearestCells nearest_cells(const glm::dvec3& p, CellPoints& cells, double metric, bool signed_sum, int wanted)
{
    const Finder found = find(p, cells, metric, signed_sum, static_cast<std::size_t>(wanted));
    const std::size_t at = found.nearest;
    return {found.best, at == CellPoints::kAll ? p : glm::dvec3(cells.x[at], cells.y[at], cells.z[at])};
}

}  // namespace texture
