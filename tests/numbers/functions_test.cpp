#include "numbers/functions/unit_again.h"
#include "tests/numbers/arguments.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <map>
#include <random>

using numbers_test::kInf;
using numbers_test::kNan;

// The C library's functions of 113 bits, by the names that C++ does not know yet.
#ifdef __aarch64__
using Quad = long double;
#else
using Quad = __float128;
#endif
extern "C" {
Quad sinf128(Quad);
Quad cosf128(Quad);
Quad tanf128(Quad);
Quad asinf128(Quad);
Quad acosf128(Quad);
Quad atanf128(Quad);
Quad atan2f128(Quad, Quad);
Quad expf128(Quad);
Quad logf128(Quad);
Quad log2f128(Quad);
Quad log10f128(Quad);
Quad powf128(Quad, Quad);
Quad sinhf128(Quad);
Quad coshf128(Quad);
Quad tanhf128(Quad);
Quad asinhf128(Quad);
Quad acoshf128(Quad);
Quad atanhf128(Quad);
Quad hypotf128(Quad, Quad);
}

namespace {

Quad exact(const std::string& name, Quad x, Quad y)
{
    static const std::map<std::string, Quad (*)(Quad)> of_one = {
        {"sin", sinf128},   {"cos", cosf128},     {"tan", tanf128},     {"asin", asinf128},
        {"acos", acosf128}, {"atan", atanf128},   {"exp", expf128},     {"log", logf128},
        {"log2", log2f128}, {"log10", log10f128}, {"sinh", sinhf128},   {"cosh", coshf128},
        {"tanh", tanhf128}, {"asinh", asinhf128}, {"acosh", acoshf128}, {"atanh", atanhf128}};
    static const std::map<std::string, Quad (*)(Quad, Quad)> of_two = {
        {"atan2", atan2f128}, {"pow", powf128}, {"hypot", hypotf128}};
    return of_one.count(name) != 0 ? of_one.at(name)(x) : of_two.at(name)(x, y);
}

bool same_number(double a, double b) { return (std::isnan(a) && std::isnan(b)) || std::memcmp(&a, &b, sizeof a) == 0; }

/// Of a normal or subnormal value, in units of its last place.
double error_in_ulps(double value, Quad is)
{
    const int exponent = std::max(std::ilogb(static_cast<double>(is)), -1022);
    return std::abs(
        static_cast<double>((static_cast<Quad>(value) - is) / static_cast<Quad>(std::ldexp(1.0, exponent - 52))));
}

}  // namespace

TEST_CASE("functions are within half a unit in the last place and a little", "[numbers]")
{
    for (const auto& f : numbers_test::functions()) {
        numbers_test::Rng rng(1);
        double most = 0.0;
        numbers_test::Arguments worst{};
        for (int i = 0; i < 20'000; ++i) {
            const auto [x, y] = f.argument(rng);
            const Quad is = exact(f.name, x, y);
            const double value = f.value(x, y), rounded = static_cast<double>(is);
            if (!std::isfinite(rounded) || std::abs(rounded) < 5e-324) {
                INFO(f.name << "(" << x << ", " << y << ") = " << value << " and is " << rounded);
                REQUIRE(std::abs(value) == std::abs(rounded));
                continue;
            }
            const double error = error_in_ulps(value, is);
            if (!(error <= most)) {
                most = error;
                worst = {x, y};
            }
        }
        UNSCOPED_INFO(f.name << " " << most);
        INFO(f.name << "(" << std::hexfloat << worst.x << ", " << worst.y << ")" << std::defaultfloat);
        CHECK(most < f.most_ulps);
    }
}

TEST_CASE("functions of what IEEE 754 treats apart are the C library's", "[numbers]")
{
    const std::map<std::string, double (*)(double, double)> library = {
        {"sin", [](double x, double) { return std::sin(x); }},
        {"cos", [](double x, double) { return std::cos(x); }},
        {"tan", [](double x, double) { return std::tan(x); }},
        {"asin", [](double x, double) { return std::asin(x); }},
        {"acos", [](double x, double) { return std::acos(x); }},
        {"atan", [](double x, double) { return std::atan(x); }},
        {"exp", [](double x, double) { return std::exp(x); }},
        {"log", [](double x, double) { return std::log(x); }},
        {"log2", [](double x, double) { return std::log2(x); }},
        {"log10", [](double x, double) { return std::log10(x); }},
        {"sinh", [](double x, double) { return std::sinh(x); }},
        {"cosh", [](double x, double) { return std::cosh(x); }},
        {"tanh", [](double x, double) { return std::tanh(x); }},
        {"asinh", [](double x, double) { return std::asinh(x); }},
        {"acosh", [](double x, double) { return std::acosh(x); }},
        {"atanh", [](double x, double) { return std::atanh(x); }},
        {"atan2", [](double x, double y) { return std::atan2(x, y); }},
        {"pow", [](double x, double y) { return std::pow(x, y); }},
        {"hypot", [](double x, double y) { return std::hypot(x, y); }}};
    const auto& numbers = numbers_test::special_numbers();
    for (const auto& f : numbers_test::functions())
        for (const double x : numbers)
            for (const double y : f.of_two ? numbers : std::vector<double>{0.0}) {
                const double value = f.value(x, y), other = library.at(f.name)(x, y);
                INFO(f.name << "(" << x << ", " << y << ") = " << value << " where the library has " << other);
                if (!std::isfinite(other) || other == 0.0) REQUIRE(same_number(value, other));
                else REQUIRE(std::abs(value - other) <= std::max(std::abs(other) * 0x1p-48, 5e-324));
            }
}

TEST_CASE("powers and roots that a double holds are exact", "[numbers]")
{
    for (int k = -1074; k < 1024; ++k) {
        CHECK(numbers::log2(std::ldexp(1.0, k)) == k);
        CHECK(numbers::pow(2.0, k) == std::ldexp(1.0, k));
    }
    for (int k = 0; k < 23; ++k) CHECK(numbers::log10(numbers::pow(10.0, k)) == k);
    for (int x = 1; x < 200; ++x) {
        CHECK(numbers::pow(x, 2.0) == static_cast<double>(x) * x);
        CHECK(numbers::pow(-x, 3.0) == -static_cast<double>(x) * x * x);
        CHECK(numbers::pow(x, 0.5) == std::sqrt(static_cast<double>(x)));
        CHECK(numbers::pow(x, 1.0) == x);
        CHECK(numbers::hypot(3.0 * x, 4.0 * x) == 5.0 * x);
    }
    CHECK(numbers::exp(0.0) == 1.0);
    CHECK(numbers::cos(0.0) == 1.0);
    CHECK(numbers::tan(std::numbers::pi / 4) < 1.0);
}

TEST_CASE("what is of unit length is made so again to the last bit, and what is not as well", "[numbers]")
{
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> along(-1.0, 1.0);
    int changed = 0;
    const auto agree = [&](const glm::dvec3& v) {
        const glm::dvec3 again = numbers::unit_again(v), from_root = glm::normalize(v);
        REQUIRE((again == from_root || v == glm::dvec3(0)));
        changed += again != v ? 1 : 0;
    };
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 v(along(random), along(random), along(random)), unit = glm::normalize(v);
        agree(v);
        agree(unit);
        for (const double off : {-0x1p-50, -0x1p-52, -0x1p-53, 0x1p-52, 0x1p-51, 0x1p-49}) agree(unit * (1.0 + off));
    }
    CHECK(changed > 40000);  // also of those whose root is looked up
    for (const double size : {0.0, 1e-200, 1e200}) agree(glm::dvec3(size, -size, size));
}
