#include "render/texture/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace texture {
namespace {

constexpr int kHashSize = 4096;
constexpr int kGradients = 2048;
constexpr double kNearlyOne = 1.0 - 1e-10;            // cells of negative coordinates, spec 4, 2.2
constexpr double kGradientOffset = 10000000.023157213;  // generator 3: moves lattice points off the integers
constexpr int kRandoms = 4100;                        // cell hashes are below 4096, plus three components

constexpr std::array<double, 267> kLattice = {
#include "render/texture/noise_lattice.inc"
};

int draw15(std::uint32_t& state)
{
    state = next_lcg(state);
    return static_cast<int>((state >> 16) & 0x7FFFu);
}

struct Tables {
    std::array<std::uint16_t, 2 * kHashSize> hash;
    std::array<glm::dvec3, kGradients> gradient;
    std::array<int, kGradients + 1> permutation;
    std::array<double, kRandoms> random;

    Tables()
    {
        fill_hash();
        fill_gradients();
        std::mt19937 generator(5489u);
        for (double& r : random) r = static_cast<double>(generator()) / 4294967296.0;
    }

private:
    void fill_hash()
    {
        for (std::size_t i = 0; i < kHashSize; ++i) hash[i] = static_cast<std::uint16_t>(i);
        std::uint32_t state = 0;
        for (std::size_t i = kHashSize - 1;; --i) {
            const auto j = static_cast<std::size_t>(draw15(state) % kHashSize);
            std::swap(hash[i], hash[j]);
            if (i == 0) break;
        }
        for (std::size_t i = 0; i < kHashSize; ++i) hash[kHashSize + i] = hash[i];
    }

    void fill_gradients()
    {
        std::uint32_t state = 1;
        for (glm::dvec3& g : gradient) {
            double q;
            do {
                for (int k = 0; k < 3; ++k) g[k] = static_cast<double>((draw15(state) % 4096) - 2048) / 2048.0;
                q = glm::dot(g, g);
            } while (q < 1e-5 || q > 1.0);
            g /= std::sqrt(q);
        }
        for (std::size_t i = 0; i < kGradients; ++i) permutation[i] = static_cast<int>(i);
        permutation[kGradients] = 0;
        // Only even places are visited and the first swaps in the extra 0: measured, not tidied.
        for (std::size_t i = kGradients; i >= 2; i -= 2) {
            const auto j = static_cast<std::size_t>(draw15(state) % kGradients);
            std::swap(permutation[i], permutation[j]);
        }
    }
};

const Tables kTables;

struct Cell {
    int index;
    double fraction;
};

/// Cell of a coordinate for generators 1, 2 and vector noise; saturates where 32 bits do not hold it.
Cell cell(double v)
{
    const double moved = v >= 0 ? v : v - kNearlyOne;
    const int whole = moved >= -2147483648.0 && moved < 2147483648.0 ? static_cast<int>(moved) : INT32_MIN;
    const auto shifted = static_cast<std::uint32_t>(whole) + 10000u;
    return {static_cast<int>(shifted & 4095u), v - whole};
}

double smooth(double f) { return f * f * (3.0 - 2.0 * f); }

/// Sum over the corners of a cell of weight * row(table offset); Rows of them are summed at once.
template <int Rows> std::array<double, Rows> lattice_sum(const glm::dvec3& p)
{
    const Cell x = cell(p.x), y = cell(p.y), z = cell(p.z);
    const double sx = smooth(x.fraction), sy = smooth(y.fraction), sz = smooth(z.fraction);
    std::array<std::array<double, 4 * Rows>, 8> corner;
    for (int c = 0; c < 8; ++c) {
        const int dx = c & 1, dy = (c >> 1) & 1, dz = c >> 2;
        const auto& t = kTables.hash;
        const int h2 = t[static_cast<std::size_t>(t[static_cast<std::size_t>(x.index + dx)] ^ (y.index + dy))];
        const auto k = static_cast<std::size_t>(t[static_cast<std::size_t>(h2 ^ (z.index + dz))] & 255);
        for (std::size_t r = 0; r < Rows; ++r) {
            auto* out = &corner[static_cast<std::size_t>(c)][4 * r];
            out[0] = 0.5 * kLattice[k + 4 * r];
            out[1] = (x.fraction - dx) * kLattice[k + 4 * r + 1];
            out[2] = (y.fraction - dy) * kLattice[k + 4 * r + 2];
            out[3] = (z.fraction - dz) * kLattice[k + 4 * r + 3];
        }
    }
    // One order of sums everywhere (x, then y, then z, then the parts), so every variant gives the same bits.
    std::array<double, Rows> sum;
    for (std::size_t r = 0; r < Rows; ++r) {
        std::array<double, 4> part;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t e = 4 * r + i;
            const double a = corner[0][e] * (1 - sx) + corner[1][e] * sx;
            const double b = corner[2][e] * (1 - sx) + corner[3][e] * sx;
            const double c = corner[4][e] * (1 - sx) + corner[5][e] * sx;
            const double d = corner[6][e] * (1 - sx) + corner[7][e] * sx;
            const double low = a * (1 - sy) + b * sy, high = c * (1 - sy) + d * sy;
            part[i] = low * (1 - sz) + high * sz;
        }
        sum[r] = (part[0] + part[1]) + (part[2] + part[3]);
    }
    return sum;
}

struct GradientCell {
    std::size_t low, high;
    double fraction;
};

GradientCell gradient_cell(double v)
{
    const double t = v + kGradientOffset;
    const double b = std::floor(t);
    const bool usable = std::abs(b) < 9e15;
    const auto index = static_cast<std::size_t>((usable ? static_cast<long long>(b) : 0) & (kGradients - 1));
    return {index, (index + 1) & (kGradients - 1), t - b};
}

double gradient_noise(const glm::dvec3& p)
{
    const GradientCell x = gradient_cell(p.x), y = gradient_cell(p.y), z = gradient_cell(p.z);
    const auto& perm = kTables.permutation;
    const auto corner = [&](int dx, int dy, int dz) {
        const std::size_t bx = dx ? x.high : x.low, by = dy ? y.high : y.low, bz = dz ? z.high : z.low;
        const auto px = static_cast<std::size_t>(perm[bx]);
        const auto pxy = static_cast<std::size_t>(perm[(px + by) & (kGradients - 1)]);
        const glm::dvec3& g = kTables.gradient[(pxy + bz) & (kGradients - 1)];
        return g.x * (x.fraction - dx) + g.y * (y.fraction - dy) + g.z * (z.fraction - dz);
    };
    const double sx = smooth(x.fraction), sy = smooth(y.fraction), sz = smooth(z.fraction);
    const auto along_x = [&](int dy, int dz) {
        return corner(0, dy, dz) * (1 - sx) + corner(1, dy, dz) * sx;
    };
    const double low = along_x(0, 0) * (1 - sy) + along_x(1, 0) * sy;
    const double high = along_x(0, 1) * (1 - sy) + along_x(1, 1) * sy;
    return low * (1 - sz) + high * sz;
}

double clamp01(double v) { return std::clamp(v, 0.0, 1.0); }

}  // namespace

double noise(const glm::dvec3& p, int generator)
{
    if (generator == 3) return clamp01(0.5 * (1.59 * gradient_noise(p) + 0.985));
    const double raw = lattice_sum<1>(p)[0];
    return generator == 1 ? clamp01(raw + 0.5) : clamp01((raw + 1.05242) * 0.48985582);
}

glm::dvec3 vector_noise(const glm::dvec3& p)
{
    const std::array<double, 3> sum = lattice_sum<3>(p);
    return {sum[0], sum[1], sum[2]};
}

glm::dvec3 vector_turbulence(const glm::dvec3& p, int octaves, double lambda, double omega)
{
    glm::dvec3 sum = vector_noise(p);
    double l = lambda, o = omega;
    for (int i = 1; i < octaves; ++i) {
        sum += o * vector_noise(l * p);
        l *= lambda;
        o *= omega;
    }
    return sum;
}

double scalar_turbulence(const glm::dvec3& p, int octaves, double lambda, double omega, int generator)
{
    const auto term = [generator](const glm::dvec3& q) {
        const double n = noise(q, generator);
        return generator == 1 ? n : 2.0 * n - 0.5;
    };
    double sum = generator == 1 ? term(p) : clamp01(term(p));
    double l = lambda, o = omega;
    for (int i = 1; i < octaves; ++i) {
        sum += o * term(l * p);
        l *= lambda;
        o *= omega;
    }
    return sum;
}

int cell_hash(long long x, long long y, long long z)
{
    const auto& t = kTables.hash;
    const auto a = static_cast<std::size_t>(t[static_cast<std::size_t>(x & 4095)] ^ (y & 4095));
    return t[static_cast<std::size_t>(t[a] ^ (z & 4095))];
}

double pattern_random(int i) { return kTables.random[static_cast<std::size_t>(i)]; }

void wave_sources(int count, glm::dvec3* points, double* frequencies)
{
    auto state = static_cast<std::uint32_t>(-560851967);
    for (int i = 0; i < count; ++i) {
        points[i] = glm::normalize(vector_noise({static_cast<double>(i), 0.0, 0.0}));
        frequencies[i] = draw15(state) * 0.000030518509476 + 0.01;
    }
}

}  // namespace texture
