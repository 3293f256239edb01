#include "csg/freeform/field/isosurface.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace csg;
using csg_test::Rng;

namespace {

double square_low(double a, double b) { return a <= 0.0 && b >= 0.0 ? 0.0 : std::min(a * a, b * b); }

/// | r^2 - 1 | - thickness: a shell about the unit sphere, with or without ranges.
class Shell final : public Field {
public:
    Shell(double thickness, bool ranged) : thickness_(thickness), ranged_(ranged) {}

    double value(const glm::dvec3& p) const override { return std::abs(glm::dot(p, p) - 1.0) - thickness_; }
    void values(const EightPoints& p, Eight& out) const override
    {
        for (int k = 0; k < 8; ++k) out.v[k] = value({p.x.v[k], p.y.v[k], p.z.v[k]});
    }
    void ranges(const EightBoxes& b, EightRanges& out) const override
    {
        for (int k = 0; k < 8; ++k) {
            double low = -1.0, high = -1.0;
            for (const EightRanges* side : {&b.x, &b.y, &b.z}) {
                low += square_low(side->low.v[k], side->high.v[k]);
                high += std::max(side->low.v[k] * side->low.v[k], side->high.v[k] * side->high.v[k]);
            }
            out.low.v[k] = (low <= 0.0 && high >= 0.0 ? 0.0 : std::min(std::abs(low), std::abs(high))) - thickness_ -
                           1e-14;
            out.high.v[k] = std::max(std::abs(low), std::abs(high)) - thickness_ + 1e-14;
        }
    }
    bool ranged() const override { return ranged_; }

private:
    double thickness_;
    bool ranged_;
};

/// A rounded box that says so, or does not.
class Rounded final : public Field {
public:
    Rounded(const RoundedBox& box, bool says_so) : box_(box), says_so_(says_so) {}

    double value(const glm::dvec3& p) const override { return box_(p); }
    void values(const EightPoints& p, Eight& out) const override
    {
        for (int k = 0; k < 8; ++k) out.v[k] = value({p.x.v[k], p.y.v[k], p.z.v[k]});
    }
    void ranges(const EightBoxes& b, EightRanges& out) const override
    {
        for (int k = 0; k < 8; ++k) {
            glm::dvec3 near, far;
            const EightRanges* const sides[] = {&b.x, &b.y, &b.z};
            for (int axis = 0; axis < 3; ++axis) {
                const double low = sides[axis]->low.v[k], high = sides[axis]->high.v[k];
                near[axis] = std::sqrt(square_low(low, high));
                far[axis] = std::max(std::abs(low), std::abs(high));
            }
            out.low.v[k] = box_(near) - 1e-14;
            out.high.v[k] = box_(far) + 1e-14;
        }
    }
    bool ranged() const override { return true; }
    const RoundedBox* rounded_box() const override { return says_so_ ? &box_ : nullptr; }

private:
    RoundedBox box_;
    bool says_so_;
};

struct End {
    double t;
    std::uint32_t face;
};

std::vector<End> ends(const Isosurface& surface, const Ray& ray)
{
    IntersectionList record(0.0, kInfinity, false);
    surface.intersect(ray, record);
    std::vector<End> out;
    record.each_span([&](double in, std::uint32_t in_face, double end, std::uint32_t end_face) {
        out.push_back({in, in_face});
        out.push_back({end, end_face});
    });
    return out;
}

/// Crossings of a ray from outside with spheres about the origin, nearest first.
std::vector<double> exact(const Ray& ray, double thickness)
{
    std::vector<double> out;
    const double foot = -glm::dot(ray.origin, ray.direction), rest = glm::dot(ray.origin, ray.origin) - foot * foot;
    for (const double radius2 : {1.0 + thickness, 1.0 - thickness})
        if (radius2 > rest)
            for (const double side : {-1.0, 1.0}) out.push_back(foot + side * std::sqrt(radius2 - rest));
    std::sort(out.begin(), out.end());
    return out;
}

IsosurfaceTerms shell(double thickness, bool ranged)
{
    IsosurfaceTerms terms;
    terms.field = std::make_shared<Shell>(thickness, ranged);
    terms.max_gradient = ranged ? 1e-6 : 3.5;  // absurd: ranges do not ask for it
    terms.max_trace = 10;
    terms.container = Container::box(glm::dvec3(-1.5), glm::dvec3(1.5));
    return terms;
}

}  // namespace

TEST_CASE("every wall of a shell is found, no more than the accuracy behind it", "[csg][isosurface]")
{
    for (const bool ranged : {true, false})
        for (const double thickness : {0.3, 0.03}) {
            const IsosurfaceTerms terms = shell(thickness, ranged);
            const Isosurface surface(terms);
            int hits = 0;
            for (std::uint32_t seed = 0; seed < 2000; ++seed) {
                INFO("seed " << seed << " thickness " << thickness << " ranged " << ranged);
                Rng rng(seed);
                const Ray ray = csg_test::ray_near(rng, glm::dvec3(0.0), 1.2, 6.0);
                const std::vector<double> wanted = exact(ray, thickness);
                bool apart = true;  // what POV-Ray steps over behind a hit may hide the next
                for (std::size_t i = 1; i < wanted.size(); ++i)
                    apart = apart && wanted[i] - wanted[i - 1] > 8.0 * terms.accuracy;
                if (!apart) continue;
                const std::vector<End> found = ends(surface, ray);
                REQUIRE(found.size() == wanted.size());
                for (std::size_t i = 0; i < found.size(); ++i) {
                    REQUIRE(found[i].t >= wanted[i] - 1e-12);
                    REQUIRE(found[i].t <= wanted[i] + terms.accuracy);
                    REQUIRE(found[i].face != kUndrawnFace);
                    ++hits;
                }
            }
            CHECK(hits > 2000);
        }
}

TEST_CASE("ranges find what a gradient misses", "[csg][isosurface]")
{
    IsosurfaceTerms terms = shell(0.002, true);  // a film about as thick as the accuracy
    const Isosurface by_ranges(terms);
    terms.field = std::make_shared<Shell>(0.002, false);
    terms.max_gradient = 0.5;
    const Isosurface by_gradient(terms);
    int missed = 0;
    for (std::uint32_t seed = 0; seed < 500; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const Ray ray = csg_test::ray_near(rng, glm::dvec3(0.0), 0.8, 6.0);
        const std::vector<double> wanted = exact(ray, 0.002);
        if (wanted.size() != 4) continue;
        const std::vector<End> found = ends(by_ranges, ray);
        REQUIRE(!found.empty());
        REQUIRE(std::abs(found[0].t - wanted[0]) <= terms.accuracy);
        missed += ends(by_gradient, ray).empty() ? 1 : 0;
    }
    CHECK(missed > 100);
}

TEST_CASE("a ball has one span however far the ray begins", "[csg][isosurface]")
{
    // From 6e9 away a parameter's last digit is 1e-6: rounded points made dozens of crossings of a shallow one.
    for (const bool ranged : {true, false}) {
        IsosurfaceTerms terms;
        terms.field = std::make_shared<Shell>(1.0, ranged);  // |r^2 - 1| - 1: r^2 < 2, but for the point r = 0
        terms.accuracy = 1e-7;
        terms.max_gradient = 4.0;
        terms.container = Container::box(glm::dvec3(-1.6), glm::dvec3(1.6));
        const Isosurface surface(terms);
        Rng rng(5);
        int shallow = 0;
        const int rays = csg_test::share(4000);
        for (int i = 0; i < rays; ++i) {
            // Passes just below the surface.
            const glm::dvec3 way = rng.direction(), side = glm::normalize(glm::cross(way, rng.direction()));
            const Ray ray{std::sqrt(2.0) * (1.0 - rng.uniform(0.0, 1e-3)) * side - 6e9 * way, way};
            const std::vector<End> met = ends(surface, ray);
            INFO("ranged " << ranged << ", ray " << i);
            REQUIRE(met.size() <= 2);
            shallow += met.size() == 2 ? 1 : 0;
        }
        CHECK(shallow > 9 * rays / 20);
    }
}

TEST_CASE("gradients of many points are those of each", "[csg][isosurface]")
{
    const Isosurface surface(shell(0.3, true));
    Rng rng(11);
    for (const std::size_t count : {1u, 2u, 5u, 64u}) {
        std::vector<glm::dvec3> points, found(count);
        std::vector<std::uint32_t> faces;
        for (std::size_t i = 0; i < count; ++i) {
            points.push_back(rng.direction() * rng.uniform(0.5, 1.3));
            faces.push_back(i % 3 == 1 ? 2u : 7u);  // a wall of the container, the field
        }
        surface.gradients(points, faces, found.data());
        for (std::size_t i = 0; i < count; ++i) CHECK(found[i] == surface.gradient(points[i], faces[i]));
    }
}

TEST_CASE("an accuracy below the numbers' own leaves a normal", "[csg][isosurface]")
{
    IsosurfaceTerms terms = shell(0.01, true);
    Rng rng(6);
    for (const double accuracy : {1e-3, 1e-6, 1e-12, 1e-16, 1e-20}) {
        terms.accuracy = accuracy;
        const Isosurface surface(terms);
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 n = rng.direction(), g = surface.gradient(std::sqrt(1.01) * n, 7);
            INFO("accuracy " << accuracy);
            CHECK(glm::dot(glm::normalize(g), n) > 1.0 - 1e-5);
        }
    }
}

TEST_CASE("a way through the container much longer than the accuracy ends where numbers do", "[csg][isosurface]")
{
    // An isosurface 1e9 wide: its hits lie up to 1e-12 of the way behind it, and what a mirrored ray skips follows
    // that.
    IsosurfaceTerms terms = shell(1.0, true);
    terms.accuracy = 1e-7;
    const Isosurface surface(terms);
    Rng rng(8);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 d = rng.direction();
        const Ray ray{rng.point(1.0) - 6.0 * d, d / 1e9};
        for (const End& end : ends(surface, ray)) {
            const glm::dvec3 p = ray.at(end.t), n = glm::normalize(p);
            if (end.face != 7 || glm::dot(d, n) > -0.05) continue;
            ++hits;
            const Ray mirrored{p, (d - 2.0 * glm::dot(d, n) * n) / 1e9};
            for (const End& own : ends(surface, mirrored)) CHECK_FALSE((own.t > 0.0 && own.t < 1e3));
        }
    }
    CHECK(hits > 500);
}

TEST_CASE("walls are drawn as POV-Ray draws them", "[csg][isosurface]")
{
    IsosurfaceTerms terms = shell(2.5, true);  // the container lies inside: nothing but walls
    const auto faces = [&](const Ray& ray) {
        std::vector<std::uint32_t> out;
        for (const End& end : ends(Isosurface(terms), ray)) out.push_back(end.face);
        return out;
    };
    const Ray outside{{-5, 0.1, 0.2}, {1, 0, 0}}, inside{{0, 0.1, 0.2}, {1, 0, 0}};
    terms.container = Container::box(glm::dvec3(-0.5), glm::dvec3(0.5));
    CHECK(faces(outside) == std::vector<std::uint32_t>{0, kUndrawnFace});
    CHECK(faces(inside) == std::vector<std::uint32_t>{kUndrawnFace, 1});
    terms.container = Container::sphere(glm::dvec3(0.0), 0.5);
    CHECK(faces(outside) == std::vector<std::uint32_t>{Container::kSphereFace, kUndrawnFace});
    terms.open = true;
    CHECK(faces(outside) == std::vector<std::uint32_t>{kUndrawnFace, kUndrawnFace});
    CHECK(faces(inside) == std::vector<std::uint32_t>{kUndrawnFace, kUndrawnFace});
}

TEST_CASE("max_trace limits what is drawn, not what is inside", "[csg][isosurface]")
{
    IsosurfaceTerms terms = shell(0.3, true);
    const Ray ray{{-5, 0.1, 0.2}, {1, 0, 0}};
    for (const int most : {1, 2, 3}) {
        terms.max_trace = most;
        const std::vector<End> found = ends(Isosurface(terms), ray);
        REQUIRE(found.size() == 4);
        for (int i = 0; i < 4; ++i) CHECK((found[static_cast<std::size_t>(i)].face != kUndrawnFace) == (i < most));
    }
}

TEST_CASE("an isosurface survives numbers that are none", "[csg][isosurface]")
{
    IsosurfaceTerms terms = shell(0.3, true);
    const double nan = std::nan("");
    for (const double bad : {nan, kInfinity, -kInfinity, 0.0, 1e300})
        for (int place = 0; place < 3; ++place) {
            Ray ray{{-5, 0.1, 0.2}, {1, 0, 0}};
            (place == 0 ? ray.origin.y : place == 1 ? ray.direction.x : ray.direction.z) = bad;
            (void)ends(Isosurface(terms), ray);
            IsosurfaceTerms odd = terms;
            if (place == 0) odd.threshold = bad;
            else if (place == 1) odd.container = Container::sphere(glm::dvec3(0.0), bad);
            else odd.container = Container::box(glm::dvec3(bad), glm::dvec3(1.5));
            for (const End& end : ends(Isosurface(odd), {{-5, 0.1, 0.2}, {1, 0, 0}})) CHECK_FALSE(std::isnan(end.t));
        }
}

TEST_CASE("a rounded box is crossed where its ranges find it", "[csg][isosurface]")
{
    int crossed = 0;
    for (std::uint32_t seed = 0; seed < 4000; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const double radius = rng.uniform(0.01, 0.5);
        IsosurfaceTerms terms;
        terms.accuracy = rng.coin() ? 0.001 : rng.uniform(1e-5, 0.05);
        terms.threshold = rng.below(3) == 0 ? rng.uniform(-0.2, 0.2) : 0.0;
        terms.max_trace = 1 + rng.below(4);
        terms.open = rng.coin();
        terms.container = rng.below(4) == 0 ? Container::sphere(glm::dvec3(0.0), 0.7)
                                            : Container::box(glm::dvec3(-0.5), glm::dvec3(0.5));
        const RoundedBox box{glm::dvec3(0.5, 0.5, rng.uniform(0.3, 0.5)) - radius, radius};
        terms.field = std::make_shared<Rounded>(box, false);
        const Isosurface by_ranges(terms);
        terms.field = std::make_shared<Rounded>(box, true);
        const Isosurface by_secants(terms);
        for (int k = 0; k < 4; ++k) {
            const Ray ray = csg_test::ray_near(rng, glm::dvec3(0.0), 0.8, rng.coin() ? 3.0 : 0.3);
            const std::vector<End> wanted = ends(by_ranges, ray), found = ends(by_secants, ray);
            REQUIRE(found.size() == wanted.size());
            for (std::size_t i = 0; i < found.size(); ++i) {
                ++crossed;
                REQUIRE(found[i].t == wanted[i].t);
                REQUIRE(found[i].face == wanted[i].face);
            }
        }
    }
    CHECK(crossed > 10000);
}
