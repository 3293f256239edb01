#include "csg/freeform/surface/parametric.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace csg;
using csg_test::Rng;

namespace {

/// f(u, v) by a plain function.
class Plain final : public Field {
public:
    explicit Plain(double (*f)(double, double)) : f_(f) {}
    double value(const glm::dvec3& p) const override { return f_(p.x, p.y); }
    void values(const EightPoints& p, Eight& out) const override
    {
        for (int k = 0; k < 8; ++k) out.v[k] = f_(p.x.v[k], p.y.v[k]);
    }
    void ranges(const EightBoxes&, EightRanges& out) const override
    {
        for (int k = 0; k < 8; ++k) {
            out.low.v[k] = -kInfinity;
            out.high.v[k] = kInfinity;
        }
    }
    bool ranged() const override { return false; }

private:
    double (*f_)(double, double);
};

ParametricTerms ball()
{
    ParametricTerms terms;
    terms.field = {std::make_shared<Plain>([](double u, double v) { return std::sin(u) * std::cos(v); }),
                   std::make_shared<Plain>([](double u, double v) { return std::sin(u) * std::sin(v); }),
                   std::make_shared<Plain>([](double u, double) { return std::cos(u); })};
    terms.upper = {2.0 * 3.14159265358979, 3.14159265358979};
    terms.max_gradient = 1.5;
    terms.container = Container::sphere(glm::dvec3(0.0), 1.2);
    return terms;
}

struct Touch {
    double t = kInfinity;
    std::uint32_t face = 0;
};

Touch touch(const Parametric& surface, const Ray& ray)
{
    IntersectionList record(0.0, kInfinity, false);
    surface.intersect(ray, record);
    Touch found;
    record.each_touching([&](double t, std::uint32_t face) { found = {t, face}; });
    return found;
}

}  // namespace

TEST_CASE("a parametric ball is met where the ball is, within some accuracies", "[csg][parametric]")
{
    Parametric surface(ball());
    surface.prepare();
    int hits = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const Ray ray = csg_test::ray_near(rng, glm::dvec3(0.0), 0.7, 5.0);
        const double foot = -glm::dot(ray.origin, ray.direction),
                     rest = 1.0 - (glm::dot(ray.origin, ray.origin) - foot * foot);
        // Grazing rays are moved far by the shift. The range of the last coordinate alone says how far a hit is, which
        // is coarse for a ray nearly level in it.
        if (rest < 0.3 || std::abs(ray.direction.z) < 0.3) continue;
        const Touch found = touch(surface, ray);
        REQUIRE(std::abs(found.t - (foot - std::sqrt(rest))) < 0.03);
        const glm::dvec3 p = ray.at(found.t);
        const glm::dvec2 uv = surface.uv(p, found.face);
        const glm::dvec3 named(std::sin(uv.x) * std::cos(uv.y), std::sin(uv.x) * std::sin(uv.y), std::cos(uv.x));
        REQUIRE(glm::length(named - p) < 0.03);
        const glm::dvec3 n = glm::normalize(surface.gradient(p, found.face));
        if (std::abs(std::sin(uv.x)) > 0.05) REQUIRE(std::abs(glm::dot(n, p)) > 0.99);
        ++hits;
    }
    CHECK(hits > 100);
}

TEST_CASE("what is precomputed hardly moves a hit", "[csg][parametric]")
{
    Parametric plain(ball());
    plain.prepare();
    ParametricTerms terms = ball();
    terms.precompute = 14;
    terms.precomputed = {true, true, true};
    Parametric united(terms);
    united.prepare();
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const Ray ray = csg_test::ray_near(rng, glm::dvec3(0.0), 0.5, 5.0);
        const Touch a = touch(plain, ray), b = touch(united, ray);
        REQUIRE((a.t < kInfinity) == (b.t < kInfinity));
        if (a.t < kInfinity) REQUIRE(std::abs(a.t - b.t) < 0.02);
    }
}

TEST_CASE("a parametric surface survives numbers that are none", "[csg][parametric]")
{
    for (const double bad : {std::nan(""), kInfinity, -kInfinity})
        for (int place = 0; place < 3; ++place) {
            ParametricTerms terms = ball();
            if (place == 1) terms.max_gradient = bad > 0.0 ? 0.0 : bad;
            Parametric surface(terms);
            surface.prepare();
            Ray ray{{-5, 0.1, 0.2}, {1, 0, 0}};
            (place == 0 ? ray.origin.y : place == 1 ? ray.direction.x : ray.direction.z) = bad;
            (void)touch(surface, ray);
            if (place != 2) continue;
            terms.field[1] = std::make_shared<Plain>([](double u, double) { return u > 1.0 ? std::nan("") : u; });
            Parametric holed(terms);
            holed.prepare();
            (void)touch(holed, {{-5, 0.1, 0.2}, {1, 0, 0}});
        }
}
