#include "render/texture/angle.h"
#include "render/texture/evaluate_points.h"
#include "render/texture/function_host.h"
#include "render/texture/noise/nearest_cells.h"
#include "render/texture/noise/noise.h"
#include "render/texture/noise/noise_points.h"
#include "render/texture/noise/noise_tables.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <random>

using namespace texture;

namespace {

std::uint64_t bits(double v) { return std::bit_cast<std::uint64_t>(v); }
std::uint32_t bits(float v) { return std::bit_cast<std::uint32_t>(v); }

struct Rng {
    std::mt19937 engine;
    explicit Rng(std::uint32_t seed) : engine(seed) {}
    double uniform(double low, double high)
    {
        return low + (high - low) * (static_cast<double>(engine()) / 4294967296.0);
    }
    int below(int n) { return static_cast<int>(engine() % static_cast<std::uint32_t>(n)); }
    bool flip() { return below(2) == 0; }
    glm::dvec3 vector(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
};

/// Within one lattice cell, over many, as far out as warped points get, or on the lattice itself.
Points random_points(Rng& rng)
{
    Points p;
    const double spread = std::array{0.01, 1.0, 100.0, 1e6, 1e15}[static_cast<std::size_t>(rng.below(5))];
    const bool whole = rng.below(6) == 0;
    const glm::dvec3 middle = rng.vector(50.0);
    for (int i = 0, count = 1 + rng.below(kMostPoints); i < count; ++i) {
        const glm::dvec3 q = middle + rng.vector(spread);
        p.add(whole ? glm::round(q) : q);
    }
    p.pad();
    return p;
}

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
                return factor * share * kNoiseTables.lattice[cell.rows[c] + 4 * r + e];
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
            const double* row = kNoiseTables.lattice.data() + cell.rows[c] + 4 * r;
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

Pattern random_pattern(Rng& rng, TextureSet& set)
{
    using K = PatternKind;
    constexpr std::array kKinds{K::Bozo,   K::Dents,       K::Granite, K::Wrinkles, K::Agate,   K::Marble,
                                K::Wood,   K::Crackle,     K::Crackle, K::Mandel,   K::Julia,   K::Gradient,
                                K::Planar, K::Cylindrical, K::Checker, K::Leopard,  K::Spiral1, K::Cells};
    constexpr std::array kMetrics{2.0, 2.0, 1.0, 3.0, 1.5, 0.7, 130.0};
    Pattern p;
    p.kind = kKinds[static_cast<std::size_t>(rng.below(kKinds.size()))];
    p.noise_generator = static_cast<std::uint8_t>(1 + rng.below(3));
    p.wave = static_cast<scene::WaveForm>(rng.below(5));
    p.has_turbulence = rng.flip();
    const bool inside = p.kind == K::Agate || p.kind == K::Marble || p.kind == K::Wood || p.kind == K::Spiral1;
    p.displaces = p.has_turbulence && !inside;
    p.turbulence = {rng.vector(1.0), 1 + rng.below(8), rng.uniform(1.5, 2.5), rng.uniform(0.3, 0.7)};
    for (int k = 0; k < 3; ++k)
        if (rng.below(3) == 0) p.turbulence.amount[k] = 0.0;
    p.frequency = rng.uniform(-3.0, 3.0);
    p.phase = rng.uniform(-1.0, 1.0);
    p.vector = rng.vector(1.0);
    if (rng.flip()) p.vector.z = 0.0;
    if (rng.flip()) p.vector.y = 0.0;
    if (p.kind == K::Crackle)
        p.numbers = {kMetrics[static_cast<std::size_t>(rng.below(kMetrics.size()))], rng.flip() ? 0.0 : 0.3,
                     rng.below(4) == 0 ? 1.0 : 0.0};
    else if (p.kind == K::Mandel || p.kind == K::Julia)
        p.numbers = {1.0 + rng.below(40),   2.0 + rng.below(3),   double(rng.below(9)),
                     rng.uniform(0.5, 3.0), double(rng.below(7)), rng.uniform(-1.0, 1.0)};
    else p.numbers = {rng.uniform(0.0, 2.0)};
    p.first_warp = static_cast<std::uint32_t>(set.warps.size());
    p.warp_count = static_cast<std::uint32_t>(rng.below(3));
    for (std::uint32_t i = 0; i < p.warp_count; ++i) switch (rng.below(3)) {
        case 0:
            set.warps.push_back(Affine{glm::dmat3(rng.vector(1.0), rng.vector(1.0), rng.vector(1.0)), rng.vector(1.0)});
            break;
        case 1:
            set.warps.push_back(
                scene::Turbulence{rng.flip() ? glm::dvec3(0, 0.5, 0) : rng.vector(1.0), 1 + rng.below(6)});
            break;
        default: set.warps.push_back(scene::RepeatWarp{{0, 1.5, 0}, {0.3, 0, 0}, {0, 1, 0}});
        }
    return p;
}

/// A pigment of up to `depth` more levels of maps; its index.
std::uint32_t random_pigment(Rng& rng, TextureSet& set, int depth)
{
    using Kind = Pigment::Kind;
    Pigment pigment;
    pigment.kind = depth == 0 || rng.flip() ? (rng.below(6) == 0 ? Kind::Solid : Kind::ColorMap)
                   : rng.below(4) == 0      ? Kind::Average
                                            : Kind::PigmentMap;
    const auto color = [&] {
        return scene::Color{float(rng.uniform(0, 1)), float(rng.uniform(0, 1)), float(rng.uniform(0, 1)), 0.1f,
                            float(rng.uniform(0, 1))};
    };
    pigment.color = color();
    pigment.count = static_cast<std::uint32_t>(1 + rng.below(rng.below(4) == 0 ? 12 : 5));
    std::vector<std::uint32_t> children(pigment.count, 0);
    if (pigment.kind == Kind::PigmentMap || pigment.kind == Kind::Average)
        for (auto& child : children) child = random_pigment(rng, set, depth - 1);
    pigment.pattern = static_cast<std::uint32_t>(set.patterns.size());
    set.patterns.push_back(random_pattern(rng, set));
    pigment.first = static_cast<std::uint32_t>(set.keys.size());
    for (std::uint32_t i = 0; i < pigment.count; ++i) {
        set.keys.push_back((float(i) + 0.5f) / float(pigment.count));
        set.colors.push_back(color());
        set.children.push_back(children[i]);
    }
    set.pigments.push_back(pigment);
    return static_cast<std::uint32_t>(set.pigments.size() - 1);
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
                    const double powered = metric == 2.0 ? d.x * d.x + d.y * d.y + d.z * d.z
                                           : metric == 1.0
                                               ? d.x + d.y + d.z
                                               : std::pow(d.x, metric) + std::pow(d.y, metric) + std::pow(d.z, metric);
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

TEST_CASE("pigments of many points have the bits of each point alone", "[texture][pigment]")
{
    for (std::uint32_t seed = 0; seed < 6000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        TextureSet set;
        const std::uint32_t pigment = random_pigment(rng, set, 2);
        const Points p = random_points(rng);
        const Surroundings none;
        Around around;
        around.fill(&none);
        ColorPoints colors;
        pigment_colors(set, pigment, p, around, colors);
        for (std::size_t i = 0; i < p.size(); ++i) {
            const scene::Color c = pigment_color(set, pigment, p.at(i), none), m = colors.at(i);
            REQUIRE(bits(c.red) == bits(m.red));
            REQUIRE(bits(c.green) == bits(m.green));
            REQUIRE(bits(c.blue) == bits(m.blue));
            REQUIRE(bits(c.filter) == bits(m.filter));
            REQUIRE(bits(c.transmit) == bits(m.transmit));
        }
    }
}

TEST_CASE("eight points that a function asks for have the bits of each point alone", "[texture][function]")
{
    const auto same = [](double a, double b) { return bits(a) == bits(b) || (a != a && b != b); };
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        TextureSet set;
        const std::uint32_t pigment = random_pigment(rng, set, 1),
                            pattern = static_cast<std::uint32_t>(rng.below(static_cast<int>(set.patterns.size())));
        const Points p = random_points(rng);
        const FunctionHost host(set);
        alignas(64) std::array<std::array<double, function::kLanes>, 3> at;
        alignas(64) std::array<std::array<double, function::kLanes>, 6> out;
        for (std::size_t i = 0; i < function::kLanes; ++i)
            for (std::size_t k = 0; k < 3; ++k) at[k][i] = p.at(i % p.size())[static_cast<int>(k)];
        host.patterns(pattern, at[0].data(), at[1].data(), at[2].data(), out[5].data());
        host.pigments(pigment, at[0].data(), at[1].data(), at[2].data(),
                      {out[0].data(), out[1].data(), out[2].data(), out[3].data(), out[4].data()});
        for (std::size_t i = 0; i < function::kLanes; ++i) {
            const glm::dvec3 q = p.at(i % p.size());
            const auto color = host.pigment(pigment, q);
            for (std::size_t k = 0; k < color.size(); ++k) REQUIRE(same(color[k], out[k][i]));
            REQUIRE(same(host.pattern(pattern, q), out[5][i]));
        }
    }
}

TEST_CASE("pattern values of many points have the bits of each point alone", "[texture]")
{
    for (std::uint32_t seed = 0; seed < 6000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        TextureSet set;
        const Pattern pattern = random_pattern(rng, set);
        Points p = random_points(rng);
        const Points before = p;
        warp_points(set, pattern, p, kAllLive);
        const Surroundings none;
        Around around;
        around.fill(&none);
        Values values;
        pattern_values(set, pattern, p, around, values);
        for (std::size_t i = 0; i < p.size(); ++i) {
            const glm::dvec3 q = warp_point(set, pattern, before.at(i));
            // A coordinate that is not displaced keeps the sign of its zero; nothing looks at it.
            for (int k = 0; k < 3; ++k) REQUIRE((q[k] == p.at(i)[k] || (q[k] != q[k] && p.at(i)[k] != p.at(i)[k])));
            const double v = pattern_value(set, pattern, q, none);
            REQUIRE((bits(values[i]) == bits(v) || (v != v && values[i] != values[i])));
        }
    }
}

TEST_CASE("normals of many points have the bits of each bent alone", "[texture][normal]")
{
    using Map = Normal::Map;
    for (std::uint32_t seed = 0; seed < 6000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        TextureSet set;
        Normal normal;
        normal.map =
            std::array{Map::None, Map::None, Map::Slopes, Map::Average}[static_cast<std::size_t>(rng.below(4))];
        normal.amount = rng.uniform(-1.0, 1.0);
        normal.no_bump_scale = rng.flip();
        normal.count = 1 + static_cast<std::uint32_t>(rng.below(3));
        if (normal.map == Map::Average)
            set.normals.push_back({Map::None, 0, 0.3});  // of its own, bent by the first pattern
        for (std::uint32_t i = 0; i < normal.count; ++i) {
            set.keys.push_back((float(i) + 0.5f) / float(normal.count));
            set.slopes.emplace_back(rng.uniform(0.0, 1.0), rng.uniform(-1.0, 1.0));
            set.children.push_back(0);
        }
        Pattern pattern = random_pattern(rng, set);
        using K = PatternKind;
        if (rng.flip())
            pattern.kind = std::array{K::Bumps, K::Dents, K::Wrinkles, K::Quilted,
                                      K::Facets}[static_cast<std::size_t>(rng.below(5))];
        if (pattern.kind == K::Facets || pattern.kind == K::Quilted)
            pattern.numbers = {rng.uniform(0.1, 1.0), rng.uniform(0.1, 1.0), 2.0};
        set.patterns.push_back(pattern);
        set.normals.push_back(normal);
        const auto index = static_cast<std::uint32_t>(set.normals.size() - 1);
        set.normals.back().pattern = set.normals.front().pattern = 0;
        const Points p = random_points(rng);
        const Surroundings none;
        Around around;
        around.fill(&none);
        Points many;
        for (std::size_t i = 0; i < p.size(); ++i) many.add(glm::normalize(rng.vector(1.0)));
        many.pad();
        const Points before = many;
        perturb_points(set, index, p, around, many);
        for (std::size_t i = 0; i < p.size(); ++i) {
            Surroundings own = none;
            const glm::dvec3 one = perturb(set, index, before.at(i), p.at(i), own);
            for (int k = 0; k < 3; ++k)
                REQUIRE((bits(many.at(i)[k]) == bits(one[k]) || (one[k] != one[k] && many.at(i)[k] != many.at(i)[k])));
        }
    }
}
