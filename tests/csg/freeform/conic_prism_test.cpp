#include "csg/freeform/freeform.h"
#include "csg/freeform/freeform_solid.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

// Conic prisms and eggs against the plainest idea of their inside: a polygon of many corners, three conditions.

using namespace csg;
using csg_test::Rng;

namespace {

using Corners = std::vector<glm::dvec2>;

/// A loop of curves as a polygon.
Corners polygon(const std::vector<OutlinePiece>& pieces)
{
    constexpr int kSteps = 4000;
    Corners corners;
    for (const OutlinePiece& piece : pieces)
        for (int i = 0; i < kSteps; ++i) corners.push_back(piece.at(static_cast<double>(i) / kSteps));
    return corners;
}

bool inside(const Corners& corners, const glm::dvec2& q)
{
    bool odd = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        if ((a.y > q.y) != (b.y > q.y) && q.x < a.x + (q.y - a.y) / (b.y - a.y) * (b.x - a.x)) odd = !odd;
    }
    return odd;
}

/// Spans agree with `holds(p)` wherever a point is clear of their ends.
template <class Holds>
void check_spans(const Freeform& solid, int rays, int points, const Holds& holds)
{
    int hits = 0;
    for (int seed = 0; seed < rays; ++seed) {
        INFO("seed " << seed);
        Rng rng(static_cast<std::uint32_t>(seed));
        Ray ray = csg_test::ray_near(rng, {0, 0.3, 0}, 1.4, rng.coin() ? 6.0 : 0.5);
        if (seed % 7 == 1) ray.direction.y = 0.0;
        if (seed % 7 == 2) ray.direction.y *= std::pow(10.0, rng.uniform(-14.0, -2.0));
        if (seed % 7 == 3) ray.direction = glm::normalize(-ray.origin + rng.point(1e-9));
        if (seed % 7 == 4)
            ray.direction = {0.0, rng.coin() ? 1.0 : -1.0, 0.0},
            ray.origin = {rng.uniform(-1, 1), 4.0, rng.uniform(-1, 1)};
        FixedSpans<32> spans;
        solid.intersect(ray, spans);
        hits += !spans.empty();
        for (const Span& span : spans) REQUIRE(span.in.t <= span.out.t);
        for (int i = 0; i < points; ++i) {
            const double t = i % 2 == 0      ? rng.uniform(-1.0, 8.0)
                             : spans.empty() ? 6.0
                                             : spans[0].in.t + rng.uniform(-0.5, 1.5);
            bool clear = true;
            for (const Span& span : spans)
                clear = clear && std::abs(t - span.in.t) > 1e-5 && std::abs(t - span.out.t) > 1e-5;
            if (clear) REQUIRE(spans.contains(t) == holds(ray.at(t)));
        }
    }
    CHECK(hits > rays / 5);
}

Freeform cone_of(const std::vector<OutlinePiece>& pieces, double low, double high)
{
    const auto outline = std::make_shared<OutlineShape>(pieces);
    const glm::dvec2 reach[2] = {outline->lower(), outline->upper()};
    return {make_freeform<ConicPrism>(outline, low, high, false, reach), {}};
}

void check_cone(const std::vector<OutlinePiece>& pieces, double low, double high)
{
    const Corners corners = polygon(pieces);
    const Freeform solid = cone_of(pieces, low, high);
    int off = 0;
    check_spans(solid, csg_test::share(300), 16, [&](const glm::dvec3& p) {
        const bool held = p.y >= low && p.y <= high && p.y != 0.0 && inside(corners, {p.x / p.y, p.z / p.y});
        if (held == solid.contains(p)) return held;
        ++off;  // nearer to a curve than its polygon
        return solid.contains(p);
    });
    CHECK(off < 3);
}

std::vector<OutlinePiece> loop(const Corners& p)
{
    std::vector<OutlinePiece> pieces;
    for (std::size_t i = 0; i < p.size(); ++i) pieces.push_back(OutlinePiece::line(p[i], p[(i + 1) % p.size()]));
    return pieces;
}

std::vector<OutlinePiece> round_loop()
{
    const glm::dvec2 a(1, 0), b(0, 1.2), c(-1.1, -0.2);
    return {OutlinePiece::quadratic(a, {1.4, 1.3}, b), OutlinePiece::quadratic(b, {-1, 0.4}, c),
            OutlinePiece::quadratic(c, {0.2, -2}, a)};
}

}  // namespace

TEST_CASE("a conic prism's spans are its inside", "[csg][conic_prism]")
{
    const Corners star = {{1, 0}, {0.3, 0.3}, {0, 1.1}, {-0.4, 0.2}, {-1, -0.3}, {0.1, -0.9}};
    check_cone(loop(star), 0.2, 1.2);
    check_cone(loop(star), -0.8, 1.0);
    check_cone(loop(star), 0.0, 1.0);
    check_cone(loop(star), -1.5, -0.1);
    check_cone(round_loop(), -0.8, 1.0);
    const Corners beside = {{0.5, 0.5}, {2, 0.5}, {2, 1.5}, {0.5, 1.5}};  // the axis is outside
    check_cone(loop(beside), -1.0, 1.0);
}

TEST_CASE("an egg's spans are its inside", "[csg][ovus]")
{
    for (const double top : {0.0, 0.3, 0.6, 0.8, 0.9, 1.3, 1.55}) {
        const Freeform solid{make_freeform<Ovus>(0.8, top), {}};
        INFO("top " << top);
        check_spans(solid, csg_test::share(3000), 16, [&](const glm::dvec3& p) { return solid.contains(p); });
        const Aabb box = solid.bounds();
        Rng rng(5);
        for (int i = 0; i < 2000; ++i) {
            // Convex, and within its box: the middle of two inside points is inside.
            const glm::dvec3 a = rng.point(2.0), b = rng.point(2.0);
            if (solid.contains(a))
                REQUIRE((glm::all(glm::lessThan(box.lower, a)) && glm::all(glm::lessThan(a, box.upper))));
            if (solid.contains(a) && solid.contains(b)) REQUIRE(solid.contains(0.5 * (a + b)));
        }
    }
}

TEST_CASE("the nearest crossing of an egg alone is the nearest of all", "[csg][ovus]")
{
    const Freeform solid{make_freeform<Ovus>(0.8, 0.5), {}};
    for (std::uint32_t seed = 0; seed < 5000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const Ray ray = csg_test::ray_near(rng, {0, 0.3, 0}, 1.2, rng.coin() ? 6.0 : 0.5);
        const double from = rng.coin() ? 0.0 : rng.uniform(4.0, 7.0);
        double nearest[2] = {kInfinity, kInfinity};
        for (const bool first : {false, true}) {
            IntersectionList record(from, kInfinity, first);
            solid.intersect(ray, record);
            record.each_span([&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
                if (in >= from && in_face != kUndrawnFace) nearest[first] = std::min(nearest[first], in);
                if (out >= from && out_face != kUndrawnFace) nearest[first] = std::min(nearest[first], out);
            });
        }
        REQUIRE(nearest[0] == nearest[1]);
    }
}

TEST_CASE("an egg is smooth where its parts meet", "[csg][ovus]")
{
    for (const double top : {0.3, 0.8, 1.3}) {
        const Freeform solid{make_freeform<Ovus>(0.8, top), {}};
        glm::dvec3 last(0.0);
        for (int i = 1; i < 4000; ++i) {
            const double angle = 3.14159265358979 * i / 4000.0;
            FixedSpans<4> spans;
            const Ray ray{{0.0, 0.4, 0.0}, {std::sin(angle), -std::cos(angle), 0.0}};
            solid.intersect(ray, spans);
            REQUIRE(spans.size() == 1);
            const glm::dvec3 n = solid.normal(ray.at(spans[0].out.t), spans[0].out.face);
            if (i > 1) REQUIRE(glm::length(n - last) < 0.01);
            last = n;
        }
    }
}

TEST_CASE("conic prisms and eggs bear any question", "[csg][conic_prism][ovus]")
{
    const Freeform solids[] = {cone_of(round_loop(), -1, 1),
                               cone_of({}, 0, 1),
                               {make_freeform<Ovus>(1.0, 0.5), {}},
                               {make_freeform<Ovus>(1.0, 0.0), {}}};
    for (const Freeform& solid : solids) {
        Rng rng(3);
        for (int k = 0; k < 6000; ++k) {
            const Ray ray = csg_test::hostile_ray(rng);
            IntersectionList record(0.0, kInfinity, k % 2 == 0);
            solid.intersect(ray, record);
            record.each_span([](double in, std::uint32_t, double out, std::uint32_t) { REQUIRE_FALSE(out < in); });
            (void)solid.contains(ray.origin);
        }
    }
}
