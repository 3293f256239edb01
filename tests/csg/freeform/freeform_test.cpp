#include "csg/freeform/freeform.h"
#include "csg/base/hit.h"
#include "csg/freeform/freeform_solid.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace csg;
using csg_test::Rng;

// Shapes of csg/freeform/freeform.h against their definitions: how far inside a point is, summed or sampled with no
// cleverness.
namespace {

struct Case {
    double size = 1.5;         ///< rays pass so near the origin
    double at_surface = 1e-9;  ///< largest |amount| at an end, in the amount's own unit
    double in_doubt = 1e-9;    ///< smaller amounts prove nothing
    int least_hits = 100;
};

struct Ends {
    std::vector<glm::dvec2> spans;
    std::vector<glm::uvec2> faces;
    bool hold(double t) const
    {
        for (const glm::dvec2& s : spans)
            if (t > s.x && t < s.y) return true;
        return false;
    }
};

template <class Form>
Ends ends_of(const Form& form, const Ray& ray, double from = -kInfinity, double to = kInfinity)
{
    IntersectionList record(from, to, false);
    form.intersect(ray, record);
    Ends ends;
    record.each_span([&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
        ends.spans.push_back({in, out});
        ends.faces.push_back({in_face, out_face});
    });
    return ends;
}

/// amount(p): positive inside, by the definition.
template <class Form, class Amount>
int check_ray(const Form& form, const Ray& ray, Amount&& amount, const Case& how)
{
    const Ends ends = ends_of(form, ray);
    for (std::size_t i = 0; i < ends.spans.size(); ++i) {
        if (i > 0) REQUIRE(ends.spans[i - 1].y <= ends.spans[i].x);
        REQUIRE(ends.spans[i].x <= ends.spans[i].y);
        for (const int k : {0, 1}) {
            const double t = ends.spans[i][k];
            REQUIRE(std::abs(amount(ray.at(t))) <= how.at_surface);
            const glm::dvec3 n = form.gradient(ray.at(t), ends.faces[i][k]);
            const double along = glm::dot(n, ray.direction) / glm::length(n);
            if (ends.spans[i].y - ends.spans[i].x > 1e-3) REQUIRE((k == 0 ? along < 1e-3 : along > -1e-3));
        }
    }
    const double middle = -glm::dot(ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);
    for (int k = -100; k <= 100; ++k) {
        const double t = middle + 0.02 * how.size * k / glm::length(ray.direction);
        const double a = amount(ray.at(t));
        if (std::abs(a) <= how.in_doubt) continue;
        REQUIRE(ends.hold(t) == (a > 0.0));
        REQUIRE(form.contains(ray.at(t)) == (a > 0.0));
    }
    // The same seen from the other end, and what a part of the ray has.
    const Ends back = ends_of(form, {ray.origin, -ray.direction});
    REQUIRE(back.spans.size() == ends.spans.size());
    for (std::size_t i = 0; i < ends.spans.size(); ++i)
        REQUIRE(std::abs(back.spans[ends.spans.size() - 1 - i].y + ends.spans[i].x) < 1e-6);
    const Ends part = ends_of(form, ray, middle - 0.1, middle + 0.2);
    for (int k = 1; k < 30; ++k) {
        const double t = middle - 0.1 + 0.01 * k;
        if (std::abs(amount(ray.at(t))) > how.in_doubt) REQUIRE(part.hold(t) == ends.hold(t));
    }
    return static_cast<int>(ends.spans.size());
}

template <class Form, class Amount>
void check_form(const Form& form, Amount&& amount, const Case& how = {})
{
    int hits = 0;
    for (std::uint32_t seed = 0; seed < csg_test::share(400); ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        Ray ray = csg_test::ray_near(rng, glm::dvec3(0.0), how.size, rng.coin() ? 5.0 * how.size : how.size);
        if (seed % 7 == 0) ray.direction = glm::dvec3(0.0), ray.direction[rng.below(3)] = rng.coin() ? 1.0 : -1.0;
        if (seed % 5 == 0) ray.direction *= rng.uniform(0.1, 3.0);
        hits += check_ray(form, ray, amount, how);
    }
    CHECK(hits >= csg_test::share(how.least_hits) - 1);
}

Blob::Component sphere(const glm::dvec3& center, double radius, double strength)
{
    return {Transform::translate(center), 0.0, radius, strength, 0};
}

/// The field by its definition, less the threshold.
double field(const std::vector<Blob::Component>& all, double threshold, const glm::dvec3& p)
{
    double sum = -threshold;
    for (const Blob::Component& c : all) {
        const glm::dvec3 q = c.frame.inverse_point(p);
        const glm::dvec3 nearest(0.0, 0.0, std::min(std::max(q.z, 0.0), c.length));
        const double part = glm::dot(q - nearest, q - nearest) / (c.radius * c.radius);
        if (part < 1.0) sum += c.strength * (1.0 - part) * (1.0 - part);
    }
    return sum;
}

std::vector<Blob::Component> random_components(Rng& rng, int count)
{
    std::vector<Blob::Component> all;
    for (int i = 0; i < count; ++i) {
        Blob::Component c = sphere(rng.point(1.2), rng.uniform(0.3, 1.0), rng.uniform(-0.5, 1.5));
        if (rng.coin())
            c.frame = Transform::translate(rng.point(0.8)) * csg_test::random_transform(rng) *
                      Transform::scale(glm::dvec3(0.7));
        if (rng.coin()) c.length = rng.uniform(0.1, 1.0);
        all.push_back(c);
    }
    return all;
}

}  // namespace

TEST_CASE("blobs hold where their fields exceed the threshold", "[csg][freeform]")
{
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        INFO("blob " << seed);
        Rng rng(seed);
        const auto components =
            random_components(rng, seed < 8 ? 1 + static_cast<int>(seed) : 40);  // the last through a hierarchy
        const double threshold = rng.uniform(0.1, 0.6);
        check_form(Blob(threshold, components), [&](const glm::dvec3& p) { return field(components, threshold, p); },
                   {.at_surface = 1e-9, .in_doubt = 2e-6, .least_hits = 0});
    }
}

TEST_CASE("of a blob the nearest end alone is the nearest of all, in the range and of the whole ray", "[csg][freeform]")
{
    int found = 0, none = 0;
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        INFO("blob " << seed);
        Rng rng(seed);
        const Blob blob(rng.uniform(0.1, 0.6) * (seed % 7 == 6 ? -1.0 : 1.0),
                        random_components(rng, seed % 5 == 4 ? 40 : 1 + static_cast<int>(seed % 12)));
        for (int i = 0; i < 200; ++i) {
            const Ray ray{rng.point(1.5), rng.direction()};  // often from inside
            const double from = rng.uniform(-1.0, 0.5), to = rng.coin() ? kInfinity : from + rng.uniform(0.1, 2.0);
            bool in_doubt = false;
            const auto nearest = [&](double asked_from, double asked_to, bool first_only) {
                IntersectionList record(asked_from, asked_to, first_only);
                blob.intersect(ray, record);
                double least = kInfinity;
                const auto offer = [&](double t, std::uint32_t face) {
                    in_doubt = in_doubt || std::min(std::abs(t - from), std::abs(t - to)) <= 1e-9;
                    if (face != kUndrawnFace && t >= from && t <= to) least = std::min(least, t);
                };
                record.each_span([&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
                    offer(in, in_face);
                    offer(out, out_face);
                });
                return least;
            };
            const double all = nearest(from, to, false), first = nearest(from, to, true),
                         anywhere = nearest(-kInfinity, kInfinity, false);
            ++(all < kInfinity ? found : none);
            REQUIRE((all < kInfinity) == (first < kInfinity));
            if (all < kInfinity) REQUIRE(std::abs(all - first) <= 1e-9);
            if (in_doubt) continue;
            REQUIRE((all < kInfinity) == (anywhere < kInfinity));
            if (all < kInfinity) REQUIRE(std::abs(all - anywhere) <= 1e-9);
        }
    }
    CHECK(found > 1000);
    CHECK(none > 1000);
}

TEST_CASE("a ball's field makes a ball", "[csg][freeform]")
{
    const double r = std::sqrt(1.0 - std::sqrt(0.5));  // spec 5a, 5.11: 0.541196100146
    for (const double scale : {1e-6, 1.0, 1e6}) {
        const Blob blob(0.5, {sphere({0, 0, 0}, scale, 1.0)});
        const Ends ends = ends_of(blob, {{0, 0.1 * scale, -100.0 * scale}, {0, 0, 1}});
        REQUIRE(ends.spans.size() == 1);
        const double half = std::sqrt(r * r - 0.01);
        CHECK(std::abs(ends.spans[0].x - (100.0 - half) * scale) <= 4e-14 * scale);
        CHECK(std::abs(ends.spans[0].y - (100.0 + half) * scale) <= 4e-14 * scale);
    }
}

TEST_CASE("what a description stands for is made once, when it is asked for", "[csg][freeform]")
{
    int made = 0;
    const auto later = make_freeform_later(Blob(0.5, {}), [&] {
        ++made;
        return Blob(0.5, {sphere({0, 0, 0}, 1.0, 1.0)});
    });
    const std::shared_ptr<const FreeformShape> copy = later;
    CHECK(made == 0);
    const auto first = drawn_shape(later), second = drawn_shape(copy);
    CHECK((made == 1 && first == second));
    CHECK(std::get<Blob>(first->kind).contains({0, 0, 0}));
    CHECK(drawn_shape(first) == first);
}

TEST_CASE("parts of a blob share a point by their fields", "[csg][freeform]")
{
    Blob::Component red = sphere({-0.7, 0, 0}, 1.5, 1.0), blue = sphere({0.7, 0, 0}, 1.5, 1.0);
    blue.part = 1;
    std::vector<Share> shares;
    Blob(0.5, {red, blue}).shares({0.25, 0, 0}, shares);
    REQUIRE(shares.size() == 2);
    const double a = std::pow(1.0 - 0.95 * 0.95 / 2.25, 2), b = std::pow(1.0 - 0.45 * 0.45 / 2.25, 2);
    CHECK(static_cast<double>(shares[0].weight) == Approx(a / (a + b)).epsilon(1e-6));
    CHECK(static_cast<double>(shares[1].weight) == Approx(b / (a + b)).epsilon(1e-6));
}

TEST_CASE("superellipsoids hold where their length is below 1", "[csg][freeform]")
{
    const glm::dvec2 all[] = {{1, 1},     {0.2, 0.2}, {0.01, 0.05}, {0, 0},   {2, 2},  {1.5, 0.3},
                              {0.3, 1.7}, {2.5, 2.5}, {3, 0.5},     {0.5, 3}, {1, 2.6}};
    for (const glm::dvec2& e : all) {
        INFO("exponents " << e.x << ", " << e.y);
        const auto length = [](double u, double v, double power) {
            const double most = std::max(u, v);
            return most > 0.0 ? most * std::pow(1.0 + std::pow(std::min(u, v) / most, power), 1.0 / power) : 0.0;
        };
        check_form(Superellipsoid(e.x, e.y),
                   [&](const glm::dvec3& p) {
                       return 1.0 - length(length(std::abs(p.x), std::abs(p.y), 2.0 / e.x), std::abs(p.z), 2.0 / e.y);
                   },
                   {.at_surface = 1e-9, .in_doubt = 1e-9, .least_hits = 20});
    }
}

namespace {

using SweptSphere = SphereSweep::SweptSphere;

/// Spheres at places of the spline, 401 to a segment, in groups of neighbours.
struct Samples {
    struct Group {
        glm::dvec3 center;
        double reach;  ///< what its spheres reach from there
        std::vector<SweptSphere> spheres;
    };
    std::vector<Group> groups;

    void add(const SweptSphere& sphere)
    {
        constexpr std::size_t kGroup = 20;
        if (groups.empty() || groups.back().spheres.size() == kGroup) groups.push_back({sphere.center, 0.0, {}});
        Group& last = groups.back();
        last.spheres.push_back(sphere);
        last.reach = std::max(last.reach, glm::length(sphere.center - last.center) + sphere.radius);
    }
    /// The largest of r - |p - c|.
    double within(const glm::dvec3& p) const
    {
        double most = -kInfinity;
        for (const Group& g : groups)
            if (g.reach - glm::length(p - g.center) > most)
                for (const SweptSphere& s : g.spheres) most = std::max(most, s.radius - glm::length(p - s.center));
        return most;
    }
};

Samples samples_of(SphereSweep::Spline spline, const std::vector<SweptSphere>& b)
{
    constexpr int kSteps = 400;
    Samples samples;
    const bool linear = spline == SphereSweep::Spline::Linear;
    for (std::size_t i = 0; i + (linear ? 1 : 3) < b.size(); ++i)
        for (int k = 0; k <= kSteps; ++k) {
            const double u = static_cast<double>(k) / kSteps, u2 = u * u, u3 = u2 * u;
            double w[4] = {1.0 - u, u, 0.0, 0.0};
            if (spline == SphereSweep::Spline::Cubic) {
                const double cubic[4] = {(-u + 2 * u2 - u3) / 2, (2 - 5 * u2 + 3 * u3) / 2, (u + 4 * u2 - 3 * u3) / 2,
                                         (u3 - u2) / 2};
                std::copy(cubic, cubic + 4, w);
            } else if (spline == SphereSweep::Spline::B) {
                const double basis[4] = {(1 - u) * (1 - u) * (1 - u) / 6, (4 - 6 * u2 + 3 * u3) / 6,
                                         (1 + 3 * u + 3 * u2 - 3 * u3) / 6, u3 / 6};
                std::copy(basis, basis + 4, w);
            }
            glm::dvec3 c(0.0);
            double r = 0.0;
            for (std::size_t j = 0; j < (linear ? 2u : 4u); ++j) {
                c += w[j] * b[i + j].center;
                r += w[j] * b[i + j].radius;
            }
            samples.add({c, std::abs(r)});
        }
    return samples;
}

}  // namespace

TEST_CASE("sphere sweeps hold what one of their balls holds", "[csg][freeform]")
{
    for (const auto spline : {SphereSweep::Spline::Linear, SphereSweep::Spline::Cubic, SphereSweep::Spline::B}) {
        for (std::uint32_t seed = 0; seed < 2; ++seed) {
            INFO("spline " << static_cast<int>(spline) << ", sweep " << seed);
            Rng rng(seed);
            std::vector<SweptSphere> spheres;
            for (int i = 0; i < (seed == 0 ? 5 : 13); ++i) spheres.push_back({rng.point(1.0), rng.uniform(0.05, 0.4)});
            // Between two of 400 samples of a segment of length 3 the envelope is missed by (3 / 400)^2 / (8 * 0.05)
            // and less.
            const Samples samples = samples_of(spline, spheres);
            check_form(SphereSweep(spline, spheres), [&](const glm::dvec3& p) { return samples.within(p); },
                       {.at_surface = 4e-4, .in_doubt = 4e-4, .least_hits = 20});
        }
    }
}

TEST_CASE("degenerate freeform solids are quiet", "[csg][freeform]")
{
    const double nan = std::nan("");
    const Ray rays[] = {
        {{0, 0, -5}, {0, 0, 1}}, {{0, 0, 0}, {0, 1, 0}}, {{nan, 0, 0}, {0, 0, 1}}, {{0, 0, -1e300}, {0, 0, 1e-300}}};
    const auto quiet = [&](const auto& form) {
        for (const Ray& ray : rays) {
            const Ends ends = ends_of(form, ray);
            CHECK(ends.spans.size() <= IntersectionList::kMostSpans);
        }
        form.contains({nan, 0, 0});
        form.gradient({0, 0, 0}, 0);
    };
    quiet(Blob(0.5, {sphere({0, 0, 0}, 0.0, 1.0), sphere({nan, 0, 0}, 1.0, 1.0), sphere({0, 0, 0}, 1.0, 0.0)}));
    quiet(Blob(-0.5, {sphere({0, 0, 0}, 1.0, -1.0), sphere({0, 1, 0}, 1.0, 1.0)}));
    quiet(Blob(nan, {sphere({0, 0, 0}, 1.0, 1.0)}));
    for (const glm::dvec2& e :
         {glm::dvec2(nan, 1), glm::dvec2(-1, 1), glm::dvec2(0, -2), glm::dvec2(1e300, 1e300), glm::dvec2(1e-300, 1)})
        quiet(Superellipsoid(e.x, e.y));
    const SweptSphere bad[] = {{{nan, 0, 0}, 1}, {{0, 0, 0}, 0}, {{0, 0, 0}, -1}, {{1, 0, 0}, 1e300}, {{0, 1, 0}, 0.5}};
    for (const auto spline : {SphereSweep::Spline::Linear, SphereSweep::Spline::B}) quiet(SphereSweep(spline, bad));
}
