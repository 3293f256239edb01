#pragma once

#include "numbers/infinity.h"
#include "numbers/lanes.h"

/// Small arithmetic that intervals of several rays are made with.
namespace csg::lanes {

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

inline Double before() { return Double(-kInfinity); }
inline Double beyond() { return Double(kInfinity); }

}  // namespace csg::lanes
