#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace parser {

inline constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                          1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// Digits of at most 2^53 times or over a power of ten up to 10^22 are rounded once.
inline constexpr std::uint64_t kExactDigits = std::uint64_t{1} << 53;

/// How many of the eight bytes from the first on are digits; `value`: what the first `count` of them say.
class EightDigits {
public:
    explicit EightDigits(const char* at)
    {
        static_assert(std::endian::native == std::endian::little, "the first byte is the lowest");
        constexpr std::uint64_t kZeros = 0x3030303030303030, kAbove = 0x7676767676767676, kHigh = 0x8080808080808080;
        std::memcpy(&bytes_, at, sizeof bytes_);
        bytes_ ^= kZeros;  // 0 to 9 where a digit stands
        const std::uint64_t others = (((bytes_ & ~kHigh) + kAbove) | bytes_) & kHigh;
        count_ = others == 0 ? 8 : std::countr_zero(others) / 8;
    }
    int count() const { return count_; }
    /// Not for a count of 0. Pairs, fours and eight are summed up at once.
    std::uint64_t value() const
    {
        std::uint64_t v = bytes_ << (64 - 8 * count_);
        v = ((v * (1 + (std::uint64_t{10} << 8))) >> 8) & 0x00ff00ff00ff00ff;
        v = ((v * (1 + (std::uint64_t{100} << 16))) >> 16) & 0x0000ffff0000ffff;
        return (v * (1 + (std::uint64_t{10000} << 32))) >> 32;
    }

private:
    std::uint64_t bytes_ = 0;
    int count_ = 0;
};

/// Bytes that short_number() looks at, and those behind it that may be looked at.
inline constexpr std::size_t kShortNumber = 32;

/// A number of at most eight digits before the point and eight behind it, with an exponent of one or two digits or
/// none, as most numbers are written. Where it ends; null: it is none, or another form. kShortNumber bytes must be
/// there.
inline const char* short_number(const char* at, double& value)
{
    const EightDigits before(at);
    if (before.count() == 0) return nullptr;
    std::uint64_t digits = before.value();
    at += before.count();
    int power = 0;
    if (*at == '.') {
        const EightDigits behind(++at);
        if (behind.count() == 0) return nullptr;
        power = -behind.count();
        digits = digits * static_cast<std::uint64_t>(kPowersOfTen[behind.count()]) + behind.value();
        at += behind.count();
    }
    if ((*at | 0x20) == 'e') {
        const bool minus = at[1] == '-';
        at += minus || at[1] == '+' ? 2 : 1;
        const EightDigits exponent(at);
        if (exponent.count() == 0 || exponent.count() > 2) return nullptr;
        power += minus ? -static_cast<int>(exponent.value()) : static_cast<int>(exponent.value());
        at += exponent.count();
        if (power < -22 || power > 22) return nullptr;
    }
    if (*at >= '0' && *at <= '9') return nullptr;
    if (digits > kExactDigits) return nullptr;
    const auto whole = static_cast<double>(static_cast<std::int64_t>(digits));
    value = power < 0 ? whole / kPowersOfTen[-power] : whole * kPowersOfTen[power];
    return at;
}

}  // namespace parser
