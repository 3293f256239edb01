#include "numbers/functions/lane_functions.h"
#include "tests/numbers/arguments.h"

#include <catch2/catch.hpp>

#include <cstring>

using numbers::lanes::Double;
using numbers::lanes::kDoubles;

namespace {

/// Whether the instructions that this file is compiled for are there.
bool machine_has_them()
{
#if defined(__AVX512F__)
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0;
#elif defined(__AVX2__)
    return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#else
    return true;
#endif
}

struct LaneFunction {
    std::string name;
    std::function<Double(const Double&, const Double&)> value;
};

std::vector<LaneFunction> lane_functions()
{
#define FUNCTION_OF_ONE(name)                                                                                          \
    {                                                                                                                  \
#name, [](const Double& x, const Double&) { return numbers::name(x); }                                         \
    }
#define OF_TWO(name)                                                                                                   \
    {                                                                                                                  \
#name, [](const Double& x, const Double& y) { return numbers::name(x, y); }                                    \
    }
#define OF_BOTH(name, both, part)                                                                                      \
    {                                                                                                                  \
#name, [](const Double& x, const Double&) { return numbers::both(x).part; }                                    \
    }
    return {FUNCTION_OF_ONE(sin),
            FUNCTION_OF_ONE(cos),
            FUNCTION_OF_ONE(tan),
            FUNCTION_OF_ONE(asin),
            FUNCTION_OF_ONE(acos),
            FUNCTION_OF_ONE(atan),
            OF_TWO(atan2),
            FUNCTION_OF_ONE(exp),
            FUNCTION_OF_ONE(log),
            FUNCTION_OF_ONE(log10),
            OF_TWO(pow),
            FUNCTION_OF_ONE(sinh),
            FUNCTION_OF_ONE(cosh),
            FUNCTION_OF_ONE(tanh),
            FUNCTION_OF_ONE(asinh),
            FUNCTION_OF_ONE(acosh),
            FUNCTION_OF_ONE(atanh),
            OF_TWO(hypot),
            OF_BOTH(sin, sine_and_cosine, sine),
            OF_BOTH(cos, sine_and_cosine, cosine),
            OF_BOTH(sinh, hyperbolic, sine),
            OF_BOTH(cosh, hyperbolic, cosine)};
}

std::uint64_t bits_of(double v) { return std::isnan(v) ? ~std::uint64_t{0} : std::bit_cast<std::uint64_t>(v); }

}  // namespace

TEST_CASE("a function in lanes has the bits of one number", "[numbers]")
{
    if (!machine_has_them()) return;
    constexpr auto kWidth = static_cast<std::size_t>(kDoubles);
    for (const auto& lanes : lane_functions())
        for (const auto& f : numbers_test::functions()) {
            if (f.name != lanes.name) continue;
            numbers_test::Rng rng(7);
            const auto& special = numbers_test::special_numbers();
            for (int i = 0; i < 40'000 / kDoubles; ++i) {
                alignas(64) double x[kWidth], y[kWidth], out[kWidth];
                for (std::size_t k = 0; k < kWidth; ++k) {
                    const auto [a, b] = f.argument(rng);
                    x[k] = rng.bits() % 16 == 0 ? special[rng.bits() % special.size()] : a;
                    y[k] = rng.bits() % 16 == 0 ? special[rng.bits() % special.size()] : b;
                }
                lanes.value(Double::load_aligned(x), Double::load_aligned(y)).store_aligned(out);
                for (std::size_t k = 0; k < kWidth; ++k) {
                    if (bits_of(out[k]) == bits_of(f.value(x[k], y[k]))) continue;
                    FAIL(f.name << "(" << x[k] << ", " << y[k] << ")");
                }
            }
        }
}

TEST_CASE("functions have the same bits on every machine", "[numbers]")
{
    if (!machine_has_them()) return;
    std::uint64_t digest = 0;
    for (const auto& f : numbers_test::functions()) {
        numbers_test::Rng rng(3);
        const auto add = [&](double x, double y) {
            digest = (std::rotl(digest, 5) ^ bits_of(f.value(x, y))) * 0x9e3779b97f4a7c15u;
        };
        for (int i = 0; i < 50'000; ++i) {
            const auto [x, y] = f.argument(rng);
            add(x, y);
        }
        for (const double x : numbers_test::special_numbers())
            for (const double y : numbers_test::special_numbers()) add(x, y);
    }
    // Another one after a change to the functions on purpose, which changes pictures too.
    CHECK(digest == 0x1ae509b6088c7c3au);
}

TEST_CASE("two functions together have the bits that each has alone", "[numbers]")
{
    numbers_test::Rng rng(8);
    const auto check = [](double x) {
        INFO(x);
        const auto turn = numbers::sine_and_cosine(x), growth = numbers::hyperbolic(x);
        REQUIRE(bits_of(turn.sine) == bits_of(numbers::sin(x)));
        REQUIRE(bits_of(turn.cosine) == bits_of(numbers::cos(x)));
        REQUIRE(bits_of(growth.sine) == bits_of(numbers::sinh(x)));
        REQUIRE(bits_of(growth.cosine) == bits_of(numbers::cosh(x)));
    };
    for (const double x : numbers_test::special_numbers()) check(x);
    for (const auto& f : numbers_test::functions())
        if (f.name == "sin" || f.name == "sinh")
            for (int i = 0; i < 20'000; ++i) check(f.argument(rng).x);
}
