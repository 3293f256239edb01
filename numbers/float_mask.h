#pragma once

#include "numbers/lanes.h"

#include <cstdint>

/// Some lanes of a register of floats.
namespace numbers {

using lanes::FloatPart;
using lanes::kFloatPart;

class FloatMask {
public:
    /// Lane i is one of them if bit i is set; bits beyond the lanes are ignored.
    explicit FloatMask(std::uint64_t bits);

    /// v in these lanes, 0 in the others.
    FloatPart kept(FloatPart v) const;
    /// a in these lanes, b in the others.
    FloatPart chosen(FloatPart a, FloatPart b) const;

private:
#if defined(__AVX512VL__)
    __mmask8 lanes_;
#elif defined(__AVX2__)
    __m256 lanes_;
#else
    __m128 lanes_;
#endif
};

#if defined(__AVX512VL__)
inline FloatMask::FloatMask(std::uint64_t bits) : lanes_(static_cast<__mmask8>(bits)) {}
inline FloatPart FloatMask::kept(FloatPart v) const { return _mm256_maskz_mov_ps(lanes_, v); }
inline FloatPart FloatMask::chosen(FloatPart a, FloatPart b) const { return _mm256_mask_mov_ps(b, lanes_, a); }
#elif defined(__AVX2__)
inline FloatMask::FloatMask(std::uint64_t bits)
{
    const __m256i own = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
    const __m256i all = _mm256_set1_epi32(static_cast<int>(static_cast<std::uint32_t>(bits)));
    lanes_ = _mm256_castsi256_ps(_mm256_cmpeq_epi32(_mm256_and_si256(all, own), own));
}
inline FloatPart FloatMask::kept(FloatPart v) const { return _mm256_and_ps(lanes_, v); }
inline FloatPart FloatMask::chosen(FloatPart a, FloatPart b) const { return _mm256_blendv_ps(b, a, lanes_); }
#else
inline FloatMask::FloatMask(std::uint64_t bits)
{
    const __m128i own = _mm_setr_epi32(1, 2, 4, 8);
    const __m128i all = _mm_set1_epi32(static_cast<int>(static_cast<std::uint32_t>(bits)));
    lanes_ = _mm_castsi128_ps(_mm_cmpeq_epi32(_mm_and_si128(all, own), own));
}
inline FloatPart FloatMask::kept(FloatPart v) const { return _mm_and_ps(lanes_, v); }
inline FloatPart FloatMask::chosen(FloatPart a, FloatPart b) const
{
    return _mm_or_ps(_mm_and_ps(lanes_, a), _mm_andnot_ps(lanes_, b));
}
#endif

}  // namespace numbers
