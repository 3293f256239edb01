#include "csg/packet/lanes/lane_solids.h"
#include "csg/packet/point_set.h"
#include "csg/packet/lanes/tile_rays.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

using namespace csg;
using csg_test::Rng;

namespace csg::lanes {

/// As with_test() asks it.
template <>
class Test<OrientedBox, glm::dvec3> {
public:
    Test(const OrientedBox& s, const glm::dvec3& origin) : solid_(s), origin_(origin) {}
    Intervals operator()(const Directions& d) const
    {
        const struct {
            const Directions& d;
            glm::dvec3 origin;
            Directions directions(int) const { return d; }
        } rays{d, origin_};
        TurnedRays<SharedOrigin> turned;
        turned.turn(solid_.frame, rays);
        turned.find(0, rays);
        return BoxTest(solid_.lower, solid_.upper, turned.origins(0))(turned.directions(0), turned.inverses(0));
    }

private:
    const OrientedBox& solid_;
    glm::dvec3 origin_;
};

}  // namespace csg::lanes

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

/// What lanes must say of a ray: a solid that is not convex has one span where it is not unclear.
template <class T>
bool one_interval(const T& solid, const Ray& ray, Interval& out)
{
    if constexpr (std::is_same_v<T, Triangle>) {  // one crossing, and no way out
        double t = 0.0;
        if (!solid.crossing(ray, t)) return false;
        out = {t, t, 0, kUndrawnFace};
        return true;
    } else if constexpr (requires { solid.interval(ray, out); }) {
        return solid.interval(ray, out);
    } else {
        Span memory[4];
        SpanList spans(memory, 4);
        solid.intersect(ray, spans);
        REQUIRE(spans.size() <= 1);
        if (spans.empty()) return false;
        out = {spans[0].in.t, spans[0].out.t, spans[0].in.face, spans[0].out.face};
        return true;
    }
}

/// The answers in lanes are those of interval(), to the last bit.
template <class T>
int check_lanes(const T& solid, const glm::dvec3& target, const Transform& frame, std::uint32_t seed)
{
    Rng rng(seed);
    glm::dvec3 origin = target + rng.direction() * (rng.coin() ? 5.0 : 0.5);
    if (rng.below(4) == 0) origin = target + glm::dvec3(rng.below(3) - 1, rng.below(3) - 1, rng.below(7) - 3);
    const lanes::Test<T, glm::dvec3> test(solid, origin);
    int met = 0;
    for (int round = 0; round < 4; ++round) {
        alignas(64) std::array<double, 8> x, y, z, entry, exit, entry_face, exit_face;
        for (std::size_t i = 0; i < 8; ++i) {
            const glm::dvec3 d = direction(rng, origin, target, frame);
            x[i] = d.x;
            y[i] = d.y;
            z[i] = d.z;
        }
        for (int at = 0; at < 8; at += lanes::kDoubles) {
            const auto part = [&](auto& all) { return all.data() + at; };
            const lanes::Intervals in =
                test({lanes::Double::load_aligned(part(x)), lanes::Double::load_aligned(part(y)),
                      lanes::Double::load_aligned(part(z))});
            in.entry.store_aligned(part(entry));
            in.exit.store_aligned(part(exit));
            in.entry_face.store_aligned(part(entry_face));
            in.exit_face.store_aligned(part(exit_face));
            for (int lane = 0; lane < lanes::kDoubles; ++lane) {
                const auto i = static_cast<std::size_t>(at + lane);
                INFO("seed " << seed << ", round " << round << ", ray " << i << ": direction " << x[i] << ' ' << y[i]
                             << ' ' << z[i]);
                Interval alone;
                const Ray ray{origin, {x[i], y[i], z[i]}};
                if (((lanes::mask(in.unclear) >> lane) & 1u) != 0) continue;
                const bool hit = one_interval(solid, ray, alone);
                REQUIRE(((lanes::mask(in.met) >> lane) & 1u) == (hit ? 1u : 0u));
                if (!hit) continue;
                ++met;
                REQUIRE(same_bits(entry[i], alone.entry));
                REQUIRE(same_bits(exit[i], alone.exit));
                if (alone.entry > -kInfinity) REQUIRE(entry_face[i] == static_cast<double>(alone.entry_face));
                if (alone.exit < kInfinity) REQUIRE(exit_face[i] == static_cast<double>(alone.exit_face));
            }
        }
    }
    return met;
}

template <class Make>
void check_kind(Make&& make)
{
    int met = 0;
    for (std::uint32_t seed = 0; seed < 3000; ++seed) {
        Rng rng(seed + 100000);
        const Transform frame = csg_test::random_transform(rng);
        const glm::dvec3 target = frame.offset;
        met += check_lanes(make(rng, frame, target), target, frame, seed);
    }
    REQUIRE(met > 10000);
}

}  // namespace

TEST_CASE("intervals in lanes are those of single rays, bit for bit", "[csg][lanes]")
{
#if defined(__AVX512F__)
    if (!__builtin_cpu_supports("avx512f")) return;
#elif defined(__AVX2__)
    if (!__builtin_cpu_supports("avx2")) return;
#endif
    SECTION("sphere")
    {
        check_kind([](Rng& rng, const Transform&, const glm::dvec3& p) { return Sphere{p, rng.uniform(0.5, 1.5)}; });
    }
    SECTION("unit sphere")
    {
        check_kind([](Rng&, const Transform&, const glm::dvec3& p) { return Sphere{p, 1.0}; });
    }
    SECTION("ellipsoid")
    {
        check_kind([](Rng&, const Transform& frame, const glm::dvec3&) { return Ellipsoid{frame}; });
    }
    SECTION("box")
    {
        check_kind([](Rng&, const Transform&, const glm::dvec3& p) { return Box{p - 1.0, p + 1.0}; });
    }
    SECTION("flat box")
    {
        check_kind([](Rng&, const Transform&, const glm::dvec3& p) {
            return Box{p - glm::dvec3(1, 0, 1), p + glm::dvec3(1, 0, 1)};
        });
    }
    SECTION("oriented box")
    {
        check_kind([](Rng&, const Transform& frame, const glm::dvec3&) {
            return OrientedBox{glm::dvec3(-1), glm::dvec3(1), frame};
        });
    }
    SECTION("plane")
    {
        check_kind([](Rng& rng, const Transform&, const glm::dvec3& p) {
            const glm::dvec3 n = rng.coin() ? glm::dvec3(0, 1, 0) : rng.direction();
            return Plane{n, glm::dot(n, p)};
        });
    }
    SECTION("cylinder")
    {
        check_kind([](Rng& rng, const Transform& frame, const glm::dvec3&) { return Cylinder{frame, rng.coin()}; });
    }
    SECTION("upright cylinder")
    {
        check_kind([](Rng&, const Transform&, const glm::dvec3& p) {
            return Cylinder{Transform::translate(p), false};
        });
    }
    SECTION("cone")
    {
        check_kind([](Rng& rng, const Transform& frame, const glm::dvec3&) {
            return Cone{rng.coin() ? 0.0 : rng.uniform(0.0, 0.9), frame, rng.coin()};
        });
    }
    SECTION("quadric")
    {
        check_kind([](Rng& rng, const Transform& frame, const glm::dvec3&) {
            return Quadric{{1, rng.uniform(-1, 1), 1},
                           {0.1, rng.uniform(-1, 1), 0},
                           {0, rng.uniform(-1, 1), 0},
                           rng.uniform(-1, 0.5),
                           frame};
        });
    }
    SECTION("triangle")
    {
        check_kind([](Rng& rng, const Transform&, const glm::dvec3& p) {
            if (rng.coin())
                return Triangle::make({p - glm::dvec3(2, 0, 2), p + glm::dvec3(3, 0, 0), p + glm::dvec3(0, 0, 3)});
            return Triangle::make({p + rng.point(2.0), p + rng.point(2.0), p + rng.point(2.0)});
        });
    }
    SECTION("upright cone")
    {
        check_kind([](Rng&, const Transform&, const glm::dvec3& p) {
            return Cone{0.0, Transform::translate(p), false};
        });
    }
}

TEST_CASE("boxes that stand in one space and in others are met as each is alone", "[csg][lanes]")
{
#if defined(__AVX512F__)
    if (!__builtin_cpu_supports("avx512f")) return;
#elif defined(__AVX2__)
    if (!__builtin_cpu_supports("avx2")) return;
#endif
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
            lanes::with_test(store, make_part(SolidKind::OrientedBox, k), rays, [&](const auto& at) {
                each_vector(rays.all(), [&](int i) {
                    const lanes::Intervals in = at(i);
                    alignas(64) std::array<double, lanes::kDoubles> entry;
                    in.entry.store_aligned(entry.data());
                    for (int lane = 0; lane < lanes::kDoubles && i + lane < tile.count; ++lane) {
                        Interval alone;
                        const bool hit = boxes[k].interval(tile.ray(i + lane), alone);
                        REQUIRE(((lanes::mask(in.met) >> lane) & 1u) == (hit ? 1u : 0u));
                        if (!hit) continue;
                        ++met;
                        REQUIRE(same_bits(entry[static_cast<std::size_t>(lane)], alone.entry));
                    }
                });
            });
    }
    CHECK(met > 5000);
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
