#pragma once

#include "numbers/functions/functions.h"

#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace numbers_test {

inline constexpr double kInf = std::numeric_limits<double>::infinity(), kNan = std::numeric_limits<double>::quiet_NaN();

/// Numbers that a seed fixes (splitmix64).
class Rng {
public:
    explicit Rng(std::uint64_t seed) : state_(seed) {}
    std::uint64_t bits()
    {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    double between(double a, double b) { return a + (b - a) * static_cast<double>(bits() >> 11) * 0x1p-53; }
    /// Any sign, sizes from 2^low to 2^high, each power of 2 as often as another.
    double sized(double low, double high)
    {
        const auto exponent = static_cast<int>(std::floor(between(low, high)));
        const double size = std::ldexp(between(1.0, 2.0), exponent);
        return (bits() & 1u) != 0 ? size : -size;
    }

private:
    std::uint64_t state_;
};

struct Arguments {
    double x, y;
};

/// What the functions are made of has its seams here; and what IEEE 754 treats apart.
inline const std::vector<double>& special_numbers()
{
    static const std::vector<double> all = [] {
        std::vector<double> out;
        const double pi = std::numbers::pi;
        for (const double v : {0.0,
                               5e-324,
                               3e-310,
                               0x1p-1022,
                               1e-300,
                               0x1p-400,
                               1e-100,
                               0x1p-54,
                               0x1p-28,
                               0x1p-27,
                               0x1p-26,
                               1e-4,
                               0.18,
                               0.1,
                               0.25,
                               1.0 / 3.0,
                               0.5,
                               11.0 / 16.0,
                               std::sqrt(0.5),
                               0.75,
                               1.0 - 0x1p-53,
                               1.0,
                               1.0 + 0x1p-52,
                               1.125,
                               11.0 / 8.0,
                               1.5,
                               2.0,
                               3.0,
                               10.0,
                               20.0,
                               32.0,
                               64.0,
                               100.0,
                               700.0,
                               707.99,
                               708.0,
                               709.7,
                               709.8,
                               710.5,
                               744.0,
                               745.1,
                               745.2,
                               746.0,
                               1000.0,
                               32767.9,
                               32768.0,
                               1e5,
                               0x1p52,
                               0x1p53 - 1.0,
                               0x1p53,
                               1e22,
                               1e100,
                               0x1p480,
                               0x1p500,
                               1e300,
                               0x1.fffffffffffffp1023,
                               6381956970095103.0 * 0x1p797,
                               pi / 4,
                               pi / 2,
                               pi,
                               2 * pi,
                               3 * pi,
                               11 * pi,
                               1000 * pi,
                               pi / 64,
                               3 * pi / 128,
                               kInf,
                               kNan}) {
            out.push_back(v);
            out.push_back(-v);
        }
        return out;
    }();
    return all;
}

struct Function {
    std::string name;
    std::function<double(double, double)> value;
    std::function<Arguments(Rng&)> argument;  ///< where pictures use it, and far beyond
    double most_ulps;                         ///< an error of half a unit in the last place is none
    bool of_two = false;
};

/// All of one number or two, each with the bound that docs/numerics.md names.
inline const std::vector<Function>& functions()
{
    const auto one = [](double (*f)(double)) { return [f](double x, double) { return f(x); }; };
    const auto two = [](double (*f)(double, double)) { return f; };
    const auto angle = [](Rng& r) -> Arguments {
        switch (r.bits() % 4) {
        case 0: return {r.between(-4.0, 4.0), 0.0};
        case 1: return {r.between(-40000.0, 40000.0), 0.0};
        case 2: return {r.sized(-40, 1023), 0.0};
        default: {  // beside a multiple of a right angle, where all digits cancel
            const double k = std::floor(r.between(-20000.0, 20000.0)) * std::numbers::pi / 2.0;
            return {k + std::floor(r.between(-2.0, 3.0)) * 0x1p-52 * k, 0.0};
        }
        }
    };
    const auto unit = [](Rng& r) -> Arguments {
        const double v = r.bits() % 2 == 0 ? r.between(-1.0, 1.0) : r.sized(-40, 0);
        return {r.bits() % 4 == 0 ? std::copysign(1.0 - std::abs(v), v) : v, 0.0};
    };
    const auto any = [](Rng& r) -> Arguments {
        return {r.bits() % 2 == 0 ? r.between(-3.0, 3.0) : r.sized(-50, 50), 0.0};
    };
    const auto exponent = [](Rng& r) -> Arguments {
        return {r.bits() % 2 == 0 ? r.between(-745.0, 709.0) : r.sized(-40, 9), 0.0};
    };
    const auto positive = [](Rng& r) -> Arguments {
        switch (r.bits() % 3) {
        case 0: return {r.between(0.5, 2.0), 0.0};
        case 1: return {1.0 + r.sized(-50, -3), 0.0};
        default: return {std::abs(r.sized(-1070, 1023)), 0.0};
        }
    };
    const auto sides = [](Rng& r) -> Arguments {
        return r.bits() % 2 == 0 ? Arguments{r.between(-2.0, 2.0), r.between(-2.0, 2.0)}
                                 : Arguments{r.sized(-200, 200), r.sized(-200, 200)};
    };
    const auto power = [](Rng& r) -> Arguments {
        switch (r.bits() % 3) {
        case 0: return {r.between(0.0, 2.0), r.between(-10.0, 200.0)};
        case 1: return {std::abs(r.sized(-60, 60)), r.between(-20.0, 20.0)};
        default: return {1.0 + r.sized(-40, -3), r.sized(-10, 40)};
        }
    };
    static const std::vector<Function> all = {
        {"sin", one(numbers::sin), angle, 0.503},
        {"cos", one(numbers::cos), angle, 0.503},
        {"tan", one(numbers::tan), angle, 0.51},
        {"asin", one(numbers::asin), unit, 0.51},
        {"acos", one(numbers::acos), unit, 0.51},
        {"atan", one(numbers::atan), any, 0.51},
        {"atan2", two(numbers::atan2), sides, 0.51, true},
        {"exp", one(numbers::exp), exponent, 0.51},
        {"log", one(numbers::log), positive, 0.505},
        {"log2", one(numbers::log2), positive, 0.501},
        {"log10", one(numbers::log10), positive, 0.501},
        {"pow", two(numbers::pow), power, 0.52, true},
        {"sinh", one(numbers::sinh), exponent, 0.52},
        {"cosh", one(numbers::cosh), exponent, 0.52},
        {"tanh", one(numbers::tanh), exponent, 0.52},
        {"asinh", one(numbers::asinh), any, 0.51},
        {"acosh", one(numbers::acosh),
         [](Rng& r) -> Arguments {
             return {1.0 + std::abs(r.sized(-50, 50)), 0.0};
         },
         0.51},
        {"atanh", one(numbers::atanh), unit, 0.51},
        {"hypot", two(numbers::hypot), sides, 0.501, true},
    };
    return all;
}

}  // namespace numbers_test
