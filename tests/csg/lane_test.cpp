#include "csg/packet/lanes/lane_quartic.h"
#include "csg/packet/lanes/lane_solids.h"
#include "csg/packet/point_set.h"
#include "csg/packet/lanes/tile_rays.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

using namespace csg;
using csg_test::Rng;

namespace {

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Directions that meet, miss, graze and run along the axes of a solid near `target`.
glm::dvec3 direction(Rng& rng, const glm::dvec3& origin, const glm::dvec3& target, const Transform& frame)
{
    glm::dvec3 d = glm::normalize(target + rng.point(1.5) - origin);
    switch (rng.below(6)) {
    case 0: {
        glm::dvec3 axis(0.0);
        axis[rng.below(3)] = rng.coin() ? 1.0 : -1.0;
        if (rng.coin()) axis = frame.vector(axis);
        return glm::normalize(axis);
    }
    case 1: d[rng.below(3)] = rng.coin() ? 0.0 : -0.0; return glm::normalize(d);
    case 2:
        d = glm::normalize(target + glm::dvec3(rng.below(3) - 1, rng.below(3) - 1, rng.below(3) - 1) - origin);
        return d;
    default: return d;
    }
}

}  // namespace

TEST_CASE("arithmetic that templates share is the same for a double and in lanes, to the last bit", "[csg][lanes]")
{
    using csg::lanes::Double;
    Rng rng(1);
    std::vector<double> numbers{0.0,    -0.0,      1.0,        -1.0, 0.1,     1e300,       -1e300,
                                5e-324, kInfinity, -kInfinity, 0.75, -1e-308, std::nan("")};
    for (int k = 0; k < 20; ++k) numbers.push_back(std::ldexp(rng.uniform(-1.0, 1.0), rng.below(200) - 100));
    const auto check = [](double alone, const Double& several) {
        alignas(64) std::array<double, csg::lanes::kDoubles> each;
        several.store_aligned(each.data());
        for (const double lane : each) REQUIRE((same_bits(lane, alone) || (lane != lane && alone != alone)));
    };
    for (const double a : numbers) {
        const Double as(a);
        check(csg::lanes::negated(a), csg::lanes::negated(as));
        check(csg::lanes::size_of(a), csg::lanes::size_of(as));
        check(csg::lanes::root_of(a), csg::lanes::root_of(as));
        for (const double b : numbers) {
            INFO(a << " and " << b);
            const Double bs(b);
            check(csg::lanes::smaller(a, b), csg::lanes::smaller(as, bs));
            check(csg::lanes::larger(a, b), csg::lanes::larger(as, bs));
            check(csg::lanes::signed_as(std::abs(a), b), csg::lanes::signed_as(xsimd::abs(as), bs));
            check(csg::lanes::choose(a < b, a, b), csg::lanes::choose(as < bs, as, bs));
            check(csg::lanes::fused(a, b, 0.1), csg::lanes::fused(as, bs, Double(0.1)));
            check(a / b, as / bs);
            REQUIRE((csg::lanes::mask(csg::lanes::differ(as <= bs, as == bs)) != 0) ==
                    csg::lanes::differ(a <= b, a == b));
        }
    }
}

TEST_CASE("a quadric in lanes has the span of each ray, or is unclear", "[csg][lanes]")
{
    int met = 0;
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        Rng rng(seed);
        const Transform frame = csg_test::random_transform(rng);
        const Quadric solid{{1, rng.uniform(-1, 1), 1},
                            {0.1, rng.uniform(-1, 1), 0},
                            {0, rng.uniform(-1, 1), 0},
                            rng.uniform(-1, 0.5),
                            frame};
        const glm::dvec3 origin = frame.offset + rng.direction() * (rng.coin() ? 5.0 : 0.5);
        const csg::lanes::Test<Quadric, glm::dvec3> test(solid, origin);
        alignas(64) std::array<double, csg::lanes::kDoubles> x, y, z, entry, exit;
        for (std::size_t i = 0; i < x.size(); ++i) {
            const glm::dvec3 d = direction(rng, origin, frame.offset, frame);
            x[i] = d.x, y[i] = d.y, z[i] = d.z;
        }
        const auto load = [](const auto& of) { return csg::lanes::Double::load_aligned(of.data()); };
        const csg::lanes::Intervals in = test({load(x), load(y), load(z)});
        in.entry.store_aligned(entry.data());
        in.exit.store_aligned(exit.data());
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (((csg::lanes::mask(in.unclear) >> i) & 1u) != 0) continue;
            INFO("seed " << seed << ": direction " << x[i] << ' ' << y[i] << ' ' << z[i]);
            Span memory[4];
            SpanList spans(memory, 4);
            solid.intersect({origin, {x[i], y[i], z[i]}}, spans);
            REQUIRE(spans.size() == ((csg::lanes::mask(in.met) >> i) & 1u));
            if (spans.empty()) continue;
            ++met;
            REQUIRE(same_bits(entry[i], spans[0].in.t));
            REQUIRE(same_bits(exit[i], spans[0].out.t));
        }
    }
    CHECK(met > 2000);
}

TEST_CASE("boxes that stand in one space and in others are met as each is alone", "[csg][lanes]")
{
    int met = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        Rng rng(seed + 300000);
        const Transform frames[2] = {csg_test::random_transform(rng), csg_test::random_transform(rng)};
        SolidStore store;
        std::vector<OrientedBox> boxes;
        for (int k = 0; k < 8; ++k) {
            const glm::dvec3 lower = -rng.point(1.0) - 1.0;
            boxes.push_back({lower, lower + 1.0 + glm::abs(rng.point(1.0)), frames[rng.below(2)]});
            store.add(boxes.back(), 0);
        }
        RayTile tile{};
        tile.count = 1 + rng.below(kTileRays);
        for (std::size_t i = 0; i < static_cast<std::size_t>(tile.count); ++i) {
            const glm::dvec3 origin = frames[rng.below(2)].offset + 4.0 * rng.direction();
            tile.set(i, {origin, direction(rng, origin, frames[rng.below(2)].offset, frames[0])}, 0.0, kInfinity);
        }
        const TileRays<OwnOrigins> rays(tile);
        for (std::uint32_t k = 0; k < boxes.size(); ++k)
            csg::lanes::with_test(store, make_part(SolidKind::OrientedBox, k), rays, [&](const auto& at) {
                each_vector(rays.all(), [&](int i) {
                    const csg::lanes::Intervals in = at(i);
                    alignas(64) std::array<double, csg::lanes::kDoubles> entry;
                    in.entry.store_aligned(entry.data());
                    for (int lane = 0; lane < csg::lanes::kDoubles && i + lane < tile.count; ++lane) {
                        Interval alone;
                        const bool hit = boxes[k].interval(tile.ray(i + lane), alone);
                        REQUIRE(((csg::lanes::mask(in.met) >> lane) & 1u) == (hit ? 1u : 0u));
                        if (!hit) continue;
                        ++met;
                        REQUIRE(same_bits(entry[static_cast<std::size_t>(lane)], alone.entry));
                    }
                });
            });
    }
    CHECK(met > 5000);
}

TEST_CASE("a quartic in lanes has the pieces of each ray, or leaves it", "[csg][lanes]")
{
    int pieces[QuarticEnds::kPieces + 1] = {}, left = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(csg_test::share(4000)); ++seed) {
        Rng rng(seed + 700000);
        std::vector<double> c(35);
        for (double& v : c) v = rng.below(3) == 0 ? rng.uniform(-0.5, 0.5) : 0.0;
        for (const std::size_t fourth_power : {0u, 20u, 30u}) c[fourth_power] += rng.below(4) == 0 ? -1.0 : 1.0;
        c.back() = rng.uniform(-1.0, 0.3);
        const Polynomial solid{std::make_shared<PolynomialShape>(4, c), csg_test::random_transform(rng)};
        RayTile tile{};
        tile.count = 1 + rng.below(kTileRays);
        for (std::size_t i = 0; i < static_cast<std::size_t>(tile.count); ++i) {
            const glm::dvec3 origin = solid.frame.offset + (rng.coin() ? 4.0 : 0.3) * rng.direction();
            tile.set(i, {origin, direction(rng, origin, solid.frame.offset, solid.frame)}, 0.0, kInfinity);
        }
        const TileRays<OwnOrigins> rays(tile);
        const RayMask asked = rays.all() & ~RayMask{rng.below(8) == 0 ? 0x124u : 0u};
        const QuarticEnds ends(solid, rays, asked);
        for (std::size_t k = 0; k < static_cast<std::size_t>(tile.count); ++k) {
            const auto has = [k](RayMask mask) { return (mask >> k & 1) != 0; };
            if (has(ends.unclear)) {
                ++left;
                continue;
            }
            INFO("seed " << seed << ", ray " << k);
            Span memory[4];
            SpanList spans(memory, 4);
            if (has(asked)) solid.intersect(tile.ray(static_cast<int>(k)), spans);
            ++pieces[spans.size()];
            for (std::uint32_t which = 0; which < QuarticEnds::kPieces; ++which) {
                REQUIRE(has(ends.met[which]) == (which < spans.size()));
                if (which >= spans.size()) continue;
                const int vector = static_cast<int>(k) / csg::lanes::kDoubles * csg::lanes::kDoubles;
                const csg::lanes::Intervals in = ends.piece(static_cast<int>(which), vector);
                const std::size_t lane = k - static_cast<std::size_t>(vector);
                REQUIRE(same_bits(in.entry.get(lane), spans[which].in.t));
                REQUIRE(same_bits(in.exit.get(lane), spans[which].out.t));
            }
        }
    }
    for (const int count : pieces) CHECK(count > csg_test::share(100));
    CHECK(left < pieces[1] / 10);
}

TEST_CASE("what a set of points tells in lanes is what a loop over them finds", "[csg][lanes]")
{
    for (std::uint32_t seed = 0; seed < 5000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        std::vector<glm::dvec3> points(1 + static_cast<std::size_t>(rng.below(kTileRays)));
        PointSet set;
        for (glm::dvec3& p : points) set.add(p = rng.point(100.0));
        set.pad();
        const glm::dvec3 v = rng.point(1.0), from = rng.point(100.0);
        constexpr double kRounding = 1e-12;  // of sums of at most 64 numbers up to 100, in another order
        glm::dvec3 sum(0.0), widest(0.0);
        double low = kInfinity, high = -kInfinity, farthest = 0.0;
        for (const glm::dvec3& p : points) {
            sum += p;
            widest = glm::max(widest, glm::abs(p));
            low = std::min(low, glm::dot(v, p)), high = std::max(high, glm::dot(v, p));
            farthest = std::max(farthest, glm::length(p - from));
        }
        REQUIRE(set.widest() == widest);
        REQUIRE(set.along(v).low == Approx(low).margin(kRounding));
        REQUIRE(set.along(v).high == Approx(high).margin(kRounding));
        REQUIRE(glm::dot(v, set.foremost(v)) == Approx(low).margin(kRounding));
        REQUIRE(std::find(points.begin(), points.end(), set.foremost(v)) != points.end());
        REQUIRE(set.farthest(from) == Approx(farthest));
        REQUIRE(glm::length(set.middle() - sum / static_cast<double>(points.size())) < kRounding);
        REQUIRE(set.last() == points.back());
    }
}
