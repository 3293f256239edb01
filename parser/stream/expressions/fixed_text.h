#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace parser {

/// Room for what fixed_text() writes.
inline constexpr std::size_t kFixedText = 48;

/// Powers of ten.
inline constexpr auto kTensOfText = [] {
    std::array<std::uint64_t, 19> tens{1};
    for (std::size_t i = 1; i < tens.size(); ++i) tens[i] = 10 * tens[i - 1];
    return tens;
}();

/// "00" to "99".
inline constexpr auto kPairs = [] {
    std::array<char, 200> pairs{};
    for (std::size_t i = 0; i < 100; ++i) {
        pairs[2 * i] = static_cast<char>('0' + i / 10);
        pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
    }
    return pairs;
}();

/// C's %.*f where all digits together fit into 63 bits: a number is whole times a power of two, so that its product
/// with a power of ten, and the rest that is rounded off, are whole too. Written so that it ends at `end`: where it
/// begins; null: it does not fit.
inline char* fixed_text(char* end, double value, int precision)
{
    constexpr int kMostPrecision = 18, kFractionBits = 52, kBias = 1075, kSpecial = 0x7ff, kAllBits = 128;
    __extension__ using Wide = unsigned __int128;
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const int exponent = static_cast<int>(bits >> kFractionBits & kSpecial);
    if (precision < 0 || precision > kMostPrecision || exponent == kSpecial) return nullptr;
    std::uint64_t mantissa = bits & ((std::uint64_t{1} << kFractionBits) - 1);
    if (exponent != 0) mantissa |= std::uint64_t{1} << kFractionBits;
    const int shift = kBias - (exponent == 0 ? 1 : exponent);
    if (shift < 0) return nullptr;  // 2^53 or more
    const Wide scaled = static_cast<Wide>(mantissa) * kTensOfText[static_cast<std::size_t>(precision)];
    Wide whole = 0;  // of a shift beyond all bits: less than a half
    if (shift < kAllBits) {
        whole = scaled >> shift;
        const Wide rest = scaled - (whole << shift), half = shift == 0 ? Wide{1} : Wide{1} << (shift - 1);
        if (whole >> 63 != 0) return nullptr;
        if (rest > half || (rest == half && whole % 2 != 0)) ++whole;
    }
    auto digits = static_cast<std::uint64_t>(whole);
    char* at = end;
    const auto put_two = [&] {
        std::memcpy(at -= 2, &kPairs[2 * (digits % 100)], 2);
        digits /= 100;
    };
    const auto put = [&] {
        *--at = static_cast<char>('0' + digits % 10);
        digits /= 10;
    };
    for (int i = 1; i < precision; i += 2) put_two();
    if (precision % 2 != 0) put();
    if (precision > 0) *--at = '.';
    while (digits >= 100) put_two();
    if (digits >= 10) put_two();
    else put();
    if (bits >> 63 != 0) *--at = '-';
    return at;
}

}  // namespace parser
