#pragma once

#include "numbers/functions/sines.h"

namespace numbers {

/// Any finite angle whose size is 2^15 or more: the bits of 1 / (2 pi) that are neither whole turns nor too small to
/// matter, times its mantissa (Payne and Hanek).
inline Turned<double> turned_far(double x)
{
    __extension__ using Wide = unsigned __int128;
    __extension__ using SignedWide = __int128;
    // 1 / (2 pi), 1280 bits behind the point
    static constexpr std::uint64_t kPerTurn[] = {
        0x28be60db9391054a, 0x7f09d5f47d4d3770, 0x36d8a5664f10e410, 0x7f9458eaf7aef158, 0x6dc91b8e909374b8,
        0x01924bba82746487, 0x3f877ac72c4a69cf, 0xba208d7d4baed121, 0x3a671c09ad17df90, 0x4e64758e60d4ce7d,
        0x272117e2ef7e4a0e, 0xc7fe25fff7816603, 0xfbcbc462d6829b47, 0xdb4d9fb3c9f2c26d, 0xd3d18fd9a797fa8b,
        0x5d49eeb1faf97c5e, 0xcf41ce7de294a4ba, 0x9afed7ec47e35742, 0x1580cc11bf1edaea, 0xfc33ef0826bd0d87};
    constexpr int kMantissa = 52;
    const std::uint64_t bits = words_of(x);
    const std::uint64_t mantissa = (bits & ((std::uint64_t{1} << kMantissa) - 1)) | (std::uint64_t{1} << kMantissa);
    const int exponent = static_cast<int>(bits >> kMantissa & 0x7ff) - 1023 - kMantissa;  // of the mantissa's last bit
    // 192 bits from the first that is less than a turn; those before the point are 0
    const auto word = [&](int bit) {
        const int at = bit >= 0 ? bit / 64 : -1, within = bit - 64 * at;
        const std::uint64_t first = at >= 0 ? kPerTurn[at] : 0;
        return within == 0 ? first : first << within | kPerTurn[at + 1] >> (64 - within);
    };
    const Wide low = Wide{word(exponent + 128)} * mantissa, middle = Wide{word(exponent + 64)} * mantissa + (low >> 64);
    const std::uint64_t high = word(exponent) * mantissa + static_cast<std::uint64_t>(middle >> 64);
    // turns = (high, middle, low) 2^-192; the first 7 bits are steps, rounded to the nearest
    const std::uint64_t step = (high + (std::uint64_t{1} << 56)) >> 57;
    const Wide rest = Wide{high << 7 | static_cast<std::uint64_t>(middle) >> 57} << 64 |
                      (static_cast<std::uint64_t>(middle) << 7 | static_cast<std::uint64_t>(low) >> 57);
    const auto signed_rest = static_cast<SignedWide>(rest);
    const auto first = static_cast<double>(signed_rest);
    const auto second = static_cast<double>(signed_rest - static_cast<SignedWide>(first));
    Pair<double> r = Pair<double>{first * 0x1p-128, second * 0x1p-128} * (kHalfPi * Pair<double>{1.0 / 32, 0.0});
    if (std::signbit(x)) return {std::uint64_t{0} - step, {-r.high, -r.low}};
    return {step, r};
}

}  // namespace numbers
