#pragma once

/// The processor's own instructions by their names. Nothing else of ours includes them, so that another processor needs
/// this file alone.
#if defined(__x86_64__)
#if defined(__AVX__) || defined(__BMI2__)
#include <immintrin.h>
#else
#include <nmmintrin.h>
#endif
#else
// Those of x86-64-v2 in words that any compiler turns into its processor's. Not SIMDe's own choice of NEON: that
// answers otherwise for NaN, for halves and out of range.
#define SIMDE_NO_NATIVE
#define SIMDE_ENABLE_NATIVE_ALIASES
#define SIMDE_NO_CHECK_IMMEDIATE_CONSTANT  // counts of xsimd's shifts are no constants; SIMDE's functions are right for
                                           // any
#include <simde/x86/sse4.2.h>

// SIMDe's are macros, which take no parameter packs.
#undef _mm_setr_ps
#undef _mm_setr_pd
inline __m128 _mm_setr_ps(float a, float b, float c, float d) { return simde_mm_setr_ps(a, b, c, d); }
inline __m128d _mm_setr_pd(double a, double b) { return simde_mm_setr_pd(a, b); }

// SIMDe's say no where one of both is no number,
#undef _mm_cmpnle_ps
inline __m128 _mm_cmpnle_ps(__m128 a, __m128 b)
{
    return simde_mm_xor_ps(simde_mm_cmple_ps(a, b), simde_mm_castsi128_ps(simde_mm_set1_epi32(-1)));
}
// and have another last whole number.
#undef _mm_cvttsd_si32
#undef _mm_cvttsd_si64
#undef _mm_cvttpd_epi32
inline int _mm_cvttsd_si32(__m128d a)
{
    const double v = simde_mm_cvtsd_f64(a);
    return v > -2147483649.0 && v < 2147483648.0 ? static_cast<int>(v) : -2147483647 - 1;
}
inline long long _mm_cvttsd_si64(__m128d a)
{
    const double v = simde_mm_cvtsd_f64(a);
    return v >= -0x1p63 && v < 0x1p63 ? static_cast<long long>(v) : -0x7fffffffffffffff - 1;
}
inline __m128i _mm_cvttpd_epi32(__m128d a)
{
    return simde_mm_setr_epi32(_mm_cvttsd_si32(a), _mm_cvttsd_si32(simde_mm_unpackhi_pd(a, a)), 0, 0);
}

// xsimd takes them too, and with them the lanes, the order of sums and the bits of x86-64.
#pragma push_macro("__ARM_NEON")
#undef __ARM_NEON
#define __SSE2__ 1
#define __SSE3__ 1
#define __SSSE3__ 1
#define __SSE4_1__ 1
#define __SSE4_2__ 1
#include <xsimd/config/xsimd_config.hpp>
#undef __SSE2__
#undef __SSE3__
#undef __SSSE3__
#undef __SSE4_1__
#undef __SSE4_2__
#pragma pop_macro("__ARM_NEON")
#endif
