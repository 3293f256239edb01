#pragma once

#include "numbers/functions/pair.h"

/// Values at evenly spread points in twice the precision, worked out by the compiler.
namespace numbers {

inline constexpr Pair<double> kHalfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};
inline constexpr Pair<double> kLn2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

/// x to the power of 2 k + 1, divided by what `divisor` makes of k and the divisor before, for k = 0, 1, ..., `terms`.
template <class Divisor>
constexpr Pair<double> odd_series(const Pair<double>& x, double sign, int terms, Divisor&& divisor)
{
    const Pair<double> square = x * x * Pair<double>{sign, 0.0};
    Pair<double> power = x, sum = x;
    for (int k = 1; k <= terms; ++k) {
        const auto [factorial, term] = divisor(k);
        power = power * square / Pair<double>{factorial, 0.0};
        sum = sum + power / Pair<double>{term, 0.0};
    }
    return sum;
}
struct Divisors {
    double of_power, of_term;
};
constexpr Divisors of_factorials(int k) { return {2.0 * k * (2.0 * k + 1.0), 1.0}; }
constexpr Divisors of_odd_numbers(int k) { return {1.0, 2.0 * k + 1.0}; }

inline constexpr int kSineSteps = 64;  // of pi

/// Row k: the sine of k pi / 64 and what it lacks, then the cosine's first 26 bits and what they lack.
constexpr Table<2 * kSineSteps, 4> sine_table()
{
    constexpr std::size_t kQuarter = kSineSteps / 2;
    std::array<Pair<double>, kQuarter + 1> sines{};
    for (std::size_t k = 1; k < kQuarter; ++k)
        sines[k] = odd_series(kHalfPi * Pair<double>{static_cast<double>(k) / kQuarter, 0.0}, -1.0, 15, of_factorials);
    sines[kQuarter] = {1.0, 0.0};
    const auto sine = [&](std::size_t k) {
        const std::size_t within = k % kSineSteps;
        const Pair<double> v = sines[within <= kQuarter ? within : kSineSteps - within];
        return k % (2 * kSineSteps) < kSineSteps ? v : Pair<double>{-v.high, -v.low};
    };
    Table<2 * kSineSteps, 4> out{};
    for (std::size_t k = 0; k < out.size(); ++k) {
        const Pair<double> s = sine(k), c = sine(k + kQuarter);
        const double first = std::bit_cast<double>(std::bit_cast<std::uint64_t>(c.high) & ~std::uint64_t{0x7ffffff});
        out[k] = {s.high, s.low, first, (c.high - first) + c.low};
    }
    return out;
}
inline constexpr auto kSines = sine_table();

inline constexpr int kPowerSteps = 128;  // of a power of 2

/// Row k: 2^(k / 128) and what it lacks.
constexpr Table<kPowerSteps, 2> power_table()
{
    const Pair<double> x = kLn2 * Pair<double>{1.0 / kPowerSteps, 0.0};
    Pair<double> step{1.0, 0.0}, power = step;
    for (int k = 1; k <= 14; ++k) {
        power = power * x / Pair<double>{static_cast<double>(k), 0.0};
        step = step + power;
    }
    Table<kPowerSteps, 2> out{};
    Pair<double> v{1.0, 0.0};
    for (auto& row : out) {
        row = {v.high, v.low};
        v = v * step;
    }
    return out;
}
inline constexpr auto kPowers = power_table();

inline constexpr std::uint64_t kLeastMantissa = 0x3fe6000000000000u;  // mantissas are those from 11/16 to 11/8
inline constexpr int kMantissaBits = 45;                              // below those that name one of 128 ranges

/// Row k: about 1 / m of the mantissas of range k, in 12 bits, minus its logarithm in whole 2^-42, and what that lacks.
/// Where m is about 1 it is 1, so that nothing cancels.
constexpr Table<128, 4> logarithm_table()
{
    constexpr double kWhole = 1536.0;  // what is added to it loses what is below 2^-42
    Table<128, 4> out{};
    for (std::size_t k = 0; k < out.size(); ++k) {
        const auto start = [&](std::size_t range) {
            return std::bit_cast<double>(kLeastMantissa + (std::uint64_t{range} << kMantissaBits));
        };
        const double low = start(k), high = start(k + 1), wanted = 2.0 * 2048.0 / (low + high);
        const double inverse = low == 1.0 || high == 1.0 ? 1.0
                                                         : static_cast<double>(static_cast<int>(wanted + 0.5)) / 2048.0;
        const Pair<double> f = Pair<double>{1.0 - inverse, 0.0} / Pair<double>{1.0 + inverse, 0.0};
        const Pair<double> half = odd_series(f, 1.0, 22, of_odd_numbers);  // artanh f
        const double first = (2.0 * half.high + kWhole) - kWhole;
        out[k] = {inverse, first, (2.0 * half.high - first) + 2.0 * half.low, 0.0};
    }
    return out;
}
inline constexpr auto kLogarithms = logarithm_table();

inline constexpr int kAngleSteps = 64;  // of a tangent from 0 to 1

/// Row k up to 64: the angle whose tangent is k / 64, and what it lacks. As many rows as 7 bits name: what is no number
/// may name any.
constexpr Table<128, 2> angle_table()
{
    constexpr auto kSteps = static_cast<std::size_t>(kAngleSteps);
    Table<128, 2> out{};
    Pair<double> angle{0.0, 0.0};
    for (std::size_t k = 1; k <= kSteps; ++k) {
        // from the angle before: by the tangent of a difference
        const Pair<double> tangent = Pair<double>{static_cast<double>(kSteps), 0.0} /
                                     Pair<double>{static_cast<double>(kSteps * kSteps + k * (k - 1)), 0.0};
        angle = angle + odd_series(tangent, -1.0, 9, of_odd_numbers);
        out[k] = {angle.high, angle.low};
    }
    return out;
}
inline constexpr auto kAngles = angle_table();

}  // namespace numbers
