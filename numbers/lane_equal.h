#pragma once

#include "numbers/bytes.h"
#include "numbers/lanes.h"

#include <array>
#include <cstdint>

/// Which of a tile's values are equal to one: bit i for value i.
namespace numbers::lanes {

inline std::uint64_t equal(const std::array<std::uint32_t, 64>& values, std::uint32_t to)
{
    std::uint64_t mask = 0;
#if defined(__AVX512F__)
    const __m512i same = _mm512_set1_epi32(static_cast<int>(to));
    for (std::size_t i = 0; i < values.size(); i += 16)
        mask |= std::uint64_t{_mm512_cmpeq_epi32_mask(_mm512_loadu_si512(values.data() + i), same)} << i;
#elif defined(__AVX2__)
    const __m256i same = _mm256_set1_epi32(static_cast<int>(to));
    for (std::size_t i = 0; i < values.size(); i += 8) {
        const __m256i found =
            _mm256_cmpeq_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(values.data() + i)), same);
        mask |= std::uint64_t{bits(_mm256_castsi256_ps(found))} << i;
    }
#else
    const __m128i same = _mm_set1_epi32(static_cast<int>(to));
    for (std::size_t i = 0; i < values.size(); i += 4) {
        const __m128i found =
            _mm_cmpeq_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(values.data() + i)), same);
        mask |= std::uint64_t{bits(_mm_castsi128_ps(found))} << i;
    }
#endif
    return mask;
}

/// Of numbers, aligned.
inline std::uint64_t equal(const std::array<double, 64>& values, double to)
{
    std::uint64_t equal = 0;
    const Double same(to);
    for (int i = 0; i < 64; i += kDoubles)
        equal |= std::uint64_t{mask(Double::load_aligned(values.data() + i) == same)} << i;
    return equal;
}

}  // namespace numbers::lanes
