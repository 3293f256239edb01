#include "csg/freeform/freeform.h"
#include "numbers/lane_power.h"
#include "csg/freeform/freeform_solid.h"
#include "tests/csg/freeform/many_rays.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>

using namespace csg;
using csg_test::check_many;
using csg_test::Rng;
using csg_test::runs_here;
using csg_test::same_number;
using csg_test::share;
using csg_test::Told;

namespace {

/// Waves about a sphere; what it is at points is all that is known.
struct Waves final : Field {
    double value(const glm::dvec3& p) const override
    {
        return glm::dot(p, p) - 0.6 + 0.3 * std::sin(7.0 * p.x) * std::sin(5.0 * p.y + 1.0);
    }
    void values(const EightPoints& p, Eight& out) const override
    {
        for (int k = 0; k < 8; ++k) out.v[k] = value({p.x.v[k], p.y.v[k], p.z.v[k]});
    }
    void ranges(const EightBoxes&, EightRanges& out) const override
    {
        for (int k = 0; k < 8; ++k) out.low.v[k] = -kInfinity, out.high.v[k] = kInfinity;
    }
    bool ranged() const override { return false; }
};

}  // namespace

TEST_CASE("many rays of a julia fractal are told what each is told alone", "[csg][many][julia]")
{
    if (!runs_here()) return;
    using Kind = JuliaTerms::Function;
    for (const Kind function : {Kind::Square, Kind::Cube, Kind::HyperSquare, Kind::HyperCube, Kind::Exp, Kind::Ln,
                                Kind::Sin, Kind::Asin, Kind::Cos, Kind::Acos, Kind::Tan, Kind::Atan, Kind::Sinh,
                                Kind::Asinh, Kind::Cosh, Kind::Acosh, Kind::Tanh, Kind::Atanh, Kind::Power}) {
        INFO("function " << static_cast<int>(function));
        int ends = 0;
        // A share of the share of cases, as one takes long, and on until it has met the set often enough: some
        // functions leave little of it.
        const auto least = static_cast<std::uint32_t>(share(share(60)));
        const int wanted = share(share(600));
        for (std::uint32_t seed = 0; seed < least || (seed < 60 && ends <= wanted); ++seed) {
            Rng rng(seed + 1000);
            JuliaTerms terms;
            terms.function = function;
            terms.constant = function <= Kind::Cube ? glm::dvec4(-0.2, 0.6, 0.2, 0.2) : glm::dvec4(0.3, 0.2, -0.4, 0.1);
            if (rng.coin()) terms.constant *= rng.uniform(0.2, 1.0);
            terms.exponent = {rng.uniform(-1.0, 3.0), rng.uniform(-0.4, 0.4)};
            terms.iterations = 1 + rng.below(9);
            terms.precision = rng.uniform(5.0, 60.0);
            if (rng.coin()) {
                terms.slice = {rng.point(0.3), 1.0};
                terms.slice_distance = rng.uniform(-0.3, 0.3);
            }
            ends += check_many(Julia(terms), 1.2, seed);
        }
        CHECK(ends > wanted);
    }
}

TEST_CASE("many rays of a superellipsoid are told what each is told alone", "[csg][many]")
{
    if (!runs_here()) return;
    const glm::dvec2 exponents[] = {{1.0, 1.0}, {0.1, 0.1},  {0.5, 1.0}, {2.0, 2.0},
                                    {0.2, 1.5}, {1e-3, 0.7}, {1.0, 2.0}};
    for (const glm::dvec2& e : exponents) {
        int ends = 0;
        for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(share(200)); ++seed)
            ends += check_many(Superellipsoid(e.x, e.y), 1.0, seed);
        CHECK(ends > share(200) * 10);
    }
}

TEST_CASE("many rays of an isosurface are told what each is told alone", "[csg][many][isosurface]")
{
    if (!runs_here()) return;
    int ends = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(share(400)); ++seed) {
        Rng rng(seed + 3000);
        IsosurfaceTerms terms;
        terms.field = std::make_shared<Waves>();
        terms.threshold = rng.uniform(-0.1, 0.1);
        terms.accuracy = rng.coin() ? 0.001 : 0.02;
        terms.max_gradient = rng.uniform(0.5, 6.0);
        terms.evaluate = rng.coin();
        terms.growth = {1.0, 1.2, 0.95};
        terms.max_trace = 1 + rng.below(4);
        terms.open = rng.coin();
        if (rng.coin()) terms.container = Container::sphere(glm::dvec3(0.1), 1.1);
        ends += check_many(Isosurface(terms), 1.2, seed);
    }
    CHECK(ends > share(400) * 10);
}

TEST_CASE("many rays of a blob are told what each is told alone", "[csg][many][blob]")
{
    if (!runs_here()) return;
    int ends = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(share(2000)); ++seed) {
        Rng rng(seed + 5000);
        // A few go one by one, more through a hierarchy; of very many there is no room for all that are near.
        const int most[] = {11, 11, 60, 160};
        const int kind = seed % 50 == 0 ? 3 : rng.below(3);
        std::vector<Blob::Component> components(static_cast<std::size_t>(2 + rng.below(most[kind])));
        for (Blob::Component& component : components) {
            if (rng.coin()) component.length = rng.uniform(0.0, 1.5);
            component.radius = kind == 2 ? rng.uniform(0.1, 0.5) : rng.uniform(0.3, 1.2);
            component.strength = rng.below(4) == 0 ? rng.uniform(-1.5, 0.0) : rng.uniform(0.0, 2.0);
            component.frame = Transform::translate(rng.point(0.8)) * Transform::rotate_degrees(rng.point(180.0));
            if (rng.below(3) == 0) component.frame = component.frame * Transform::scale(glm::dvec3(1.0, 0.6, 1.3));
        }
        components.front().strength = 2.0;
        const double threshold = rng.below(8) == 0 ? -rng.uniform(0.0, 0.5) : rng.uniform(0.05, 0.9);
        ends += check_many(Blob(threshold, components), 1.5, seed);
    }
    CHECK(ends > share(2000) * 10);
}

TEST_CASE("many rays of a height field are told what each is told alone", "[csg][many][height_field]")
{
    if (!runs_here()) return;
    int ends = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(share(600)); ++seed) {
        Rng rng(seed + 7000);
        HeightField::Grid grid;
        const int most = seed % 10 == 0 ? 200 : 24;  // of some there are blocks of blocks
        grid.columns = static_cast<std::uint32_t>(2 + rng.below(most));
        grid.rows = static_cast<std::uint32_t>(2 + rng.below(most));
        const bool steps = rng.coin();
        double level = 30000.0;
        for (std::uint32_t n = 0; n < grid.columns * grid.rows; ++n) {
            level = std::clamp(level + rng.uniform(-6000.0, 6000.0), 0.0, 65535.0);
            grid.levels.push_back(static_cast<std::uint16_t>(steps ? 20000 * rng.below(3) : level));
        }
        if (rng.coin()) grid.water = rng.uniform(0.0, 70000.0);
        ends += check_many(HeightField(grid), 1.2, seed);
    }
    CHECK(ends > share(600) * 10);
}

TEST_CASE("powers of one number are those of lanes, and near the library's", "[csg][lanes]")
{
    if (!runs_here()) return;
    Rng rng(1);
    double worst = 0.0;
    for (int i = 0; i < 20000; ++i) {
        alignas(64) std::array<double, static_cast<std::size_t>(csg::lanes::kDoubles)> c, n, lane;
        for (std::size_t k = 0; k < c.size(); ++k) {
            c[k] = rng.coin() ? rng.uniform(0.0, 2.0) : std::exp(rng.uniform(-600.0, 0.0));
            if (c[k] == 0.0) c[k] = 1.0;
            n[k] = rng.coin() ? rng.uniform(0.0, 1.0) : rng.uniform(0.0, 50.0);
        }
        csg::lanes::power(csg::lanes::Double::load_aligned(c.data()), csg::lanes::Double::load_aligned(n.data()))
            .store_aligned(lane.data());
        for (std::size_t k = 0; k < c.size(); ++k) {
            INFO(c[k] << " ^ " << n[k]);
            REQUIRE(same_number(lane[k], csg::lanes::power(c[k], n[k])));
            const double right = std::pow(c[k], n[k]);
            if (right < 1e-300) continue;
            // The exponent's last digit counts as often as the exponent is large.
            worst = std::max(worst, std::abs(lane[k] - right) / right / (1.0 + std::abs(n[k] * std::log(c[k]))));
        }
    }
    CHECK(worst < 6e-16);
    CHECK(csg::lanes::power(1.0, 3.7) == 1.0);
    CHECK(csg::lanes::power(0.5, 2.0) == 0.25);
    CHECK(csg::lanes::power(0.7, 0.0) == 1.0);
}

TEST_CASE("a superellipsoid that is surely met no more on the way off its surface is not met there",
          "[csg][freeform][many]")
{
    if (!runs_here()) return;
    Rng rng(77);
    int off = 0, through = 0, known = 0;
    for (int i = 0; i < share(40000); ++i) {
        const double e = std::pow(10.0, rng.uniform(-1.5, 0.3)), n = std::pow(10.0, rng.uniform(-1.5, 0.3));
        const Superellipsoid shape(e, n);
        const Ray ray = csg_test::ray_near(rng, glm::dvec3(0.0), 1.0, 3.0);
        IntersectionList whole(-kInfinity, kInfinity, false);
        shape.intersect(ray, whole);
        const Told ends(whole);
        if (ends.t.empty()) continue;
        const glm::dvec3 start = ray.at(ends.t[static_cast<std::size_t>(rng.below(2))]);
        for (const Ray& next : {Ray{start, rng.direction()}, Ray{start, ray.direction}}) {
            const double own = 1e-12 * std::pow(10.0, rng.uniform(0.0, 4.0)), usual = 1e-4;
            if (!shape.meets_no_more(next, own, usual)) continue;
            ++known;
            ++(shape.contains(next.at(0.5 * usual)) ? through : off);
            IntersectionList record(own, usual, false);
            shape.intersect(next, record);
            for (const double t : Told(record).t) CHECK((t < own || t > usual));
        }
    }
    CHECK(known > share(40000));
    CHECK(off > share(10000));
    CHECK(through > share(10000));
}
