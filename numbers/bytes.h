#pragma once

#include "numbers/instructions.h"

#include <cstddef>
#include <cstdint>

/// Many bytes at a time, in registers that every processor of the kind has.
namespace numbers::lanes {

/// Which of 64 bytes are `to`: bit i for byte i.
inline std::uint64_t equal(const std::uint8_t* values, std::uint8_t to)
{
    const __m128i same = _mm_set1_epi8(static_cast<char>(to));
    std::uint64_t mask = 0;
    for (std::size_t i = 0; i < 64; i += 16) {
        const __m128i found = _mm_cmpeq_epi8(_mm_loadu_si128(reinterpret_cast<const __m128i*>(values + i)), same);
        mask |= std::uint64_t{static_cast<std::uint32_t>(_mm_movemask_epi8(found))} << i;
    }
    return mask;
}

/// Of 16 bytes, aligned: take(bit, mask of the bytes that have it), the highest bit first.
template <class F>
inline void each_bit(const std::uint8_t* values, F&& take)
{
    __m128i bytes = _mm_load_si128(reinterpret_cast<const __m128i*>(values));
    for (std::size_t bit = 8; bit-- > 0; bytes = _mm_add_epi8(bytes, bytes))
        take(bit, static_cast<std::uint32_t>(_mm_movemask_epi8(bytes)));
}

}  // namespace numbers::lanes
