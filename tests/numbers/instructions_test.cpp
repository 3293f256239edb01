#include "numbers/instructions.h"
#include "numbers/rounding.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

/// What the sources rely on where instructions differ by processor: numbers that are none, zeros' signs, ranges,
/// counts. As Intel's Software Developer's Manual, volume 2, has them.
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN(), kInfinite = std::numeric_limits<double>::infinity();
constexpr double kOdd[] = {0.0,           -0.0,          1.0,           -1.0,         0.5,          -0.5,
                           1.5,           2.5,           -2.5,          2147483647.0, 2147483647.5, 2147483648.0,
                           -2147483648.0, -2147483648.5, -2147483649.0, 1e300,        -1e300,       5e-324,
                           kInfinite,     -kInfinite,    kNone,         -kNone};

/// By bits: 0 is not -0.
template <typename A>
bool same(A a, A b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}

template <typename Register, typename Number>
Number first(Register r)
{
    Number v;
    std::memcpy(&v, &r, sizeof v);
    return v;
}
double one(__m128d r) { return first<__m128d, double>(r); }
float one(__m128 r) { return first<__m128, float>(r); }

std::int32_t whole(double v)  // towards zero
{
    return v > -2147483649.0 && v < 2147483648.0 ? static_cast<std::int32_t>(v)
                                                 : std::numeric_limits<std::int32_t>::min();
}

}  // namespace

TEST_CASE("of two numbers the second is the smaller and the larger one where no order is between them", "[numbers]")
{
    for (const double a : kOdd)
        for (const double b : kOdd) {
            INFO(a << ", " << b);
            const __m128d x = _mm_set1_pd(a), y = _mm_set1_pd(b);
            CHECK(same(one(_mm_min_pd(x, y)), a < b ? a : b));
            CHECK(same(one(_mm_min_sd(x, y)), a < b ? a : b));
            CHECK(same(one(_mm_max_pd(x, y)), a > b ? a : b));
            const float c = static_cast<float>(a), d = static_cast<float>(b);
            const __m128 u = _mm_set1_ps(c), v = _mm_set1_ps(d);
            CHECK(same(one(_mm_min_ps(u, v)), c < d ? c : d));
            CHECK(same(one(_mm_max_ps(u, v)), c > d ? c : d));
            CHECK(_mm_movemask_ps(_mm_cmpnle_ps(u, v)) == (c <= d ? 0 : 15));
            CHECK(_mm_movemask_ps(_mm_cmple_ps(u, v)) == (c <= d ? 15 : 0));
            CHECK(_mm_movemask_ps(_mm_cmpneq_ps(u, v)) == (c != d ? 15 : 0));
            CHECK(_mm_movemask_pd(_mm_cmplt_pd(x, y)) == (a < b ? 3 : 0));
            CHECK(_mm_movemask_pd(_mm_cmpneq_pd(x, y)) == (a != b ? 3 : 0));
            CHECK(_mm_movemask_pd(_mm_cmpunord_pd(x, y)) == (std::isnan(a) || std::isnan(b) ? 3 : 0));
            CHECK(same(one(_mm_blendv_pd(x, y, x)), std::signbit(a) ? b : a));
            CHECK(same(one(_mm_blendv_ps(u, v, u)), std::signbit(c) ? d : c));
        }
}

TEST_CASE("what is beyond 32 bits becomes the least of them", "[numbers]")
{
    for (const double a : kOdd) {
        INFO(a);
        const __m128i both = _mm_cvttpd_epi32(_mm_setr_pd(a, 7.0));
        CHECK(first<__m128i, std::array<std::int32_t, 4>>(both) == std::array<std::int32_t, 4>{whole(a), 7, 0, 0});
        CHECK(numbers::truncated(a) == whole(a));
        CHECK(numbers::truncated_far(a) ==
              (std::abs(a) < 0x1p63 ? static_cast<long long>(a) : std::numeric_limits<long long>::min()));
        const float f = static_cast<float>(a);
        CHECK(_mm_cvtsi128_si32(_mm_cvttps_epi32(_mm_set1_ps(f))) == whole(f));
        CHECK(_mm_cvtsi128_si32(_mm_cvtps_epi32(_mm_set1_ps(f))) == whole(std::nearbyint(f)));
        CHECK(same(one(_mm_cvtpd_ps(_mm_set1_pd(a))), f));
    }
}

TEST_CASE("numbers are rounded to the nearest even, down, up and to zero, and zeros keep their sign", "[numbers]")
{
    for (const double a : kOdd) {
        INFO(a);
        const __m128d x = _mm_set1_pd(a);
        const __m128 u = _mm_set1_ps(static_cast<float>(a));
        CHECK(same(one(_mm_round_pd(x, _MM_FROUND_TO_NEAREST_INT)), std::nearbyint(a)));
        CHECK(same(one(_mm_floor_pd(x)), std::floor(a)));
        CHECK(same(one(_mm_ceil_pd(x)), std::ceil(a)));
        CHECK(same(one(_mm_round_pd(x, _MM_FROUND_TO_ZERO)), std::trunc(a)));
        CHECK(same(one(_mm_round_ps(u, _MM_FROUND_TO_NEAREST_INT)), std::nearbyint(static_cast<float>(a))));
        CHECK(same(one(_mm_floor_ps(u)), std::floor(static_cast<float>(a))));
    }
}

TEST_CASE("shifts take any count", "[numbers]")
{
    const std::uint64_t v = 0xfedcba9876543210;
    const __m128i x = _mm_set1_epi64x(static_cast<long long>(v));
    for (int n = 0; n < 70; ++n) {
        INFO(n);
        const auto word = static_cast<std::uint32_t>(v);
        const auto half = static_cast<std::uint16_t>(v);
        CHECK(first<__m128i, std::uint64_t>(_mm_srli_epi64(x, n)) == (n < 64 ? v >> n : 0));
        CHECK(first<__m128i, std::uint64_t>(_mm_slli_epi64(x, n)) == (n < 64 ? v << n : 0));
        CHECK(first<__m128i, std::uint32_t>(_mm_srli_epi32(x, n)) == (n < 32 ? word >> n : 0));
        CHECK(first<__m128i, std::uint32_t>(_mm_slli_epi32(x, n)) == (n < 32 ? word << n : 0));
        CHECK(first<__m128i, std::int32_t>(_mm_srai_epi32(_mm_set1_epi32(-77), n)) == -77 >> (n < 32 ? n : 31));
        CHECK(first<__m128i, std::uint16_t>(_mm_srli_epi16(x, n)) == (n < 16 ? half >> n : 0));
    }
}

TEST_CASE("bytes are compared, averaged and summed without signs", "[numbers]")
{
    for (unsigned a = 0; a < 256; a += 5)
        for (unsigned b = 0; b < 256; b += 3) {
            const __m128i x = _mm_set1_epi8(static_cast<char>(a)), y = _mm_set1_epi8(static_cast<char>(b));
            const auto byte = [](__m128i r) { return unsigned{first<__m128i, std::uint8_t>(r)}; };
            REQUIRE(byte(_mm_min_epu8(x, y)) == std::min(a, b));
            REQUIRE(byte(_mm_avg_epu8(x, y)) == (a + b + 1) / 2);
            REQUIRE(byte(_mm_subs_epu8(x, y)) == (a > b ? a - b : 0));
            REQUIRE(byte(_mm_sub_epi8(x, y)) == ((a - b) & 255));
            REQUIRE(first<__m128i, std::uint64_t>(_mm_sad_epu8(x, y)) == 8 * (a > b ? a - b : b - a));
            REQUIRE(_mm_movemask_epi8(_mm_cmpeq_epi8(x, y)) == (a == b ? 0xffff : 0));
        }
}
