#include "function/spline.h"

#include <catch2/catch.hpp>

#include <initializer_list>

namespace {

using Kind = function::Spline::Kind;

function::Spline spline(Kind kind, std::initializer_list<std::pair<double, function::Spline::Values>> points)
{
    function::Spline made;
    made.kind = kind;
    for (const auto& [t, value] : points) made.add(t, value, 3);
    return made;
}

void check(const function::Spline& s, double t, double x, double y, double z)
{
    const auto v = s.at(t);
    INFO("at " << t << ": " << v[0] << ", " << v[1] << ", " << v[2]);
    CHECK(v[0] == Approx(x).margin(6e-6));
    CHECK(v[1] == Approx(y).margin(6e-6));
    CHECK(v[2] == Approx(z).margin(6e-6));
}

}  // namespace

TEST_CASE("splines have the values that POV-Ray prints", "[function]")
{
    const auto three = [](Kind kind) { return spline(kind, {{0, {0, 0, 0}}, {1, {1, 2, 3}}, {3, {5, 0, 0}}}); };
    check(three(Kind::Linear), 0.5, 0.5, 1, 1.5);
    check(three(Kind::Linear), 2, 3, 1, 1.5);
    check(three(Kind::Linear), 4, 5, 0, 0);
    check(three(Kind::Quadratic), 0.5, 0.41667, 1.25, 1.875);
    check(three(Kind::Quadratic), 2, 2.66667, 2, 3);
    check(three(Kind::Cubic), 2.5, 1, 2, 3);
    const auto natural = spline(Kind::Natural, {{0, {0, 0, 0}}, {1, {1, 2, 3}}, {3, {5, 0, 0}}, {4, {1, 1, 1}}});
    check(natural, 0.5, 0.28906, 1.25781, 1.875);
    check(natural, 2, 3.9375, 1.1875, 1.875);
    check(natural, 3.5, 3.44531, 0.28906, 0.21875);
    const auto cubic =
        spline(Kind::Cubic, {{0, {0, 0, 0}}, {1, {1, 2, 3}}, {3, {5, 0, 0}}, {4, {1, 1, 1}}, {6, {2, 2, 2}}});
    check(cubic, 0.5, 1, 2, 3);
    check(cubic, 2, 3.625, 1.125, 1.75);
    check(cubic, 3.5, 3.09375, 0.40625, 0.375);
    check(cubic, 5, 1, 1, 1);
    check(spline(Kind::Cubic, {{0, {0, 0, 0}}, {1, {1, 2, 3}}}), 7, 0.5, 1, 1.5);
}

TEST_CASE("a knot is replaced unless it is the last of several", "[function]")
{
    check(spline(Kind::Linear, {{1, {8, 0, 0}}, {1, {2, 4, 6}}, {2, {4, 4, 6}}}), 1.5, 3, 4, 6);
    check(spline(Kind::Linear, {{1, {8, 0, 0}}, {1, {3, 3, 3}}, {1, {2, 4, 6}}, {0, {0, 0, 0}}}), 1, 2, 4, 6);
    check(spline(Kind::Linear, {{0, {0, 0, 0}}, {1, {1, 1, 1}}, {1, {5, 5, 5}}}), 1, 1, 1, 1);
    check(spline(Kind::Linear, {{0, {0, 0, 0}}, {1, {1, 1, 1}}, {2, {2, 2, 2}}, {1, {5, 5, 5}}}), 1, 5, 5, 5);
    CHECK(function::Spline{}.components() == 2);
}

TEST_CASE("the natural spline is smooth to the second derivative", "[function]")
{
    const auto s = spline(Kind::Natural, {{0, {0, 1, 2}}, {1, {3, -1, 4}}, {2.5, {-2, 0, 1}}, {4, {0, 5, 0}}});
    const double h = 1e-4;
    for (const double knot : {1.0, 2.5})
        for (std::size_t k = 0; k < 3; ++k) {
            const auto bend = [&](double t) { return (s.at(t - h)[k] - 2 * s.at(t)[k] + s.at(t + h)[k]) / (h * h); };
            CHECK(bend(knot - 2 * h) == Approx(bend(knot + 2 * h)).margin(0.01));
        }
}
