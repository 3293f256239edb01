#include "csg/freeform/shared/bernstein.h"
#include "csg/solids/shared/polynomial_between.h"
#include "csg/solids/shared/polynomial_rays.h"
#include "numbers/polynomial_roots.h"
#include "numbers/safeguarded_newton.h"
#include "tests/csg/degrees.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace csg;
using csg_test::Rng;

namespace {

/// Factors multiplied out in long double.
class Product {
public:
    explicit Product(double leading = 1.0) : c_{leading} {}
    void linear(double root) { multiply({-static_cast<long double>(root), 1.0L}); }
    /// (t - x)^2 + y^2
    void pair(double x, double y)
    {
        const long double a = x, b = y;
        multiply({a * a + b * b, -2.0L * a, 1.0L});
    }
    PolynomialShape::Along rounded() const
    {
        PolynomialShape::Along c{};
        for (std::size_t i = 0; i < c_.size(); ++i) c[i] = static_cast<double>(c_[i]);
        return c;
    }

private:
    void multiply(const std::vector<long double>& factor)
    {
        std::vector<long double> out(c_.size() + factor.size() - 1, 0.0L);
        for (std::size_t i = 0; i < c_.size(); ++i)
            for (std::size_t j = 0; j < factor.size(); ++j) out[i + j] += c_[i] * factor[j];
        c_ = out;
    }
    std::vector<long double> c_;
};

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
    Product product(std::pow(10.0, rng.uniform(-5, 5)) * (rng.coin() ? 1 : -1));
    for (int i = 0; i < real; ++i) {
        // A tenth apart at least: closer ones are another question.
        made.roots.push_back(middle + made.scale * (i * 0.3 + rng.uniform(0.0, 0.2)));
        product.linear(made.roots.back());
    }
    for (int left = degree - real; left > 0; left -= 2) {
        const double x = middle + made.scale * rng.uniform(-1, 1);
        product.pair(x, made.scale * rng.uniform(0.05, 1));
    }
    made.c = product.rounded();
    return made;
}

}  // namespace

TEST_CASE("sign changes are the roots that were multiplied out", "[csg][polynomial]")
{
    csg_test::each_degree(1, 8, 4000, [](int degree, Rng& rng) {
        const Known known = known_roots(rng, degree);
        double found[PolynomialShape::kMostDegree];
        const int count = sign_changes(known.c, degree, found);
        REQUIRE(count == static_cast<int>(known.roots.size()));
        // What rounding the coefficients does to a root: 1e-16 (middle / apart)^degree.
        const double slack = degree <= 4 ? 1e-9 : 1e-5;
        for (int i = 0; i < count; ++i)
            REQUIRE(std::abs(found[i] - known.roots[static_cast<std::size_t>(i)]) < slack * known.scale);
    });
}

TEST_CASE("sign changes in a range that holds them all are those that turning points tell", "[csg][polynomial]")
{
    int unsure = 0, sure = 0, none = 0;
    csg_test::each_degree(5, 15, 2000, [&](int degree, Rng& rng) {
        const Known known = known_roots(rng, degree);
        double wanted[PolynomialShape::kMostDegree], found[PolynomialShape::kMostDegree];
        const int all = sign_changes(known.c, degree, wanted);
        double lo = -csg::detail::root_bound(known.c.data(), degree), hi = -lo;
        if (rng.coin()) {
            const double middle = all == 0 ? known.scale * rng.uniform(-5, 5) : 0.0;
            lo = (all == 0 ? middle : wanted[0]) - known.scale * rng.uniform(0.01, 2.0);
            hi = (all == 0 ? middle : wanted[all - 1]) + known.scale * rng.uniform(0.01, 2.0);
        }
        const int count = sign_changes_between(known.c, degree, lo, hi, kInfinity, found);
        if (count == kUnsureChanges) {
            ++unsure;
            return;
        }
        ++sure;
        none += all == 0 ? 1 : 0;
        REQUIRE(count == all);
        for (int i = 0; i < count; ++i) {
            // As near to 0 as rounding lets it be known; how far that is along t is another question.
            double value = 0.0, size = 0.0;
            for (int k = degree; k >= 0; --k) {
                value = value * found[i] + known.c[static_cast<std::size_t>(k)];
                size = size * std::abs(found[i]) + std::abs(known.c[static_cast<std::size_t>(k)]);
            }
            REQUIRE(std::abs(value) <= 4 * degree * 0x1p-53 * size);
            REQUIRE(std::abs(found[i] - wanted[i]) < 0.05 * known.scale);
        }
    });
    INFO("unsure " << unsure << ", sure " << sure << ", without roots " << none);
    CHECK(sure > 8'000);  // of 22,000: high degrees so far from 0 lose most of their digits
    CHECK(none > 1'000);
}

TEST_CASE("sign changes in any range are those of the whole line that lie in it, or the first of them",
          "[csg][polynomial]")
{
    int sure = 0, found_some = 0, stopped = 0;
    csg_test::each_degree(5, 15, 1000, [&](int degree, Rng& rng) {
        const Known known = known_roots(rng, degree);
        double all[PolynomialShape::kMostDegree], found[PolynomialShape::kMostDegree];
        const int of_all = sign_changes(known.c, degree, all);
        const double lo = known.scale * rng.uniform(-3, 3), hi = lo + known.scale * rng.uniform(0.1, 4.0);
        const double enough = rng.coin() ? kInfinity : lo + (hi - lo) * rng.uniform(0.0, 0.5);
        const double near = 1e-6 * known.scale;  // to an end: which side of it is another question
        for (const double root : known.roots)
            for (const double end : {lo, hi, enough})
                if (std::abs(root - end) < near) return;
        const int count = sign_changes_between(known.c, degree, lo, hi, enough, found);
        if (count == kUnsureChanges) return;
        ++sure;
        int next = 0;
        for (int i = 0; i < of_all; ++i) {
            if (all[i] < lo || all[i] > hi) continue;
            if (next == count && next > 0 && found[next - 1] > enough) {
                ++stopped;
                break;
            }
            REQUIRE(next < count);
            REQUIRE(std::abs(found[next] - all[i]) < 0.05 * known.scale);
            ++next;
        }
        REQUIRE(next == count);
        found_some += count > 0 ? 1 : 0;
    });
    INFO("sure " << sure << ", with some " << found_some << ", stopped " << stopped);
    CHECK(sure > 4'000);
    CHECK(found_some > 1'000);
    CHECK(stopped > 100);
}

TEST_CASE("ordinates of a ray a lane are to the last bit those of one ray", "[csg][polynomial]")
{
    csg_test::each_degree(5, 15, 200, [&](int degree, Rng& rng) {
        const auto n = static_cast<std::size_t>(degree);
        PolynomialShape::Along c{};
        for (std::size_t k = 0; k <= n; ++k) c[k] = rng.coin() ? rng.uniform(-1.0, 1.0) : 0.0;
        const double lo = rng.uniform(-3, 3), hi = lo + rng.uniform(0.1, 4.0);
        PolynomialRow<2> row, row_low;
        PolynomialRays<double> rays, rays_low;
        const double error = csg::detail::ordinates_between(c.data(), n, lo, hi, row);
        REQUIRE(csg::detail::ordinates_between(c.data(), n, lo, hi, rays) == error);
        row.halve(n, row_low);
        rays.halve(n, rays_low);
        double upper[16], lower[16];
        row.store(upper, 16);
        row_low.store(lower, 16);
        for (std::size_t k = 0; k <= n; ++k) {
            REQUIRE(rays.v[k] == upper[k]);
            REQUIRE(rays_low.v[k] == lower[k]);
        }
    });
}

TEST_CASE("two roots that are nearly one are left to turning points", "[csg][polynomial]")
{
    for (std::uint32_t seed = 0; seed < 500; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        // (t - x)^2 times what has no real root.
        Product product;
        const double x = rng.uniform(-0.9, 0.9);
        product.pair(x, rng.coin() ? 0.0 : 1e-9);
        for (int i = rng.below(4) + 2; i > 0; --i) product.pair(rng.uniform(-1.0, 1.0), rng.uniform(0.5, 1.0));
        const PolynomialShape::Along c = product.rounded();
        int degree = PolynomialShape::kMostDegree;
        while (c[static_cast<std::size_t>(degree)] == 0.0) --degree;
        double found[PolynomialShape::kMostDegree];
        REQUIRE(sign_changes_between(c, degree, -1.0, 1.0, kInfinity, found) == kUnsureChanges);
    }
}

TEST_CASE("roots of sizes from 1e-6 to 1e12 are found together, up to degree 35", "[csg][polynomial]")
{
    csg_test::each_degree(5, PolynomialShape::kMostDegree, 200, [](int degree, Rng& rng) {
        // A few real ones far apart, the rest a crowd of complex ones of the size of 1.
        std::vector<double> roots;
        const int least = degree % 2 == 0 ? 2 : 1;
        for (int left = least + 2 * rng.below(2); left > 0; --left) {
            const double size = std::pow(10.0, rng.uniform(-6, 12));
            if (std::any_of(roots.begin(), roots.end(),
                            [&](double r) { return size > 0.3 * std::abs(r) && size < 3.0 * std::abs(r); }))
                ++left;
            else roots.push_back(rng.coin() ? size : -size);
        }
        std::sort(roots.begin(), roots.end());
        Product product;
        for (const double r : roots) product.linear(r);
        for (int left = degree - static_cast<int>(roots.size()); left > 0; left -= 2)
            product.pair(rng.uniform(-0.5, 0.5), rng.uniform(0.5, 2.0));
        double found[PolynomialShape::kMostDegree];
        const int count = sign_changes(product.rounded(), degree, found);
        REQUIRE(count == static_cast<int>(roots.size()));
        for (int i = 0; i < count; ++i) REQUIRE(found[i] == Approx(roots[static_cast<std::size_t>(i)]).epsilon(1e-9));
    });
}

TEST_CASE("cubics and quartics by formula are rarely unsure and never wrong", "[csg][polynomial]")
{
    int unsure = 0;
    csg_test::each_degree(3, 4, 20000, [&](int degree, Rng& rng) {
        PolynomialShape::Along c{};
        for (int i = 0; i <= degree; ++i) c[static_cast<std::size_t>(i)] = rng.uniform(-1, 1);
        double found[PolynomialShape::kMostDegree];
        const int count = degree == 4 ? csg::detail::quartic_roots(c.data(), found)
                                      : csg::detail::cubic_roots(c.data(), found);
        if (count == csg::detail::kUnsure) {
            ++unsure;
            return;
        }
        // Signs where nothing but the number of roots below decides.
        const auto value = [&](double t) {
            long double v = 0;
            for (int i = degree; i >= 0; --i)
                v = v * static_cast<long double>(t) + static_cast<long double>(c[static_cast<std::size_t>(i)]);
            return v;
        };
        bool positive = (degree % 2 == 0) == (c[static_cast<std::size_t>(degree)] > 0.0);
        double before = -1e6;
        for (int i = 0; i <= count; ++i) {
            const double after = i < count ? found[i] : 1e6;
            CHECK((value(0.5 * (before + after)) > 0) == positive);
            if (i < count)
                CHECK(std::abs(value(after)) <
                      1e-10L * (1 + std::pow(std::abs(static_cast<long double>(after)), degree)));
            positive = !positive;
            before = after;
        }
    });
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

TEST_CASE("a Newton step too short to move its place ends the search of a polynomial", "[csg][polynomial]")
{
    // A quartic as blobs have, by its ordinates; bisection from the far end of the bracket took 54 looks.
    const std::array<double, 5> b = {0x1.e41ec3d70a3d7p-11, 0x1.44e1019cccccdp-6, 0x1.312b31e666667p-7,
                                     0x1.3dc6c7499999ap-6, -0x1.1b1556299999ap-6};
    const std::array<double, 5> c = csg::detail::quartic_powers(b);
    int looks = 0;
    const auto at = [&](double t) {
        ++looks;
        ValueAndSlope here{};
        csg::detail::evaluate(c.data(), 4, t, here.value, here.slope);
        return here;
    };
    const double t = safeguarded_newton<true>(at, 0.0, 1.0, false, b[0] / (b[0] - b[4]), {0.0, 1e-15}, 300);
    CHECK(looks <= 12);
    CHECK(at(t - 4e-15).value > 0.0);
    CHECK(at(t + 4e-15).value < 0.0);
}
