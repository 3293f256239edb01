#include "numbers/remainder.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <random>

/// With fused products, where the build has them, and without.
TEST_CASE("remainders have the bits of fmod()", "[function]")
{
#if defined(__FMA__)
    if (!__builtin_cpu_supports("fma")) return;  // the build for wider vectors needs them
#endif
    std::mt19937_64 random(5);
    const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const auto check = [](double a, double b) {
        const double wanted = std::fmod(a, b), got = numbers::fmod(a, b);
        if (std::memcmp(&wanted, &got, sizeof got) == 0 || (wanted != wanted && got != got)) return;
        FAIL(a << " % " << b << ": " << got << ", " << wanted);
    };
    for (int i = 0; i < 300000; ++i) {
        double b = std::ldexp(0.5 + 0.5 * unit(), static_cast<int>(random() % 40) - 20);
        if (random() % 2 == 0) b = -b;
        const double whole = b * static_cast<double>(random() % 100000);
        check(whole, b);
        check(std::nextafter(whole, 1e300), b);
        check(std::nextafter(whole, -1e300), b);
        check((unit() - 0.5) * std::ldexp(1.0, static_cast<int>(random() % 140) - 70), b);
    }
    const double odd[] = {0.0, -0.0, 1.0, -1.0, 5e-324, -3e-310, 1e-308, 1e300, 1.7e308, INFINITY, -INFINITY, NAN, 0.1};
    for (const double a : odd)
        for (const double b : odd) check(a, b);
    CHECK(numbers::fmod(-1.0, 0.3) == std::fmod(-1.0, 0.3));
}
