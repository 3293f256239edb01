#pragma once

#include "numbers/lanes.h"

#if defined(__AVX2__)
namespace numbers::lanes {

/// Two numbers of 16 bits a lane, as they stand one behind the other in memory.
class WordPairs {
public:
#if defined(__AVX512F__)
    /// Of the lanes of the mask, each at a whole number of elements; 0 in the others.
    template <class Element>
    static WordPairs gather(const Element* from, const Double& at, std::uint32_t mask)
    {
        return {_mm256_mmask_i32gather_epi32(_mm256_setzero_si256(), static_cast<__mmask8>(mask),
                                             _mm512_cvttpd_epi32(at), from, sizeof(Element))};
    }
    Double first() const { return Double(_mm512_cvtepi32_pd(_mm256_and_si256(v_, _mm256_set1_epi32(0xffff)))); }
    Double second() const { return Double(_mm512_cvtepi32_pd(_mm256_srli_epi32(v_, 16))); }
    /// The least of four, then the largest.
    static WordPairs range(const WordPairs& a, const WordPairs& b)
    {
        const __m256i least = _mm256_min_epu16(a.v_, b.v_), most = _mm256_max_epu16(a.v_, b.v_);
        return {_mm256_blend_epi16(_mm256_min_epu16(least, _mm256_srli_epi32(least, 16)),
                                   _mm256_max_epu16(most, _mm256_slli_epi32(most, 16)), 0xaa)};
    }
    /// In the lanes of the mask another's.
    void replace(std::uint32_t mask, const WordPairs& by)
    {
        v_ = _mm256_mask_mov_epi32(v_, static_cast<__mmask8>(mask), by.v_);
    }

private:
    using Register = __m256i;
#else
    template <class Element>
    static WordPairs gather(const Element* from, const Double& at, std::uint32_t mask)
    {
        return {_mm_mask_i32gather_epi32(_mm_setzero_si128(), reinterpret_cast<const int*>(from),
                                         _mm256_cvttpd_epi32(at), all_bits(mask), sizeof(Element))};
    }
    Double first() const { return Double(_mm256_cvtepi32_pd(_mm_and_si128(v_, _mm_set1_epi32(0xffff)))); }
    Double second() const { return Double(_mm256_cvtepi32_pd(_mm_srli_epi32(v_, 16))); }
    static WordPairs range(const WordPairs& a, const WordPairs& b)
    {
        const __m128i least = _mm_min_epu16(a.v_, b.v_), most = _mm_max_epu16(a.v_, b.v_);
        return {_mm_blend_epi16(_mm_min_epu16(least, _mm_srli_epi32(least, 16)),
                                _mm_max_epu16(most, _mm_slli_epi32(most, 16)), 0xaa)};
    }
    void replace(std::uint32_t mask, const WordPairs& by) { v_ = _mm_blendv_epi8(v_, by.v_, all_bits(mask)); }

private:
    using Register = __m128i;
    static Register all_bits(std::uint32_t mask)
    {
        const Register bit = _mm_setr_epi32(1, 2, 4, 8);
        return _mm_cmpeq_epi32(_mm_and_si128(_mm_set1_epi32(static_cast<int>(mask)), bit), bit);
    }
#endif
    WordPairs(Register v) : v_(v) {}

    Register v_;
};

}  // namespace numbers::lanes
#endif
