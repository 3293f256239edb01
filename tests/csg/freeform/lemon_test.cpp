#include "csg/freeform/freeform.h"
#include "csg/freeform/freeform_solid.h"
#include "tests/csg/freeform/many_rays.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <cmath>

// Lemons, eggs with arcs of any radius and tori that cross themselves against conditions on a point; numbers that
// POV-Ray 3.8's trace() told.

using namespace csg;
using csg_test::Rng;
using Spindle = SpindleTorus::Spindle;

namespace {

/// Spans agree with `holds(p)` wherever a point is clear of their ends.
template <class Holds>
void check_spans(const Freeform& solid, const glm::dvec3& middle, const Holds& holds)
{
    const int rays = csg_test::share(2000);
    int hits = 0;
    for (int seed = 0; seed < rays; ++seed) {
        INFO("seed " << seed);
        Rng rng(static_cast<std::uint32_t>(seed));
        Ray ray = csg_test::ray_near(rng, middle, 1.4, rng.coin() ? 6.0 : 0.5);
        if (seed % 7 == 1) ray.direction.y = 0.0;
        if (seed % 7 == 2) ray.direction.y *= std::pow(10.0, rng.uniform(-14.0, -2.0));
        FixedSpans<32> spans;
        solid.intersect(ray, spans);
        hits += !spans.empty();
        for (int i = 0; i < 16; ++i) {
            const double t = spans.empty() || i % 2 == 0 ? rng.uniform(-1.0, 8.0)
                                                         : spans[0].in.t + rng.uniform(-0.5, 1.5);
            bool clear = true;
            for (const Span& span : spans)
                clear = clear && std::abs(t - span.in.t) > 1e-5 && std::abs(t - span.out.t) > 1e-5;
            if (clear) REQUIRE(spans.contains(t) == holds(ray.at(t)));
        }
        const Aabb box = solid.bounds();
        for (const Span& span : spans) {
            const glm::dvec3 at = ray.at(span.in.t);
            REQUIRE(glm::all(glm::lessThanEqual(box.lower - 1e-9, at)));
            REQUIRE(glm::all(glm::lessThanEqual(at, box.upper + 1e-9)));
        }
    }
    CHECK(hits > rays / 50);
}

Lemon random_lemon(Rng& rng)
{
    const glm::dvec3 base = rng.point(1.0),
                     cap = rng.coin() ? base + glm::dvec3(0, rng.uniform(0.2, 2.0), 0) : rng.point(1.0);
    const double first = rng.below(4) == 0 ? 0.0 : rng.uniform(0.0, 1.0),
                 second = rng.below(4) == 0 ? 0.0 : rng.uniform(0.0, 1.0);
    const double least = Lemon::least_arc(first, second, glm::distance(base, cap));
    return {base,      first, cap, second, rng.below(4) == 0 ? least : least * std::pow(10.0, rng.uniform(0.0, 4.0)),
            rng.coin()};
}

/// Where a ray along x meets it first, and the normal there.
std::pair<double, glm::dvec3> met(const Freeform& solid, double y)
{
    const Ray ray{{-5, y, 0}, {1, 0, 0}};
    FixedSpans<8> spans;
    solid.intersect(ray, spans);
    REQUIRE(!spans.empty());
    const glm::dvec3 at = ray.at(spans[0].in.t);
    return {at.x, solid.normal(at, spans[0].in.face)};
}

}  // namespace

TEST_CASE("a lemon is where POV-Ray 3.8 has it", "[csg][lemon]")
{
    const Freeform solid{make_freeform<Lemon>(glm::dvec3(0), 0.5, glm::dvec3(0, 2, 0), 0.3, 2.0, false), {}};
    const double told[][4] = {{1.0, -0.67200512, -0.99629263, 0.08602901},
                              {0.5, -0.65235018, -0.98646516, -0.16397099},
                              {0.01, -0.50451462, -0.91254738, -0.40897099},
                              {1.99, -0.30718555, -0.81388285, 0.58102901}};
    for (const auto& [y, x, nx, ny] : told) {
        const auto [at, normal] = met(solid, y);
        CHECK(at == Approx(x).margin(1e-8));
        CHECK(normal.x == Approx(nx).margin(1e-8));
        CHECK(normal.y == Approx(ny).margin(1e-8));
    }
    const Aabb box = solid.shape->extent({});
    CHECK(box.upper.x == Approx(0.67941988));
    CHECK(box.upper.y == Approx(2.0));
    CHECK((solid.contains({0, 0, 0}) && solid.contains({0, 2, 0}) && !solid.contains({0, 2.0000001, 0})));
    CHECK(Lemon::least_arc(1.0, 0.2, 1.0) == Approx(1.0002).epsilon(1e-6));
}

TEST_CASE("a lemon's spans are its inside", "[csg][lemon]")
{
    for (std::uint32_t k = 0; k < 12; ++k) {
        INFO("lemon " << k);
        Rng rng(k);
        const Freeform solid{make_freeform<Lemon>(random_lemon(rng)), {}};
        const Aabb box = solid.bounds();
        check_spans(solid, 0.5 * (box.lower + box.upper), [&](const glm::dvec3& p) { return solid.contains(p); });
    }
}

TEST_CASE("many rays of a lemon are told what each is told alone", "[csg][many][lemon]")
{
    if (!csg_test::runs_here()) return;
    int ends = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(csg_test::share(800)); ++seed) {
        Rng rng(seed + 9000);
        ends += csg_test::check_many(random_lemon(rng), 1.0, seed);
    }
    CHECK(ends > csg_test::share(800) * 5);
}

TEST_CASE("many rays of an egg are told what each is told alone", "[csg][many][ovus]")
{
    if (!csg_test::runs_here()) return;
    int ends = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(csg_test::share(800)); ++seed) {
        Rng rng(seed + 9500);
        const double bottom = rng.uniform(0.2, 1.0), top = rng.coin() ? 0.0 : rng.uniform(0.0, 2.0 * bottom);
        const double apart = glm::max(bottom, top - bottom) + rng.uniform(0.01, 1.0);
        const double arc = (0.5 * (bottom + top + apart)) * rng.uniform(1.01, 4.0);
        const Ovus egg = rng.coin() ? Ovus(bottom, top) : Ovus(bottom, top, apart, arc);
        if (egg.intersects_many()) ends += csg_test::check_many(egg, 1.0, seed);
    }
    CHECK(ends > csg_test::share(800) * 5);
}

TEST_CASE("lemons bear any question", "[csg][lemon]")
{
    Rng rng(7);
    for (int k = 0; k < 6000; ++k) {
        const Freeform solid{make_freeform<Lemon>(random_lemon(rng)), {}};
        const Ray ray = csg_test::hostile_ray(rng);
        IntersectionList record(0.0, kInfinity, k % 2 == 0);
        solid.intersect(ray, record);
        record.each_span([](double in, std::uint32_t, double out, std::uint32_t) { REQUIRE_FALSE(out < in); });
        (void)solid.contains(ray.origin);
    }
}

TEST_CASE("an egg with an arc of its own is where POV-Ray 3.8 has it", "[csg][ovus]")
{
    const Freeform solid{make_freeform<Ovus>(1.0, 0.5, 2.0, 3.0), {}};
    const double told[][4] = {{-0.07, -1.00520050, -0.98558746, -0.16916667},
                              {0.53, -1.04701174, -0.99952454, 0.03083333},
                              {2.03, -0.59086684, -0.84747624, 0.53083333},
                              {2.33, -0.37563280, -0.75126560, 0.66}};
    for (const auto& [y, x, nx, ny] : told) {
        const auto [at, normal] = met(solid, y);
        CHECK(at == Approx(x).margin(1e-7));
        CHECK(normal.x == Approx(nx).margin(1e-7));
        CHECK(normal.y == Approx(ny).margin(1e-7));
    }
    check_spans(solid, {0, 0.7, 0}, [&](const glm::dvec3& p) { return solid.contains(p); });
    // As usual it is the one that is given by two radii.
    const Freeform usual{make_freeform<Ovus>(0.6, 0.8, 0.6, 1.6), {}}, two{make_freeform<Ovus>(0.6, 0.8), {}};
    for (double y = -0.5; y < 1.3; y += 0.1) CHECK(met(usual, y).first == Approx(met(two, y).first).margin(1e-12));
}

TEST_CASE("an egg with the larger sphere on top has POV-Ray 3.8's arc", "[csg][ovus]")
{
    const Freeform solid{make_freeform<Ovus>(0.4, 0.7, 1.2, 1.7), {}};
    // At 0.2 the ball, which is not drawn there, holds the arc.
    IntersectionList within(0.0, kInfinity, false);
    solid.intersect(Ray{{-9, 0.2, 0}, {1, 0, 0}}, within);
    double arc = kInfinity;
    within.each_touching([&](double t, std::uint32_t) { arc = std::min(arc, t); });
    CHECK(arc == Approx(9.0 - 0.130519).margin(1e-6));
    const double told[][4] = {{0.9, -0.635908, -0.932839, -0.360294},
                              {1.0, -0.670820, -0.958315, -0.285714},
                              {1.7, -0.489898, -0.699854, 0.714286}};
    for (const auto& [y, x, nx, ny] : told) {
        const auto [at, normal] = met(solid, y);
        CHECK(at == Approx(x).margin(1e-6));
        CHECK(normal.x == Approx(nx).margin(1e-6));
        CHECK(normal.y == Approx(ny).margin(1e-6));
    }
    // Of the first sphere nothing is met, though it is inside: what CSG makes of the egg holds it.
    for (const double y : {-0.3, 0.0}) {
        FixedSpans<8> spans;
        solid.intersect(Ray{{-9, y, 0}, {1, 0, 0}}, spans);
        REQUIRE(spans.size() == 1);
        CHECK((!spans[0].in.drawn() && !spans[0].out.drawn()));
        CHECK(spans[0].in.t == Approx(9.0 - std::sqrt(0.16 - y * y)));
        CHECK(solid.contains({0, y, 0}));
    }
    check_spans(solid, {0, 0.7, 0}, [&](const glm::dvec3& p) { return solid.contains(p); });
    // A step: the ball ends where the arc begins.
    const auto from_below = [](double x) {
        IntersectionList hits(0.0, kInfinity, false);
        Freeform{make_freeform<Ovus>(0.5, 0.65, 0.5, 1.3), {}}.intersect(Ray{{x, -9, 0}, {0, 1, 0}}, hits);
        double nearest = kInfinity;
        const auto met = [&](double t, std::uint32_t face) {
            if (face != kUndrawnFace) nearest = std::min(nearest, t);
        };
        hits.each_span([&](double in, std::uint32_t face, double, std::uint32_t) { met(in, face); });
        hits.each_touching(met);
        return nearest - 9.0;
    };
    CHECK(from_below(0.37) == Approx(-0.33630).margin(1e-5));
    CHECK(from_below(0.38) == Approx(-0.26171).margin(1e-5));
}

TEST_CASE("coordinates of POV-Ray 3.8's egg go by height", "[csg][ovus]")
{
    const Ovus egg(0.6, 0.3, 0.6, 1.2);
    const double told[][2] = {{0.8225, 0.17905},  {0.6725, 0.24488},  {0.2975, 0.50208}, {0.0725, 0.68959},
                              {-0.0775, 0.75137}, {-0.3025, 0.77652}, {-0.4525, 0.82438}};
    for (const auto& [y, v] : told) CHECK(egg.uv({0.2, y, 0.1}, 0).y == Approx(v).margin(2e-5));
}

TEST_CASE("a torus that crosses itself is what its kind says", "[csg][torus]")
{
    const auto outer = [](const glm::dvec3& p) {
        const double rho = std::hypot(p.x, p.z) - 0.7;
        return rho * rho + p.y * p.y <= 1.0;
    };
    const auto spindle = [](const glm::dvec3& p) {
        const double rho = std::hypot(p.x, p.z) + 0.7;
        return rho * rho + p.y * p.y <= 1.0;
    };
    for (const Spindle kind : {Spindle::Union, Spindle::Merge, Spindle::Difference, Spindle::Intersection}) {
        INFO("kind " << static_cast<int>(kind));
        const Freeform solid{make_freeform<SpindleTorus>(0.7, 1.0, kind), {}};
        const auto holds = [&](const glm::dvec3& p) {
            if (kind == Spindle::Intersection) return spindle(p);
            return outer(p) && !(kind == Spindle::Difference && spindle(p));
        };
        const double wide = kind == Spindle::Intersection ? 0.35 : 1.0;
        for (int seed = 0; seed < csg_test::share(4000); ++seed) {
            INFO("seed " << seed);
            Rng rng(static_cast<std::uint32_t>(seed));
            const Ray ray = csg_test::ray_near(rng, {0, 0, 0}, wide, 4.0);
            FixedSpans<32> spans;
            solid.intersect(ray, spans);
            for (int i = 0; i < 12; ++i) {
                const double t = rng.uniform(2.0, 6.0);
                bool clear = true;
                for (const Span& span : spans)
                    clear = clear && std::abs(t - span.in.t) > 1e-5 && std::abs(t - span.out.t) > 1e-5;
                if (!clear) continue;
                REQUIRE(spans.contains(t) == holds(ray.at(t)));
                REQUIRE(solid.contains(ray.at(t)) == holds(ray.at(t)));
            }
        }
    }
    // The inner sheet's normals point out of the spindle.
    const SpindleTorus one(1.0, 1.5, Spindle::Union);
    const glm::dvec3 n = glm::normalize(one.gradient({-0.45461422, 0.1, 0.2}, 1));
    CHECK(n.x == Approx(-0.913301).margin(1e-6));
    CHECK(n.y == Approx(0.066667).margin(1e-6));
}
