#pragma once

#include "numbers/instructions.h"

#include <cstddef>

namespace numbers {

/// Four doubles, whatever the instruction set.
struct Row {
#if defined(__AVX__)
    __m256d v;
    static Row load(const double* p) { return {_mm256_load_pd(p)}; }
    static Row all(double a) { return {_mm256_set1_pd(a)}; }
    static Row of(double a, double b, double c, double d) { return {_mm256_set_pd(d, c, b, a)}; }
    friend Row operator+(Row a, Row b) { return {_mm256_add_pd(a.v, b.v)}; }
    friend Row operator-(Row a, Row b) { return {_mm256_sub_pd(a.v, b.v)}; }
    friend Row operator*(Row a, Row b) { return {_mm256_mul_pd(a.v, b.v)}; }
    /// Lane i + 1 of `b` where bit i is set, otherwise that of `a`.
    template <int Bits>
    static Row choose(Row a, Row b)
    {
        return {_mm256_blend_pd(a.v, b.v, Bits << 1)};
    }
    __m128d low() const { return _mm256_castpd256_pd128(v); }
    __m128d high() const { return _mm256_extractf128_pd(v, 1); }

    /// The totals of so many rows at once.
    static constexpr std::size_t kAtOnce = 4;
    static void store_totals(const Row* rows, double* out)
    {
        const auto pairs = [](Row a, Row b) {
            return _mm256_add_pd(_mm256_unpacklo_pd(a.v, b.v), _mm256_unpackhi_pd(a.v, b.v));
        };
        const __m256d a = pairs(rows[0], rows[1]), b = pairs(rows[2], rows[3]);
        _mm256_store_pd(out, _mm256_add_pd(_mm256_permute2f128_pd(a, b, 0x20), _mm256_permute2f128_pd(a, b, 0x31)));
    }
#else
    __m128d l, h;
    static Row load(const double* p) { return {_mm_load_pd(p), _mm_load_pd(p + 2)}; }
    static Row all(double a) { return {_mm_set1_pd(a), _mm_set1_pd(a)}; }
    static Row of(double a, double b, double c, double d) { return {_mm_set_pd(b, a), _mm_set_pd(d, c)}; }
    friend Row operator+(Row a, Row b) { return {_mm_add_pd(a.l, b.l), _mm_add_pd(a.h, b.h)}; }
    friend Row operator-(Row a, Row b) { return {_mm_sub_pd(a.l, b.l), _mm_sub_pd(a.h, b.h)}; }
    friend Row operator*(Row a, Row b) { return {_mm_mul_pd(a.l, b.l), _mm_mul_pd(a.h, b.h)}; }
    template <int Bits>
    static Row choose(Row a, Row b)
    {
        return {two<0, (Bits & 1)>(a.l, b.l), two<((Bits >> 1) & 1), (Bits >> 2)>(a.h, b.h)};
    }
    template <int First, int Second>
    static __m128d two(__m128d a, __m128d b)
    {
        return _mm_shuffle_pd(First != 0 ? b : a, Second != 0 ? b : a, 2);
    }
    __m128d low() const { return l; }
    __m128d high() const { return h; }

    static constexpr std::size_t kAtOnce = 2;
    static void store_totals(const Row* rows, double* out)
    {
        const auto pairs = [](Row a) { return _mm_add_pd(_mm_unpacklo_pd(a.l, a.h), _mm_unpackhi_pd(a.l, a.h)); };
        const __m128d a = pairs(rows[0]), b = pairs(rows[1]);
        _mm_store_pd(out, _mm_add_pd(_mm_unpacklo_pd(a, b), _mm_unpackhi_pd(a, b)));
    }
#endif
    /// (0 + 1) + (2 + 3)
    double total() const
    {
        const __m128d pairs = _mm_add_pd(_mm_unpacklo_pd(low(), high()), _mm_unpackhi_pd(low(), high()));
        return _mm_cvtsd_f64(_mm_add_sd(pairs, _mm_unpackhi_pd(pairs, pairs)));
    }
};

}  // namespace numbers
