#pragma once

#include "numbers/infinity.h"
#include "numbers/lanes.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

/// Small arithmetic of registers: signs, the least, products and sums with one rounding, whole numbers. What a template
/// over a double or lanes of them needs has a form for each.
namespace numbers::lanes {

using Bool = Double::batch_bool_type;

/// The least of a vector, by halves: no number waits for more than three others.
inline double lowest(Double v)
{
#if defined(__AVX512F__)
    const __m256d four = _mm256_min_pd(_mm512_castpd512_pd256(v), _mm512_extractf64x4_pd(v, 1));
    const __m128d two = _mm_min_pd(_mm256_castpd256_pd128(four), _mm256_extractf128_pd(four, 1));
#elif defined(__AVX__)
    const __m128d two = _mm_min_pd(_mm256_castpd256_pd128(v), _mm256_extractf128_pd(v, 1));
#else
    const __m128d two = v;
#endif
    return _mm_cvtsd_f64(_mm_min_sd(two, _mm_unpackhi_pd(two, two)));
}

/// xsimd negates by subtraction on AVX-512, which loses the sign of 0.
inline Double negated(Double v) { return v ^ Double(-0.0); }
inline double negated(double v) { return -v; }

/// What a comparison of two T is: bool, or a bit a lane.
template <class T>
using Truth = decltype(std::declval<T>() < std::declval<T>());
inline std::uint32_t mask(bool b) { return b; }

template <class T>
inline T choose(bool which, const T& a, const T& b)
{
    return which ? a : b;
}
inline Double choose(const Bool& which, const Double& a, const Double& b) { return xsimd::select(which, a, b); }
inline Bool choose(const Bool& which, const Bool& a, const Bool& b) { return (which & a) | ((!which) & b); }
/// The same of what is worked out here: lanes need both, one number only its own.
template <class Yes, class No>
inline double either(bool which, Yes&& yes, No&& no)
{
    return which ? yes() : no();
}
template <class Yes, class No>
inline Double either(const Bool& which, Yes&& yes, No&& no)
{
    return xsimd::select(which, yes(), no());
}
template <class T>
inline T smaller(const T& a, const T& b)
{
    return choose(b < a, b, a);
}
template <class T>
inline T larger(const T& a, const T& b)
{
    return choose(a < b, b, a);
}
inline bool differ(bool a, bool b) { return a != b; }
inline Bool differ(const Bool& a, const Bool& b) { return (a & (!b)) | ((!a) & b); }
inline void store(double v, double* to) { *to = v; }
inline void store(const Double& v, double* to) { v.store_aligned(to); }
inline double root_of(double v) { return std::sqrt(v); }
inline Double root_of(const Double& v) { return xsimd::sqrt(v); }
/// What is not negative, with the sign of another.
inline double signed_as(double size, double of) { return std::copysign(size, of); }
inline Double signed_as(const Double& size, const Double& of) { return size | (of & Double(-0.0)); }
/// Negated where the other has a minus.
inline double flipped_as(double v, double of) { return v * std::copysign(1.0, of); }
inline Double flipped_as(const Double& v, const Double& of) { return v ^ (of & Double(-0.0)); }
inline double size_of(double v) { return std::abs(v); }
inline Double size_of(const Double& v) { return xsimd::abs(v); }

/// std::fma(): xsimd's rounds twice where it knows no instruction for it, as it does for AVX-512.
inline double fused(double a, double b, double c) { return std::fma(a, b, c); }
inline Double fused(const Double& a, const Double& b, const Double& c)
{
#if defined(__AVX512F__)
    return Double(_mm512_fmadd_pd(a.data, b.data, c.data));
#elif defined(__AVX__) && defined(__FMA__)
    return Double(_mm256_fmadd_pd(a.data, b.data, c.data));
#else
    alignas(64) std::array<double, static_cast<std::size_t>(kDoubles)> x, y, z;
    a.store_aligned(x.data());
    b.store_aligned(y.data());
    c.store_aligned(z.data());
    for (std::size_t k = 0; k < z.size(); ++k) z[k] = std::fma(x[k], y[k], z[k]);
    return Double::load_aligned(z.data());
#endif
}

#if defined(__FMA__)
/// v - q m with one rounding.
inline Double fused_rest(const Double& v, const Double& q, const Double& m)
{
#if defined(__AVX512F__)
    return Double(_mm512_fnmadd_pd(q.data, m.data, v.data));
#else
    return Double(_mm256_fnmadd_pd(q.data, m.data, v.data));
#endif
}
#endif

/// Whole numbers, as such.
inline void store_whole(const Double& v, std::int32_t* to)
{
#if defined(__AVX512F__)
    _mm256_store_si256(reinterpret_cast<__m256i*>(to), _mm512_cvttpd_epi32(v));
#elif defined(__AVX__)
    _mm_store_si128(reinterpret_cast<__m128i*>(to), _mm256_cvttpd_epi32(v));
#else
    _mm_storel_epi64(reinterpret_cast<__m128i*>(to), _mm_cvttpd_epi32(v));
#endif
}

inline Double before() { return Double(-kInfinity); }
inline Double beyond() { return Double(kInfinity); }

}  // namespace numbers::lanes
