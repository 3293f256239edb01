#include "render/texture/noise/nearest_cells.h"

#include "numbers/functions/functions.h"
#include "numbers/lanes.h"
#include "csg/base/types.h"
#include "numbers/lane_power.h"
#include "numbers/rounding.h"
#include "render/texture/noise/nearest_lanes.h"
#include "render/texture/noise/noise_tables.h"

#include <array>
#include <bit>
#include <cmath>
#include <memory>

namespace texture {
namespace {

using numbers::lanes::Double;

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
    return numbers::pow(a.x, metric) + numbers::pow(a.y, metric) + numbers::pow(a.z, metric);
}

/// Takes distances in any order.
struct Finder {
    std::array<double, 3> best{numbers::kInfinity, numbers::kInfinity, numbers::kInfinity};
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

/// Distances squared (or sums of absolute deltas) of cells in vector lanes; `first` begins a vector.
template <bool Squared>
void distances(const glm::dvec3& p, const CellPoints& cells, std::size_t first, std::size_t last, double* out)
{
    for (std::size_t i = first; i < last; i += numbers::lanes::kDoubles) {
        const Double x = Double(p.x) - Double::load_aligned(cells.x.data() + i),
                     y = Double(p.y) - Double::load_aligned(cells.y.data() + i),
                     z = Double(p.z) - Double::load_aligned(cells.z.data() + i);
        const Double d = Squared ? x * x + y * y + z * z : xsimd::abs(x) + xsimd::abs(y) + xsimd::abs(z);
        d.store_aligned(out + i);
    }
}

/// The smallest of the first `count` distances; behind them up to a whole vector lie infinite ones.
template <int Count>
std::array<double, 3> smallest(const double* d, std::size_t count)
{
    NearestLanes<Count> nearest;
    for (std::size_t i = 0; i < count; i += numbers::lanes::kDoubles) nearest.take(Double::load_aligned(d + i));
    return nearest.merged();
}

std::array<double, 3> smallest(const double* d, std::size_t count, std::size_t wanted)
{
    return wanted == 1 ? smallest<1>(d, count) : wanted == 2 ? smallest<2>(d, count) : smallest<3>(d, count);
}

/// Of the first `count` cells.
struct Distances {
    alignas(64) std::array<double, CellPoints::kRoom> d;
    std::size_t count;
    std::array<double, 3> best;
};

/// Metrics 1 and 2. The outer cells are looked at only if they can hold a nearer point.
template <bool Squared>
void measure(const glm::dvec3& p, CellPoints& cells, std::size_t wanted, Distances& out)
{
    out.count = CellPoints::kNear;
    distances<Squared>(p, cells, 0, CellPoints::kNear, out.d.data());
    out.best = smallest(out.d.data(), CellPoints::kNear, wanted);
    if (out.best[wanted - 1] < kOuterCells) return;
    cells.complete();
    out.count = CellPoints::kAll;
    constexpr std::size_t kWhole = CellPoints::kNear / numbers::lanes::kDoubles * numbers::lanes::kDoubles;
    distances<Squared>(p, cells, kWhole, CellPoints::kAll, out.d.data());
    out.best = smallest(out.d.data(), CellPoints::kAll, wanted);
}

template <bool Squared>
Finder nearest_plain(const glm::dvec3& p, CellPoints& cells, std::size_t wanted)
{
    Distances all;
    measure<Squared>(p, cells, wanted, all);
    Finder found;
    found.best = all.best;
    const Double least(all.best[0]);
    for (std::size_t i = 0; i < all.count; i += numbers::lanes::kDoubles)
        for (std::uint32_t equal = numbers::lanes::mask(Double::load_aligned(all.d.data() + i) == least); equal != 0;
             equal &= equal - 1) {
            const std::size_t cell = i + static_cast<std::size_t>(std::countr_zero(equal));
            if (cell >= all.count) break;
            if (found.nearest == CellPoints::kAll || kOffsets[cell].order < kOffsets[found.nearest].order)
                found.nearest = cell;
        }
    return found;
}

/// Numbers from 0 on, raised to a power above 0; behind them is room for a whole vector.
void raise(double* v, std::size_t count, double power)
{
    const Double least(1e-300), one(1.0), exponent(power);
    for (std::size_t i = 0; i < count; i += numbers::lanes::kDoubles) {
        const Double base = Double::load_aligned(v + i);
        const auto some = base >= least;
        xsimd::select(some, numbers::lanes::power(xsimd::select(some, base, one), exponent), Double(0.0))
            .store_aligned(v + i);
    }
}

/// Any metric above 0. A sum of powers costs much, so only those are built that can be among the nearest: lengths by
/// the metric m and by 2 differ by a factor of up to 3^|1/2 - 1/m| (the inequality between power means).
Finder nearest_powered(const glm::dvec3& p, CellPoints& cells, double metric, std::size_t wanted)
{
    constexpr double kSlack = 1.0 + 1e-6;  // far above the rounding of lengths
    Distances squares;
    measure<true>(p, cells, wanted, squares);
    const double limit = squares.best[wanted - 1] * numbers::pow(9.0, std::abs(0.5 - 1.0 / metric)) * kSlack;
    if (!(limit < kOuterCells) && squares.count == CellPoints::kNear) {
        cells.complete();
        squares.count = CellPoints::kAll;
        distances<true>(p, cells, 0, CellPoints::kAll, squares.d.data());
    }
    std::array<std::uint8_t, CellPoints::kRoom> cell;
    alignas(64) std::array<double, 3 * CellPoints::kRoom> parts;
    std::size_t count = 0;
    for (std::size_t i = 0; i < squares.count; i += numbers::lanes::kDoubles)
        for (std::uint32_t near = numbers::lanes::mask(Double::load_aligned(squares.d.data() + i) <= Double(limit));
             near != 0; near &= near - 1) {
            const std::size_t at = i + static_cast<std::size_t>(std::countr_zero(near));
            if (at >= squares.count) break;
            cell[count] = static_cast<std::uint8_t>(at);
            parts[3 * count] = std::abs(p.x - cells.x[at]);
            parts[3 * count + 1] = std::abs(p.y - cells.y[at]);
            parts[3 * count + 2] = std::abs(p.z - cells.z[at]);
            ++count;
        }
    raise(parts.data(), 3 * count, metric);
    Finder found;
    for (std::size_t i = 0; i < count; ++i) found.take(parts[3 * i] + parts[3 * i + 1] + parts[3 * i + 2], cell[i]);
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

/// Of the cells about a base cell, axis by axis: from two below it to two above.
class CellAxes {
public:
    CellAxes(const glm::dvec3& base, const glm::ivec3& repeat)
    {
        for (int k = 0; k < 3; ++k)
            for (int step = -2; step <= 2; ++step) {
                const double at = base[k] + step;
                cells_[axis(k)][place(step)] = at;
                index_[axis(k)][place(step)] = static_cast<std::size_t>(cell_number(at, repeat[k]) & kMask);
            }
    }

    /// cell_hash() of the cells that share x and y, as far as it goes without z.
    std::size_t column(int x, int y) const
    {
        const auto& t = kNoiseTables.hash;
        return t[t[index_[0][place(x)]] ^ index_[1][place(y)]];
    }
    void put(CellPoints& out, std::size_t i, const Offset& cell, std::size_t column) const
    {
        const double* random = kNoiseTables.random.data() + kNoiseTables.hash[column ^ index_[2][place(cell.z)]];
        out.x[i] = cells_[0][place(cell.x)] + random[0];
        out.y[i] = cells_[1][place(cell.y)] + random[1];
        out.z[i] = cells_[2][place(cell.z)] + random[2];
    }

private:
    static constexpr long long kMask = NoiseTables::kHashSize - 1;
    static long long cell_number(double at, int repeat)
    {
        const long long number = numbers::truncated_far(at);
        if (repeat == 0) return number;
        const long long left = number % repeat;
        return left < 0 ? left + repeat : left;
    }
    static constexpr std::size_t axis(int k) { return static_cast<std::size_t>(k); }
    static constexpr std::size_t place(int step) { return static_cast<std::size_t>(step + 2); }

    std::array<std::array<double, 5>, 3> cells_;
    std::array<std::array<std::size_t, 5>, 3> index_;
};

}  // namespace

void CellPoints::move_to(const glm::dvec3& base_cell, const glm::ivec3& repeat)
{
    base_ = base_cell;
    repeat_ = repeat;
    count_ = kNear;
    const CellAxes axes(base_cell, repeat);
    constexpr std::size_t kColumn = 3;  // cells, behind each other
    for (std::size_t i = 0; i < kNear; i += kColumn) {
        const std::size_t column = axes.column(kOffsets[i].x, kOffsets[i].y);
        for (std::size_t k = i; k < i + kColumn; ++k) axes.put(*this, k, kOffsets[k], column);
    }
    for (std::size_t i = kNear; i < 32; ++i) x[i] = y[i] = z[i] = numbers::kInfinity;
}

void CellPoints::complete()
{
    if (completed()) return;
    count_ = kAll;
    const CellAxes axes(base_, repeat_);
    for (std::size_t i = kNear; i < kAll; ++i)
        axes.put(*this, i, kOffsets[i], axes.column(kOffsets[i].x, kOffsets[i].y));
    for (std::size_t i = kAll; i < kRoom; ++i) x[i] = y[i] = z[i] = numbers::kInfinity;
}

CellPoints& cell_points(const glm::dvec3& base_cell, const glm::ivec3& repeat)
{
    constexpr std::size_t kKept = 32;  // four by four by two cells beside each other, 70 KB: not of every thread
    thread_local const auto all = std::make_unique<std::array<CellPoints, kKept>>();
    const auto part = [&](int k, long long mask) {
        return static_cast<std::size_t>(static_cast<long long>(base_cell[k]) & mask);
    };
    CellPoints& cells = (*all)[part(0, 3) | part(1, 3) << 2 | part(2, 1) << 4];
    if (!cells.are_of(base_cell, repeat)) cells.move_to(base_cell, repeat);
    return cells;
}

NearestCells nearest_cells(const glm::dvec3& p, CellPoints& cells, double metric, bool signed_sum, int wanted)
{
    const Finder found = find(p, cells, metric, signed_sum, static_cast<std::size_t>(wanted));
    const std::size_t at = found.nearest;
    return {found.best, at == CellPoints::kAll ? p : glm::dvec3(cells.x[at], cells.y[at], cells.z[at])};
}

std::array<double, 3> nearest_distances(const glm::dvec3& p, CellPoints& cells, double metric, int wanted)
{
    const auto count = static_cast<std::size_t>(wanted);
    if (metric != 1.0 && metric != 2.0) return find(p, cells, metric, false, count).best;
    Distances all;
    if (metric == 2.0) measure<true>(p, cells, count, all);
    else measure<false>(p, cells, count, all);
    return all.best;
}

}  // namespace texture
