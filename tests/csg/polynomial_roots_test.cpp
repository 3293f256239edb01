#include "csg/polynomial_roots.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace csg;
using csg_test::Rng;

namespace {

/// Coefficients of the product of (t - root) and of (t - x)^2 + y^2 for the rest, multiplied out in long double.
struct Known {
    PolynomialShape::Along c{};
    std::vector<double> roots;
    double scale = 1.0;
};

Known known_roots(Rng& rng, int degree)
{
    Known made;
    made.scale = std::pow(10.0, rng.uniform(-4, 4));
    const double middle = rng.coin() ? 0.0 : made.scale * rng.uniform(-5, 5);
    const int real = degree - 2 * rng.below(degree / 2 + 1);
    std::vector<long double> product{std::pow(10.0, rng.uniform(-5, 5)) * (rng.coin() ? 1 : -1)};
    const auto multiply = [&](const std::vector<long double>& factor) {
        std::vector<long double> out(product.size() + factor.size() - 1, 0.0L);
        for (std::size_t i = 0; i < product.size(); ++i)
            for (std::size_t j = 0; j < factor.size(); ++j) out[i + j] += product[i] * factor[j];
        product = out;
    };
    for (int i = 0; i < real; ++i) {
        // A tenth apart at least: closer ones are another question.
        made.roots.push_back(middle + made.scale * (i * 0.3 + rng.uniform(0.0, 0.2)));
        multiply({-static_cast<long double>(made.roots.back()), 1.0L});
    }
    for (int left = degree - real; left > 0; left -= 2) {
        const long double x = middle + made.scale * rng.uniform(-1, 1), y = made.scale * rng.uniform(0.05, 1);
        multiply({x * x + y * y, -2.0L * x, 1.0L});
    }
    for (std::size_t i = 0; i < product.size(); ++i) made.c[i] = static_cast<double>(product[i]);
    return made;
}

}  // namespace

TEST_CASE("sign changes are the roots that were multiplied out", "[csg][polynomial]")
{
    for (int degree = 1; degree <= 8; ++degree)
        for (std::uint32_t seed = 0; seed < 4000; ++seed) {
            INFO("degree " << degree << ", seed " << seed);
            Rng rng(seed);
            const Known known = known_roots(rng, degree);
            double found[PolynomialShape::kMostDegree];
            const int count = sign_changes(known.c, degree, found);
            REQUIRE(count == static_cast<int>(known.roots.size()));
            // What rounding the coefficients does to a root: 1e-16 (middle / apart)^degree.
            const double slack = degree <= 4 ? 1e-9 : 1e-5;
            for (int i = 0; i < count; ++i) REQUIRE(std::abs(found[i] - known.roots[static_cast<std::size_t>(i)]) < slack * known.scale);
        }
}

TEST_CASE("cubics and quartics by formula are rarely unsure and never wrong", "[csg][polynomial]")
{
    int unsure = 0;
    for (const int degree : {3, 4})
        for (std::uint32_t seed = 0; seed < 20000; ++seed) {
            INFO("degree " << degree << ", seed " << seed);
            Rng rng(seed);
            PolynomialShape::Along c{};
            for (int i = 0; i <= degree; ++i) c[static_cast<std::size_t>(i)] = rng.uniform(-1, 1);
            double found[PolynomialShape::kMostDegree];
            const int count = degree == 4 ? detail::quartic_roots(c.data(), found) : detail::cubic_roots(c.data(), found);
            if (count == detail::kUnsure) {
                ++unsure;
                continue;
            }
            // Signs where nothing but the number of roots below decides.
            const auto value = [&](double t) {
                long double v = 0;
                for (int i = degree; i >= 0; --i) v = v * static_cast<long double>(t) + static_cast<long double>(c[static_cast<std::size_t>(i)]);
                return v;
            };
            bool positive = (degree % 2 == 0) == (c[static_cast<std::size_t>(degree)] > 0.0);
            double before = -1e6;
            for (int i = 0; i <= count; ++i) {
                const double after = i < count ? found[i] : 1e6;
                CHECK((value(0.5 * (before + after)) > 0) == positive);
                if (i < count) CHECK(std::abs(value(after)) < 1e-10L * (1 + std::pow(std::abs(static_cast<long double>(after)), degree)));
                positive = !positive;
                before = after;
            }
        }
    CHECK(unsure < 400);
}

TEST_CASE("odd coefficients leave the roots unharmed", "[csg][polynomial]")
{
    const double odd[] = {0.0, -0.0, 1.0, -1.0, 1e-300, 1e300, -1e300, 5e-324, kInfinity, -kInfinity, std::nan("")};
    for (std::uint32_t seed = 0; seed < 20000; ++seed) {
        Rng rng(seed);
        const int degree = 1 + rng.below(6);
        PolynomialShape::Along c{};
        for (int i = 0; i <= degree; ++i) c[static_cast<std::size_t>(i)] = odd[rng.below(11)];
        double found[PolynomialShape::kMostDegree];
        const int count = sign_changes(c, degree, found);
        CHECK(count >= 0);
        CHECK(count <= degree);
    }
}
