#pragma once

#include "numbers/instructions.h"
#include "numbers/random.h"

#include <cstddef>

/// random_at for many points: the same bits.
namespace numbers {

#if defined(__AVX512DQ__)

struct RandomWords {
    static constexpr std::size_t kLanes = 8;
    __m512i v;

    static RandomWords load(const void* from) { return {_mm512_loadu_si512(from)}; }
    static RandomWords all(std::uint64_t v) { return {_mm512_set1_epi64(static_cast<long long>(v))}; }
    RandomWords operator+(RandomWords o) const { return {_mm512_add_epi64(v, o.v)}; }
    RandomWords operator^(RandomWords o) const { return {_mm512_xor_si512(v, o.v)}; }
    RandomWords operator*(std::uint64_t by) const { return {_mm512_mullo_epi64(v, all(by).v)}; }
    template <int kBits>
    RandomWords shifted() const
    {
        return {_mm512_srli_epi64(v, kBits)};
    }
    /// Their upper 53 bits as numbers in [0, 1).
    void store_numbers(double* to) const
    {
        _mm512_storeu_pd(to, _mm512_mul_pd(_mm512_cvtepi64_pd(shifted<11>().v), _mm512_set1_pd(0x1p-53)));
    }
};

#elif defined(__AVX2__)

struct RandomWords {
    static constexpr std::size_t kLanes = 4;
    __m256i v;

    static RandomWords load(const void* from) { return {_mm256_loadu_si256(static_cast<const __m256i*>(from))}; }
    static RandomWords all(std::uint64_t v) { return {_mm256_set1_epi64x(static_cast<long long>(v))}; }
    RandomWords operator+(RandomWords o) const { return {_mm256_add_epi64(v, o.v)}; }
    RandomWords operator^(RandomWords o) const { return {_mm256_xor_si256(v, o.v)}; }
    /// From products of halves; that of the upper ones lies beyond the 64 bits.
    RandomWords operator*(std::uint64_t by) const
    {
        const __m256i low = all(by & 0xffffffffu).v, high = all(by >> 32).v;
        const __m256i crossed =
            _mm256_add_epi64(_mm256_mul_epu32(_mm256_srli_epi64(v, 32), low), _mm256_mul_epu32(v, high));
        return {_mm256_add_epi64(_mm256_mul_epu32(v, low), _mm256_slli_epi64(crossed, 32))};
    }
    template <int kBits>
    RandomWords shifted() const
    {
        return {_mm256_srli_epi64(v, kBits)};
    }
    /// Halves become the last digits of 2^52 and of 2^84; nothing is rounded.
    void store_numbers(double* to) const
    {
        const __m256i low = _mm256_and_si256(shifted<11>().v, all(0xffffffffu).v), high = shifted<43>().v;
        const auto number = [](__m256i digits, double place) {
            const __m256d p = _mm256_set1_pd(place);
            return _mm256_sub_pd(_mm256_or_pd(_mm256_castsi256_pd(digits), p), p);
        };
        const __m256d sum = _mm256_add_pd(number(high, 0x1p84), number(low, 0x1p52));
        _mm256_storeu_pd(to, _mm256_mul_pd(sum, _mm256_set1_pd(0x1p-53)));
    }
};

#endif

/// random_at of `count` points, a multiple of 8, for purposes purpose[n] + next.
inline void random_at(const double* x, const double* y, const double* z, const std::uint64_t* purpose,
                      std::uint32_t next, std::size_t count, double* out)
{
#if defined(__AVX2__)
    const auto mixed = [](RandomWords w) {
        w = (w ^ w.shifted<30>()) * 0xbf58476d1ce4e5b9u;
        w = (w ^ w.shifted<27>()) * 0x94d049bb133111ebu;
        return w ^ w.shifted<31>();
    };
    for (std::size_t n = 0; n < count; n += RandomWords::kLanes) {
        const RandomWords first = (RandomWords::load(purpose + n) + RandomWords::all(next + 1u)) * 0x9e3779b97f4a7c15u;
        mixed(mixed(mixed(RandomWords::load(x + n) + first) ^ RandomWords::load(y + n)) + RandomWords::load(z + n))
            .store_numbers(out + n);
    }
#else
    for (std::size_t n = 0; n < count; ++n)
        out[n] = random_at({x[n], y[n], z[n]}, static_cast<std::uint32_t>(purpose[n]) + next);
#endif
}

}  // namespace numbers
