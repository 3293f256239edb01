#pragma once

#include "tests/csg/residual.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <cmath>

/// What holds for any solid.
namespace csg_test {

struct Check {
    glm::dvec3 target{0.0};    ///< rays pass near it
    double size = 1.5;         ///< within this distance
    double distance = 5.0;     ///< from so far away
    double tolerance = 1e-12;  ///< of a crossing from the surface, in the solid's own units
    std::uint32_t rays = 2000;
    int least_hits = 200;  ///< of them, so that a test cannot pass by missing
};

inline bool within(const csg::Aabb& box, const glm::dvec3& p, double slack)
{
    for (int i = 0; i < 3; ++i)
        if (!(p[i] >= box.lower[i] - slack && p[i] <= box.upper[i] + slack)) return false;
    return true;
}

/// The laws of any solid: crossings lie on the surface, span middles are inside, points just beyond are not, bounds
/// hold every span, normals have unit length and point out, and scaling the direction scales the parameter.
template <class T>
void check_solid(const T& solid, const Check& how = {})
{
    int hits = 0;
    const double just = 1e-6 * how.size;  // beyond an end; spans and gaps shorter than that prove nothing
    const double rounding = 4e-16 * (how.distance + glm::length(how.target));
    for (std::uint32_t seed = 0; seed < how.rays; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const csg::Ray ray = ray_near(rng, how.target, how.size, rng.coin() ? how.distance : 0.5 * how.size);
        csg::FixedSpans<8> spans;
        intersect(solid, ray, spans);
        for (std::uint32_t i = 0; i < spans.size(); ++i) {
            ++hits;
            const csg::Span& span = spans[i];
            for (const csg::Crossing& end : {span.in, span.out}) {
                if (!std::isfinite(end.t)) continue;
                REQUIRE(residual(solid, ray, end.t, end.face) <= how.tolerance);
                REQUIRE(within(solid.bounds(), ray.at(end.t), 4.0 * rounding + how.tolerance * how.size));
                const glm::dvec3 n = solid.normal(ray.at(end.t), end.face);
                REQUIRE(glm::length(n) == Approx(1.0).epsilon(1e-12));
                const double along = glm::dot(n, ray.direction);  // 1e-4: a grazing ray's crossing is that far off
                if (end.face != csg::kUndrawnFace) REQUIRE((end.t == span.in.t ? along <= 1e-4 : along >= -1e-4));
            }
            const double first = std::max(span.in.t, -1e3 * how.distance),
                         last = std::min(span.out.t, 1e3 * how.distance);
            if (last - first > 4.0 * just) {
                REQUIRE(solid.contains(ray.at(0.5 * (first + last))));
                REQUIRE_FALSE(solid.contains_inverted(ray.at(0.5 * (first + last))));
            }
            const bool gap_before = i == 0 || span.in.t - spans[i - 1].out.t > 2.0 * just;
            if (std::isfinite(span.in.t) && gap_before) REQUIRE_FALSE(solid.contains(ray.at(span.in.t - just)));
            const bool gap_after = i + 1 == spans.size() || spans[i + 1].in.t - span.out.t > 2.0 * just;
            if (std::isfinite(span.out.t) && gap_after) REQUIRE_FALSE(solid.contains(ray.at(span.out.t + just)));
        }
        // Points along the ray agree with the spans, where they are clear of an end.
        for (int k = 0; k < 8; ++k) {
            const double t = rng.uniform(-2.0, 2.0) * how.size + (k % 2 ? how.distance : 0.0);
            bool clear = true;
            for (const csg::Span& span : spans)
                clear = clear && std::abs(t - span.in.t) > just && std::abs(t - span.out.t) > just;
            if (clear) REQUIRE(spans.contains(t) == solid.contains(ray.at(t)));
        }
        csg::FixedSpans<8> slow;
        intersect(solid, csg::Ray{ray.origin, 0.25 * ray.direction}, slow);
        REQUIRE(slow.size() == spans.size());
        for (std::uint32_t i = 0; i < spans.size(); ++i)
            if (std::isfinite(spans[i].in.t))
                REQUIRE(slow[i].in.t == Approx(4.0 * spans[i].in.t).margin(1e-9 * how.size + 1e3 * rounding));
    }
    REQUIRE(hits >= how.least_hits);
}

/// Whatever is asked, no NaN comes back.
template <class T>
void check_hostile(const T& solid)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = numbers::kInfinity;
    const double values[] = {0.0, -0.0, 1.0, -1.0, 1e-320, 1e308, -1e308, inf, -inf, nan, 1e-160};
    Rng rng(7);
    for (int k = 0; k < 4000; ++k) {
        csg::Ray ray{};
        for (int i = 0; i < 3; ++i) {
            ray.origin[i] = values[rng.below(11)];
            ray.direction[i] = values[rng.below(11)];
        }
        csg::FixedSpans<8> spans;
        intersect(solid, ray, spans);
        for (const csg::Span& span : spans) REQUIRE(span.in.t <= span.out.t);
    }
}

}  // namespace csg_test
