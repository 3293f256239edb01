#include "csg/freeform/field/julia.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <vector>

using namespace csg;
using csg_test::Rng;
using Function = JuliaTerms::Function;
using Number = std::complex<double>;

namespace {

/// A hypercomplex number is a pair of complex ones, each of which goes its own way.
bool pair_stays(Number a, Number b, Number ca, Number cb, int iterations, const auto& f)
{
    for (int k = 0; k < iterations; ++k) {
        if (!(0.5 * (std::norm(a) + std::norm(b)) <= 16.0)) return false;
        a = f(a) + ca;
        b = f(b) + cb;
    }
    return true;
}

JuliaTerms terms(Function f)
{
    JuliaTerms t;
    t.constant = f <= Function::Cube ? glm::dvec4(-0.2, 0.6, 0.2, 0.2) : glm::dvec4(0.3, 0.2, -0.4, 0.1);
    t.function = f;
    t.exponent = {2.0, 0.3};
    t.iterations = f > Function::Reciprocal ? 2 : 6;  // more leave few points inside
    return t;
}

/// f(ray, what it is told) for random rays near a set.
void each_ray_near(const Julia& set, std::uint32_t rays, const auto& f)
{
    for (std::uint32_t seed = 0; seed < rays; ++seed) {
        INFO("function " << static_cast<int>(set.terms().function) << " seed " << seed);
        Rng rng(seed);
        const Ray ray = csg_test::ray_near(rng, glm::dvec3(0.0), 1.0, 6.0);
        IntersectionList record(0.0, kInfinity, false);
        set.intersect(ray, record);
        f(ray, record);
    }
}

}  // namespace

TEST_CASE("hypercomplex sets are pairs of complex ones", "[csg][julia]")
{
    const std::vector<std::pair<Function, Number (*)(Number)>> functions = {
        {Function::HyperSquare, [](Number v) { return v * v; }},
        {Function::Reciprocal, [](Number v) { return 1.0 / v; }},
        {Function::Exp, [](Number v) { return std::exp(v); }},
        {Function::Ln, [](Number v) { return std::log(v); }},
        {Function::Sin, [](Number v) { return std::sin(v); }},
        {Function::Cos, [](Number v) { return std::cos(v); }},
        {Function::Tan, [](Number v) { return std::tan(v); }},
        {Function::Sinh, [](Number v) { return std::sinh(v); }},
        {Function::Cosh, [](Number v) { return std::cosh(v); }},
        {Function::Tanh, [](Number v) { return std::tanh(v); }},
        {Function::Asinh, [](Number v) { return std::asinh(v); }},
        {Function::Atanh, [](Number v) { return std::atanh(v); }},
        {Function::Power, [](Number v) { return std::pow(v, Number(2.0, 0.3)); }}};
    for (const auto& [function, f] : functions) {
        const JuliaTerms t = terms(function);
        const Julia set(t);
        const glm::dvec4 c = t.constant;
        int inside = 0;
        for (std::uint32_t seed = 0; seed < 2000; ++seed) {
            INFO("function " << static_cast<int>(function) << " seed " << seed);
            Rng rng(seed);
            const glm::dvec3 p(rng.uniform(-3.5, 3.5), rng.uniform(-3.5, 3.5), rng.uniform(-3.5, 3.5));
            const double z = function > Function::Reciprocal ? p.y : p.z;  // POV-Ray's slip
            const bool stays = pair_stays({p.x, p.y + z}, {p.x, p.y - z}, {c.x - c.w, c.y + c.z},
                                          {c.x + c.w, c.y - c.z}, t.iterations, f);
            inside += stays ? 1 : 0;
            REQUIRE(set.contains(p) == stays);
        }
        CHECK(inside > 5);
    }
}

TEST_CASE("a ray's crossings part inside from outside", "[csg][julia]")
{
    for (const Function f : {Function::Square, Function::Cube, Function::HyperSquare}) {
        const JuliaTerms t = terms(f);
        const Julia set(t);
        int hits = 0;
        each_ray_near(set, 1000, [&](const Ray& ray, const IntersectionList& record) {
            record.each_span([&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
                REQUIRE(in <= out);
                if (in_face != kUndrawnFace) {
                    ++hits;
                    REQUIRE(set.contains(ray.at(in)));
                    REQUIRE_FALSE(set.contains(ray.at(in - 2e-7)));
                    const glm::dvec3 n = set.gradient(ray.at(in), in_face);
                    REQUIRE(std::isfinite(glm::dot(n, n)));
                }
                if (out_face != kUndrawnFace) {
                    REQUIRE(set.contains(ray.at(out)));
                    REQUIRE_FALSE(set.contains(ray.at(out + 2e-7)));
                }
            });
        });
        CHECK(hits > 200);
    }
}

TEST_CASE("a crossing shortly before the end of what is asked is found", "[csg][julia]")
{
    // The look behind it lies beyond that end, as under a clip or where a lamp stands in the set.
    for (const Function f : {Function::Square, Function::HyperSquare, Function::Sin}) {
        JuliaTerms t = terms(f);
        t.as_37 = false;
        const Julia set(t);
        std::vector<Ray> rays;
        std::vector<double> entries;
        each_ray_near(set, 300, [&](const Ray& ray, const IntersectionList& record) {
            record.each_span([&](double in, std::uint32_t face, double, std::uint32_t) {
                if (face != 0) return;
                rays.push_back(ray);
                entries.push_back(in);
            });
        });
        REQUIRE(rays.size() > 50);
        const auto tells = [](const IntersectionList& record, double entry) {
            bool told = false;
            record.each_span([&](double in, std::uint32_t, double, std::uint32_t) { told = told || in == entry; });
            return told;
        };
        std::vector<IntersectionList> many;
        for (const double entry : entries) many.emplace_back(0.0, entry * (1.0 + 1e-9), false);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            IntersectionList one = many[i];
            set.intersect(rays[i], one);
            CHECK(tells(one, entries[i]));
        }
        set.intersect_many(rays, many.data());
        for (std::size_t i = 0; i < rays.size(); ++i) CHECK(tells(many[i], entries[i]));
    }
}

TEST_CASE("a whole julia set leaves out no stretch that points of a ray lie in", "[csg][julia]")
{
    for (const Function f : {Function::Square, Function::Cube, Function::HyperSquare, Function::HyperCube}) {
        JuliaTerms t = terms(f);
        t.precision = 2.0;  // a march of such steps would pass over most of what is thin
        t.whole = true;
        const Julia set(t);
        int inside = 0, ends = 0;
        each_ray_near(set, 200, [&](const Ray& ray, const IntersectionList& record) {
            std::vector<std::pair<double, double>> spans;
            record.each_span([&](double in, std::uint32_t in_face, double out, std::uint32_t) {
                REQUIRE(in <= out);
                spans.emplace_back(in, out);
                if (in_face == kUndrawnFace) return;
                ++ends;
                // The normal looks out of the set.
                const glm::dvec3 p = ray.at(in), n = glm::normalize(set.gradient(p, in_face));
                if (glm::dot(n, ray.direction) < -0.2 * glm::length(ray.direction)) {
                    CHECK(set.contains(p - 1e-7 * n));
                    CHECK_FALSE(set.contains(p + 1e-7 * n));
                }
            });
            constexpr double kEnd = 1e-9;  // so near to an end a point may be on either side
            for (int i = 0; i < 2000; ++i) {
                const double at = 12.0 * (i + 0.5) / 2000.0;
                bool told = false, unsure = false;
                for (const auto& [in, out] : spans) {
                    told = told || (at >= in && at <= out);
                    unsure = unsure || std::abs(at - in) < kEnd || std::abs(at - out) < kEnd;
                }
                if (unsure) continue;
                INFO("at " << at);
                REQUIRE(set.contains(ray.at(at)) == told);
                inside += told ? 1 : 0;
            }
        });
        CHECK(inside > 1000);
        CHECK(ends > 40);
    }
}

TEST_CASE("a julia set is met from 6e9 away where it is met from beside it", "[csg][julia]")
{
    const Julia set(terms(Function::Square));
    const auto first = [&](const Ray& ray) {
        double t = kInfinity;
        IntersectionList record(0.0, kInfinity, false);
        set.intersect(ray, record);
        record.each_span([&](double in, std::uint32_t, double, std::uint32_t) { t = std::min(t, in); });
        return t;
    };
    int hits = 0, strays = 0;
    for (std::uint32_t seed = 0; seed < 500; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const glm::dvec3 d = rng.direction();
        const Ray far{0.7 * rng.point(1.0) - 6e9 * d, d};
        Ray beside = far;
        for (int k = 0; k < 3; ++k) beside.origin[k] = static_cast<double>(far.origin[k] + (6e9L - 6.0L) * d[k]);
        const double t = first(far), near = first(beside);
        hits += near < kInfinity;
        // A chord shorter than a step is met or not by where the steps fall.
        if ((t < kInfinity) != (near < kInfinity)) ++strays;
        else if (t < kInfinity && std::abs(t - 6e9 + 6.0 - near) > 2e-6) ++strays;  // two places of 6e9
    }
    CHECK(hits > 200);
    CHECK(strays == 0);
}

TEST_CASE("a large julia set is met within 1e-5 of the world's unit", "[csg][julia]")
{
    // POV-Ray's 1e-7 of the set's own unit would be 0.1 in the world, and a mirrored ray would meet its own start.
    constexpr double kScale = 1e6;
    const Julia set(terms(Function::Square));
    Rng rng(3);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 d = rng.direction();
        const Ray ray{0.7 * rng.point(1.0) - 6.0 * d, d / kScale};  // a unit of t is one of the world
        IntersectionList record(0.0, kInfinity, true);
        set.intersect(ray, record);
        record.each_span([&](double t, std::uint32_t face, double, std::uint32_t) {
            if (face == kUndrawnFace) return;
            ++hits;
            CHECK(set.contains(ray.at(t - 2e-5)) != set.contains(ray.at(t + 2e-5)));
        });
    }
    CHECK(hits > 500);
}

TEST_CASE("a julia set survives numbers that are none", "[csg][julia]")
{
    for (const double bad : {std::nan(""), kInfinity, -kInfinity, 0.0, 1e300})
        for (int place = 0; place < 3; ++place) {
            JuliaTerms t = terms(place == 0 ? Function::Square : place == 1 ? Function::HyperSquare : Function::Ln);
            const Julia good(t);
            Ray ray{{-5, 0.1, 0.2}, {1, 0, 0}};
            (place == 0 ? ray.origin.y : place == 1 ? ray.direction.x : ray.direction.z) = bad;
            IntersectionList record(0.0, kInfinity, false);
            good.intersect(ray, record);
            t.constant.y = bad;
            t.slice_distance = bad;
            IntersectionList other(0.0, kInfinity, false);
            Julia(t).intersect({{-5, 0.1, 0.2}, {1, 0, 0}}, other);
            (void)Julia(t).contains(glm::dvec3(0.1));
        }
}
