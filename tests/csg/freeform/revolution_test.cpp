#include "csg/freeform/freeform.h"
#include "csg/freeform/freeform_solid.h"
#include "tests/csg/freeform/revolution.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

// Lathes and surfaces of revolution against their profile sampled densely, and against their own inside test.

using namespace csg;
using namespace csg_test;

namespace {

/// Ends of spans lie on the profile, as many as it crosses; points between and beyond are as contains() says.
void check_spans(const Freeform& solid, const Curve& curve, std::uint32_t rays, bool counted)
{
    int hits = 0, compared = 0;
    const Aabb box = solid.bounds();
    for (std::uint32_t seed = 0; seed < rays; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const Ray ray = some_ray(rng, seed, 0.5 * (box.lower.y + box.upper.y));
        IntersectionList record(-kInfinity, kInfinity, false);
        solid.intersect(ray, record);
        std::vector<double> ends;
        int drawn = 0;
        record.each_span([&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
            REQUIRE(in <= out);
            REQUIRE((ends.empty() || ends.back() <= in));
            for (const auto& [t, face] : {std::pair(in, in_face), std::pair(out, out_face)}) {
                ends.push_back(t);
                if (face == kUndrawnFace) continue;
                ++drawn;
                if (seed % 20 == 0) REQUIRE(off(curve, ray.at(t)) < 5e-12);  // measured: 1e-12
            }
        });
        hits += drawn > 0;
        const int expected = counted ? crossings(curve, ray) : -1;
        if (expected >= 0) REQUIRE(drawn == expected);
        compared += expected >= 0;
        for (int i = 0; i < 12; ++i) {
            const double t = rng.uniform(-1.0, 8.0);
            double clear = kInfinity;
            std::size_t before = 0;
            for (const double end : ends) {
                clear = std::min(clear, std::abs(t - end));
                before += end < t;
            }
            if (clear > 1e-6 && (expected >= 0 || !counted)) REQUIRE(solid.contains(ray.at(t)) == (before % 2 == 1));
        }
    }
    CHECK(hits > static_cast<int>(rays) / 4);
    if (counted) CHECK(compared > static_cast<int>(rays) * 8 / 10);
}

/// No question makes it fail, and no answer is out of order.
void check_hostile(const Freeform& solid)
{
    Rng rng(3);
    for (int k = 0; k < 6000; ++k) {
        const Ray ray = csg_test::hostile_ray(rng);
        IntersectionList record(0.0, kInfinity, k % 2 == 0);
        solid.intersect(ray, record);
        record.each_span([](double in, std::uint32_t, double out, std::uint32_t) { REQUIRE(in <= out); });
        record.each_touching([](double t, std::uint32_t) { REQUIRE(t >= 0.0); });
        (void)solid.contains(ray.origin);
    }
}

Freeform lathe(const Curve& curve, double least_radius = 0.0)
{
    return {make_freeform<Lathe>(curve, Aabb{}, least_radius), {}};
}

}  // namespace

TEST_CASE("a lathe's spans are where its profile says", "[csg][revolution]")
{
    const Curve vase = spline({{0, -0.3}, {0, 0}, {1, 0.2}, {0.3, 0.9}, {0.9, 1.6}, {0, 2}, {-1, 2}});
    check_spans(lathe(vase), vase, share(1500), true);
    const Curve star = polyline({{0, -0.2}, {1, 0.5}, {0.4, 0.6}, {0.9, 1.4}, {0.2, 1.2}, {0, 2}});
    check_spans(lathe(star), star, share(1500), true);
    const Curve ring = spline({{1, 0}, {0.5, 0.5}, {0.8, 1.2}, {1.2, 0.6}, {1, 0}, {0.5, 0.5}, {0.8, 1.2}});
    check_spans(lathe(ring, 0.3), ring, share(1500), true);
    const Curve can = polyline({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    check_spans(lathe(can), can, share(1500), true);
}

TEST_CASE("an open lathe is bounded by what is not drawn", "[csg][revolution]")
{
    const Curve vase = spline({{0.5, -0.3}, {0.6, 0}, {1, 0.5}, {0.5, 1.2}, {0.7, 1.9}, {0.7, 2}});
    check_spans(lathe(vase, 0.45), vase, share(1500), false);
    const Curve gap = polyline({{0.4, 0}, {1, 0.3}, {0.7, 1.5}});
    check_spans(lathe(gap, 0.4), gap, share(1500), false);
}

TEST_CASE("the nearest crossing alone is the nearest of all", "[csg][revolution]")
{
    const Curve vase = spline({{0, -0.3}, {0, 0}, {1, 0.2}, {0.3, 0.9}, {0.9, 1.6}, {0, 2}, {-1, 2}});
    const Freeform solid = lathe(vase);
    for (std::uint32_t seed = 0; seed < 6000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const Ray ray = some_ray(rng, seed, 1.0);
        const double from = rng.coin() ? 0.0 : rng.uniform(0.0, 6.0);
        IntersectionList all(from, kInfinity, false), one(from, kInfinity, true);
        solid.intersect(ray, all);
        solid.intersect(ray, one);
        double nearest = kInfinity, told = kInfinity;
        const auto offer = [&](double t) { nearest = t >= from ? std::min(nearest, t) : nearest; };
        all.each_span([&](double in, std::uint32_t, double end, std::uint32_t) { offer(in), offer(end); });
        one.each_touching([&](double t, std::uint32_t) { told = std::min(told, t); });
        REQUIRE(told == nearest);
    }
}

TEST_CASE("every end of a lathe that is told of a range is one of all, to the last digit", "[csg][revolution]")
{
    // A cut of CSG may ask again with another range, and what it is told decides where the next ray begins.
    const Curve vase = spline({{0, -0.3}, {0, 0}, {1, 0.2}, {0.3, 0.9}, {0.9, 1.6}, {0, 2}, {-1, 2}});
    const Freeform solid = lathe(vase);
    int told = 0;
    for (std::uint32_t seed = 0; seed < 6000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const Ray ray = some_ray(rng, seed, 1.0);
        const auto ends_of = [&](double from, double to) {
            std::vector<double> ends;
            IntersectionList record(from, to, false);
            solid.intersect(ray, record);
            record.each_span([&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
                if (in_face != kUndrawnFace) ends.push_back(in);
                if (out_face != kUndrawnFace) ends.push_back(out);
            });
            return ends;
        };
        const std::vector<double> all = ends_of(-kInfinity, kInfinity);
        const double from = rng.uniform(0.0, 6.0), to = from + rng.uniform(0.0, 3.0);
        for (const double end : ends_of(from, to)) {
            ++told;
            REQUIRE(std::find(all.begin(), all.end(), end) != all.end());
        }
    }
    CHECK(told > 2000);
}

TEST_CASE("a lathe's scale is the ray's", "[csg][revolution]")
{
    const std::vector<glm::dvec2> points = {{0, -0.3}, {0, 0}, {1, 0.2}, {0.3, 0.9}, {0.9, 1.6}, {0, 2}, {-1, 2}};
    const Freeform solid = lathe(spline(points));
    for (const double scale : {1e-9, 1e-4, 1e4, 1e9}) {
        std::vector<glm::dvec2> scaled = points;
        for (glm::dvec2& p : scaled) p *= scale;
        const Freeform other = lathe(spline(scaled));
        for (std::uint32_t seed = 0; seed < 1000; ++seed) {
            INFO("scale " << scale << ", seed " << seed);
            Rng rng(seed);
            const Ray ray = some_ray(rng, seed, 1.0);
            FixedSpans<16> spans, same;
            solid.intersect(ray, spans);
            other.intersect({ray.origin * scale, ray.direction}, same);
            REQUIRE(spans.size() == same.size());
            for (std::uint32_t i = 0; i < spans.size(); ++i) {
                REQUIRE(std::abs(same[i].in.t / scale - spans[i].in.t) < 1e-7);  // a tangent's roots: measured 1e-8
                const glm::dvec3 n = solid.normal(ray.at(spans[i].in.t), spans[i].in.face);
                const glm::dvec3 m = other.normal(ray.origin * scale + same[i].in.t * ray.direction, same[i].in.face);
                REQUIRE(glm::length(n - m) < 1e-6);
            }
        }
    }
}

TEST_CASE("a lathe from far away", "[csg][revolution]")
{
    const Curve vase = spline({{0, -0.3}, {0, 0}, {1, 0.2}, {0.3, 0.9}, {0.9, 1.6}, {0, 2}, {-1, 2}});
    const Freeform solid = lathe(vase);
    int hits = 0;
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const Ray ray = csg_test::ray_near(rng, {0, 1, 0}, 1.0, 1e6);
        FixedSpans<16> spans;
        solid.intersect(ray, spans);
        for (const Span& span : spans) {
            ++hits;
            REQUIRE(off(vase, ray.at(span.in.t)) < 1e-9);  // 1e6 in doubles: 1e-10
        }
    }
    CHECK(hits > 500);
}

TEST_CASE("a lathe and a turned outline tell a ray from 6e9 away what they tell it from beside them",
          "[csg][revolution]")
{
    const Freeform vase = lathe(spline({{0, -0.3}, {0, 0}, {1, 0.2}, {0.3, 0.9}, {0.9, 1.6}, {0, 2}, {-1, 2}}));
    const Freeform urn{
        make_freeform<Sor>(std::vector<glm::dvec2>{{0.2, -0.3}, {0.5, 0}, {0.9, 0.6}, {0.3, 1.3}, {0.6, 2}, {0.2, 2.4}},
                           false),
        {}};
    int compared = 0;
    for (const Freeform* solid : {&vase, &urn})
        for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(share(4000)); ++seed) {
            INFO("seed " << seed);
            Rng rng(seed);
            const glm::dvec3 p{rng.uniform(-1.0, 1.0), rng.uniform(0.0, 2.0), rng.uniform(-1.0, 1.0)},
                d = rng.direction();
            const Ray far{p - 6e9 * d, d};
            // Where it really is: doubles from there are 1e-6 apart, and chords of 1e-3 lie within a tenth of that of a
            // tangent.
            Ray beside = far;
            for (int k = 0; k < 3; ++k) beside.origin[k] = static_cast<double>(far.origin[k] + 6e9L * d[k]);
            FixedSpans<16> from_far, from_beside;
            solid->intersect(far, from_far);
            solid->intersect(beside, from_beside);
            double shortest = kInfinity;
            for (const Span& span : from_beside) shortest = std::min(shortest, span.out.t - span.in.t);
            if (shortest < 1e-5) continue;
            ++compared;
            REQUIRE(from_far.size() == from_beside.size());
            for (std::uint32_t i = 0; i < from_far.size(); ++i)
                REQUIRE(std::abs(from_far[i].in.t - 6e9 - from_beside[i].in.t) < 2e-6);  // two places of 6e9
        }
    CHECK(compared > share(4000));
}

TEST_CASE("a negative radius is touched, not entered", "[csg][revolution]")
{
    const Freeform solid = lathe(polyline({{-0.5, 0}, {0.5, 1}, {0, 1}}));
    CHECK(solid.reports_touches());
    IntersectionList low(0.0, kInfinity, false), high(0.0, kInfinity, false);
    solid.intersect({{-5, 0.25, 0}, {1, 0, 0}}, low);
    solid.intersect({{-5, 0.75, 0}, {1, 0, 0}}, high);
    int touches = 0, spans = 0;
    low.each_touching([&](double t, std::uint32_t) {
        ++touches;
        CHECK(std::abs(std::abs(t - 5.0) - 0.25) < 1e-12);
    });
    low.each_span([&](double, std::uint32_t, double, std::uint32_t) { ++spans; });
    CHECK(touches == 2);
    CHECK(spans == 0);
    high.each_span([&](double, std::uint32_t, double, std::uint32_t) { ++spans; });
    CHECK(spans == 1);
    CHECK_FALSE(solid.contains({0, 0.25, 0}));
    CHECK(solid.contains({0, 0.75, 0}));
}

TEST_CASE("a surface of revolution's spans are its inside", "[csg][revolution]")
{
    const std::vector<glm::dvec2> points = {{0.4, -0.5}, {0.2, 0}, {1, 0.6}, {0.3, 1.2}, {0.8, 1.9}, {0.1, 2.4}};
    for (const bool open : {false, true}) {
        const Freeform solid{make_freeform<Sor>(points, open), {}};
        int hits = 0;
        for (std::uint32_t seed = 0; seed < 6000; ++seed) {
            INFO("seed " << seed);
            Rng rng(seed);
            const Ray ray = some_ray(rng, seed, 1.0);
            FixedSpans<16> spans;
            solid.intersect(ray, spans);
            hits += !spans.empty();
            std::vector<double> probes;
            for (int i = 0; i < 40; ++i) probes.push_back(rng.uniform(-1.0, 8.0));
            for (const Span& span : spans) probes.push_back(0.5 * (span.in.t + span.out.t));
            for (const double t : probes) {
                bool clear = true;
                for (const Span& span : spans)
                    clear = clear && std::abs(t - span.in.t) > 1e-7 && std::abs(t - span.out.t) > 1e-7;
                if (clear) REQUIRE(spans.contains(t) == solid.contains(ray.at(t)));
            }
        }
        CHECK(hits > 1500);
    }
}

TEST_CASE("solids of revolution bear any question", "[csg][revolution]")
{
    check_hostile(lathe(spline({{0, -0.3}, {0, 0}, {1, 0.2}, {0.3, 0.9}, {0.9, 1.6}, {0, 2}, {-1, 2}})));
    check_hostile(lathe(polyline({{-0.5, 0}, {0.5, 1}, {0, 1}})));
    check_hostile(lathe(polyline({{0, 0}, {0, 0}})));
    check_hostile(lathe(polyline({{0, 0}, {std::nan(""), 1}})));
    check_hostile({make_freeform<Sor>(std::vector<glm::dvec2>{{0, 0}, {1, 1}, {0.5, 2}, {0, 3}}, false), {}});
    check_hostile(
        {make_freeform<Sor>(std::vector<glm::dvec2>{{0, 0}, {1, 1e300}, {0.5, kInfinity}, {0, 3}}, false), {}});
}
