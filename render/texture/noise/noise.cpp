#include "render/texture/noise/noise.h"

#include "numbers/rounding.h"
#include "render/texture/noise/lattice.h"
#include "render/texture/noise/noise_tables.h"

#include <cmath>

namespace texture {
namespace {

constexpr double kGradientOffset = 10000000.023157213;  // generator 3: moves lattice points off the integers

struct Cell {
    CellIndex index;
    double fraction;
};

/// Cell of a coordinate for generators 1, 2 and vector noise; saturates where 32 bits do not hold it.
Cell cell(double v)
{
    const double moved = v >= 0 ? v : v - kNearlyOne;
    const int whole = numbers::truncated(moved);
    const std::uint32_t index = static_cast<std::uint32_t>(whole) + std::uint32_t{kCellOffset}, mask = kLatticeMask;
    return {{index & mask, (index + 1) & mask}, v - whole};
}

/// Sums over the corners of the cell of p.
template <int Rows>
void lattice_sums(const glm::dvec3& p, double (&sums)[Rows])
{
    const Cell x = cell(p.x), y = cell(p.y), z = cell(p.z);
    const double* rows[8];
    corner_rows(x.index, y.index, z.index, first_row(0), rows);
    double shares[8];
    corner_shares(smooth(x.fraction), smooth(y.fraction), smooth(z.fraction),
                  [&](int c, double share) { shares[c] = share; });
    Row totals[Rows];
    row_sums<Rows, 1>(Row::of(0.5, x.fraction, y.fraction, z.fraction), shares, rows, totals);
    for (int r = 0; r < Rows; ++r) sums[r] = totals[r].total();
}

struct GradientCell {
    std::size_t low, high;
    double fraction;
};

GradientCell gradient_cell(double v)
{
    constexpr std::size_t kMask = NoiseTables::kGradients - 1;
    const double t = v + kGradientOffset;
    const double b = std::floor(t);
    const bool usable = std::abs(b) < 9e15;
    const auto index = static_cast<std::size_t>(usable ? static_cast<long long>(b) : 0) & kMask;
    return {index, (index + 1) & kMask, t - b};
}

double gradient_noise(const glm::dvec3& p)
{
    constexpr std::size_t kMask = NoiseTables::kGradients - 1;
    const GradientCell x = gradient_cell(p.x), y = gradient_cell(p.y), z = gradient_cell(p.z);
    const auto& perm = kNoiseTables.permutation;
    const auto corner = [&](int dx, int dy, int dz) {
        const std::size_t bx = dx ? x.high : x.low, by = dy ? y.high : y.low, bz = dz ? z.high : z.low;
        const auto px = static_cast<std::size_t>(perm[bx]);
        const auto pxy = static_cast<std::size_t>(perm[(px + by) & kMask]);
        const glm::dvec3& g = kNoiseTables.gradient[(pxy + bz) & kMask];
        return g.x * (x.fraction - dx) + g.y * (y.fraction - dy) + g.z * (z.fraction - dz);
    };
    const double sx = smooth(x.fraction), sy = smooth(y.fraction), sz = smooth(z.fraction);
    const auto along_x = [&](int dy, int dz) { return corner(0, dy, dz) * (1 - sx) + corner(1, dy, dz) * sx; };
    const double low = along_x(0, 0) * (1 - sy) + along_x(1, 0) * sy;
    const double high = along_x(0, 1) * (1 - sy) + along_x(1, 1) * sy;
    return low * (1 - sz) + high * sz;
}

}  // namespace

double noise(const glm::dvec3& p, int generator)
{
    if (generator == 3) return clamp01(0.5 * (1.59 * gradient_noise(p) + 0.985));
    double raw[1];
    lattice_sums(p, raw);
    return noise_of_sum(raw[0], generator);
}

glm::dvec3 vector_noise(const glm::dvec3& p)
{
    double sums[3];
    lattice_sums(p, sums);
    return {sums[0], sums[1], sums[2]};
}

int cell_hash(long long x, long long y, long long z)
{
    const auto& t = kNoiseTables.hash;
    const auto a = static_cast<std::size_t>(t[static_cast<std::size_t>(x & 4095)] ^ (y & 4095));
    return t[static_cast<std::size_t>(t[a] ^ (z & 4095))];
}

double pattern_random(int i) { return kNoiseTables.random[static_cast<std::size_t>(i)]; }

void wave_sources(int count, glm::dvec3* points, double* frequencies)
{
    auto state = static_cast<std::uint32_t>(-560851967);
    for (int i = 0; i < count; ++i) {
        points[i] = glm::normalize(vector_noise({static_cast<double>(i), 0.0, 0.0}));
        frequencies[i] = draw15(state) * 0.000030518509476 + 0.01;
    }
}

}  // namespace texture
