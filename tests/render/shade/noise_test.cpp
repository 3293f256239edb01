#include "render/texture/points/angle.h"
#include "numbers/functions/functions.h"
#include "numbers/lane_power.h"
#include "render/texture/noise/nearest_cells.h"
#include "render/texture/noise/noise.h"
#include "render/texture/noise/noise_points.h"
#include "render/texture/noise/noise_tables.h"
#include "tests/render/shade/random_points.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <cmath>
#include <numbers>
#include <random>

using namespace texture;

namespace {

/// A point's cell, and a row of the lattice for each corner (bit 0 of its number: along x).
struct PlainCell {
    glm::dvec3 fraction;
    std::array<std::size_t, 8> rows;

    explicit PlainCell(const glm::dvec3& p)
    {
        const auto& t = kNoiseTables;
        std::array<std::size_t, 3> index;
        for (int k = 0; k < 3; ++k) {
            const double moved = p[k] >= 0 ? p[k] : p[k] - (1.0 - 1e-10);
            const int whole = moved >= -2147483648.0 && moved < 2147483648.0 ? static_cast<int>(moved) : INT32_MIN;
            index[static_cast<std::size_t>(k)] = (static_cast<std::uint32_t>(whole) + 10000u) & 4095u;
            fraction[k] = p[k] - whole;
        }
        for (std::size_t c = 0; c < 8; ++c) {
            const std::size_t h = t.hash[t.hash[(index[0] + (c & 1)) & 4095] ^ ((index[1] + ((c >> 1) & 1)) & 4095)];
            rows[c] = t.hash[h ^ ((index[2] + (c >> 2)) & 4095)] & 255u;
        }
    }
};

/// The formula of spec 4, 2.2 to 2.5, corner by corner in plain numbers; the order of sums is the one lattice.h names.
std::array<double, 3> plain_lattice(const glm::dvec3& p)
{
    const PlainCell cell(p);
    const glm::dvec3 f = cell.fraction, s = f * f * (3.0 - 2.0 * f);
    std::array<double, 3> sums;
    for (std::size_t r = 0; r < 3; ++r) {
        double part[4];
        for (std::size_t e = 0; e < 4; ++e) {
            const auto corner = [&](std::size_t c) {
                const bool high[3] = {(c & 1) != 0, (c & 2) != 0, (c & 4) != 0};
                const double factor = e == 0 ? 0.5 : f[static_cast<int>(e) - 1] - (high[e - 1] ? 1.0 : 0.0);
                const double share = (high[0] ? s.x : 1 - s.x) * (high[1] ? s.y : 1 - s.y) * (high[2] ? s.z : 1 - s.z);
                return factor * share * kNoiseTables.lattice[cell.rows[c] + 4 * r][e];
            };
            part[e] = ((corner(0) + corner(1)) + (corner(2) + corner(3))) +
                      ((corner(4) + corner(5)) + (corner(6) + corner(7)));
        }
        sums[r] = (part[0] + part[1]) + (part[2] + part[3]);
    }
    return sums;
}

/// The same formula (spec 4, 2.2 to 2.5) joined along x, y and z, in 64 bits of mantissa.
std::array<long double, 3> precise_lattice(const glm::dvec3& p)
{
    const PlainCell cell(p);
    std::array<long double, 3> sums;
    for (std::size_t r = 0; r < 3; ++r) {
        long double corner[8];
        for (std::size_t c = 0; c < 8; ++c) {
            const double* row = kNoiseTables.lattice[cell.rows[c] + 4 * r].data();
            corner[c] = 0.5L * row[0];
            for (int k = 0; k < 3; ++k)
                corner[c] += (static_cast<long double>(cell.fraction[k]) - ((c >> k) & 1)) * row[1 + k];
        }
        for (int k = 0; k < 3; ++k) {
            const long double f = cell.fraction[k], s = f * f * (3 - 2 * f);
            for (std::size_t c = 0; c < std::size_t{4} >> k; ++c)
                corner[c] = corner[2 * c] * (1 - s) + corner[2 * c + 1] * s;
        }
        sums[r] = corner[0];
    }
    return sums;
}

/// The same in single precision, cells and fractions aside; the order of sums is the one single_cells.h names. Points
/// out of all cells stay as they are.
std::array<double, 3> single_lattice(const glm::dvec3& p)
{
    const PlainCell cell(p);
    if (!glm::all(glm::lessThanEqual(cell.fraction, glm::dvec3(1)))) return plain_lattice(p);
    float f[3], s[3];
    for (int k = 0; k < 3; ++k) {
        f[k] = static_cast<float>(cell.fraction[k]);
        s[k] = f[k] * f[k] * (3.0f - 2.0f * f[k]);
    }
    std::array<double, 3> sums;
    for (std::size_t r = 0; r < 3; ++r) {
        float part[4];
        for (std::size_t e = 0; e < 4; ++e) {
            const auto corner = [&](std::size_t c) {
                const bool high[3] = {(c & 1) != 0, (c & 2) != 0, (c & 4) != 0};
                const float share = (high[0] ? s[0] : 1 - s[0]) * (high[1] ? s[1] : 1 - s[1]) *
                                    (high[2] ? s[2] : 1 - s[2]),
                            factor = e == 0 ? 0.5f : f[e - 1] - (high[e - 1] ? 1.0f : 0.0f);
                return factor * share * static_cast<float>(kNoiseTables.lattice[cell.rows[c] + 4 * r][e]);
            };
            const auto above = [&](std::size_t c) { return corner(c) + corner(c + 4); };
            part[e] = (above(0) + above(2)) + (above(1) + above(3));
        }
        sums[r] = static_cast<double>((part[0] + part[2]) + (part[1] + part[3]));
    }
    return sums;
}

}  // namespace

TEST_CASE("noise in lanes has the bits of the plain sum over corners", "[texture][noise]")
{
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const Points p = random_points(rng);
        const int generator = 1 + rng.below(2);
        Values many;
        Points vectors;
        noise_points(p, generator, many);
        vector_noise_points(p, kAllLive, vectors);
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto sums = plain_lattice(p.at(i));
            const double expected =
                std::clamp(generator == 1 ? sums[0] + 0.5 : (sums[0] + 1.05242) * 0.48985582, 0.0, 1.0);
            REQUIRE(bits(noise(p.at(i), generator)) == bits(expected));
            REQUIRE(bits(many[i]) == bits(expected));
            const glm::dvec3 one = vector_noise(p.at(i));
            for (int k = 0; k < 3; ++k) {
                REQUIRE(bits(one[k]) == bits(sums[static_cast<std::size_t>(k)]));
                REQUIRE(bits(vectors.at(i)[k]) == bits(one[k]));
            }
        }
    }
}

TEST_CASE("noise in single precision has the bits of its plain sum, near those of the double one", "[texture][noise]")
{
    double worst = 0.0;
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Points p = random_points(rng);
        p.density = true;
        const int generator = 1 + rng.below(2);
        Values many;
        Points vectors;
        noise_points(p, generator, many);
        vector_noise_points(p, kAllLive, vectors);
        vector_noise_points(p, 1u << rng.below(3), vectors);  // one alone says the same
        for (std::size_t i = 0; i < p.size(); ++i) {
            const glm::dvec3 at = p.at(i);
            const auto sums = single_lattice(at);
            const double expected =
                std::clamp(generator == 1 ? sums[0] + 0.5 : (sums[0] + 1.05242) * 0.48985582, 0.0, 1.0);
            REQUIRE(bits(many[i]) == bits(expected));
            worst = std::max(worst, std::abs(expected - noise(at, generator)));
            const glm::dvec3 whole = vector_noise(at);
            for (int k = 0; k < 3; ++k) {
                REQUIRE(bits(vectors.at(i)[k]) == bits(sums[static_cast<std::size_t>(k)]));
                worst = std::max(worst, std::abs(vectors.at(i)[k] - whole[k]));
            }
        }
    }
    INFO("largest difference " << worst);
    CHECK(worst < 5e-7);
}

TEST_CASE("sums of octaves that stop early differ from the whole ones only in flat ends", "[texture][noise]")
{
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Points p = random_points(rng);
        p.pad();
        const int generator = 1 + rng.below(3);
        const OctaveSum kind = rng.below(2) == 0 ? OctaveSum::Granite : OctaveSum::Wrinkles;
        FlatEnds flat;
        if (rng.below(4) != 0) flat.high = 0.1 * (1 + rng.below(8));
        if (rng.below(4) != 0) flat.low = std::min(0.1 * rng.below(9), flat.high);
        Values cut, whole;
        octave_points(p, kind, generator, flat, cut);
        octave_points(p, kind, generator, {}, whole);
        for (std::size_t i = 0; i < p.size(); ++i) {
            REQUIRE(bits(whole[i]) == bits(octaves_at(p.at(i), kind, generator)));
            if (whole[i] < flat.low) REQUIRE((cut[i] < flat.low && cut[i] <= whole[i]));
            else if (whole[i] < flat.high) REQUIRE(bits(cut[i]) == bits(whole[i]));
            else REQUIRE((cut[i] >= flat.high && cut[i] <= whole[i]));
        }
    }
}

TEST_CASE("vector noise is the formula's to the last bits", "[texture][noise]")
{
    double worst = 0.0;
    for (std::uint32_t seed = 0; seed < 200000; ++seed) {
        Rng rng(seed);
        const glm::dvec3 p = rng.vector(1000.0), n = vector_noise(p);
        const auto precise = precise_lattice(p);
        for (std::size_t k = 0; k < 3; ++k)
            worst = std::max(worst, static_cast<double>(std::abs(precise[k] - n[static_cast<int>(k)])));
    }
    INFO("largest error " << worst);
    CHECK(worst < 5e-16);  // measured: 3.97e-16
}

TEST_CASE("the sine of a turn is the sine to the last bits", "[texture][pattern]")
{
    double worst = 0.0;
    for (int i = 0; i <= 1000000; ++i) {
        const double v = i / 1e6;
        const long double truth = std::sin(2.0L * std::numbers::pi_v<long double> * v);
        worst = std::max(worst, static_cast<double>(std::abs(truth - static_cast<long double>(series_cycle(v)))));
        REQUIRE(series_cycle(-v) == -series_cycle(v));
    }
    INFO("largest error " << worst);
    CHECK(worst < 2e-16);  // measured: 1.77e-16
}

TEST_CASE("the nearest of scattered points are those of a search through all cells", "[texture][crackle]")
{
    for (std::uint32_t seed = 0; seed < 4000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const glm::dvec3 p = rng.vector(20.0), base = glm::floor(p - kTiny);
        const double metric = std::array{2.0, 1.0, 3.0, 0.5, 7.0, 200.0}[static_cast<std::size_t>(rng.below(6))];
        std::vector<double> all;
        glm::dvec3 nearest;
        for (int a = -2; a <= 2; ++a)
            for (int b = -2; b <= 2; ++b)
                for (int c = -2; c <= 2; ++c) {
                    if ((std::abs(a) == 2) + (std::abs(b) == 2) + (std::abs(c) == 2) > 1) continue;
                    const glm::dvec3 cell = base + glm::dvec3(a, b, c);
                    const int hash = cell_hash(static_cast<long long>(cell.x), static_cast<long long>(cell.y),
                                               static_cast<long long>(cell.z));
                    const glm::dvec3 at =
                        cell + glm::dvec3(pattern_random(hash), pattern_random(hash + 1), pattern_random(hash + 2));
                    const glm::dvec3 d = glm::abs(p - at);
                    const auto raised = [metric](double v) {  // steep powers are those of numbers/functions
                        return metric > 100.0 ? numbers::pow(v, metric)
                               : v > 0.0      ? numbers::lanes::power(v, metric)
                                              : 0.0;
                    };
                    for (int k = 0; k < 3; ++k)
                        REQUIRE(std::abs(raised(d[k]) - std::pow(d[k], metric)) <= 1e-13 * std::pow(d[k], metric));
                    const double powered = metric == 2.0   ? d.x * d.x + d.y * d.y + d.z * d.z
                                           : metric == 1.0 ? d.x + d.y + d.z
                                                           : raised(d.x) + raised(d.y) + raised(d.z);
                    if (all.empty() || powered < *std::min_element(all.begin(), all.end())) nearest = at;
                    all.push_back(powered);
                }
        std::sort(all.begin(), all.end());
        const int wanted = 1 + rng.below(3);
        CellPoints cells(base);
        const NearestCells found = nearest_cells(p, cells, metric, false, wanted);
        for (std::size_t i = 0; i < static_cast<std::size_t>(wanted); ++i)
            REQUIRE(bits(found.powered[i]) == bits(all[i]));
        REQUIRE(found.point == nearest);
        const auto lengths = nearest_distances(p, cell_points(base), metric, wanted);
        for (std::size_t i = 0; i < static_cast<std::size_t>(wanted); ++i) REQUIRE(bits(lengths[i]) == bits(all[i]));
    }
}

TEST_CASE("the points of a cell are the same whichever cells were asked for before", "[texture][crackle]")
{
    const auto same = [](const CellPoints& a, const CellPoints& b) {
        for (std::size_t i = 0; i < a.count(); ++i)
            if (a.x[i] != b.x[i] || a.y[i] != b.y[i] || a.z[i] != b.z[i]) return false;
        return a.count() <= b.count();
    };
    Rng rng(1);
    for (int round = 0; round < 4000; ++round) {
        const double far = std::array{4.0, 50.0, 1e17}[static_cast<std::size_t>(rng.below(3))];
        const glm::dvec3 base = glm::floor(rng.vector(far));
        CellPoints fresh(base);
        REQUIRE(same(fresh, cell_points(base)));
        if (!rng.flip()) continue;
        fresh.complete();
        cell_points(base).complete();
        REQUIRE(same(fresh, cell_points(base)));
    }
}

TEST_CASE("tables that a compiler works out are those of the library's generator and root", "[texture][noise]")
{
    std::mt19937 generator(5489u);
    for (const double r : kNoiseTables.random) REQUIRE(r == static_cast<double>(generator()) / 4294967296.0);
    std::uint32_t state = 1;
    for (const glm::dvec3& g : kNoiseTables.gradient) {
        glm::dvec3 v;
        double q = 0.0;
        do {
            for (int k = 0; k < 3; ++k) v[k] = static_cast<double>((draw15(state) % 4096) - 2048) / 2048.0;
            q = glm::dot(v, v);
        } while (q < 1e-5 || q > 1.0);
        REQUIRE(g == v / std::sqrt(q));
    }
}
