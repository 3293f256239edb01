#pragma once

#include "numbers/lanes.h"

#include <array>
#include <cstdint>

/// Numbers of some lanes put one behind the other.
namespace numbers {

#if defined(__AVX2__)
/// By lanes: a byte each for the lanes to take from, the first in the lowest.
struct PackTable {
    std::array<std::uint64_t, 256> from{};
    constexpr PackTable()
    {
        for (std::uint32_t set = 0; set < 256; ++set)
            for (std::uint32_t lane = 0, to = 0; lane < 8; ++lane)
                if ((set >> lane & 1u) != 0) from[set] |= std::uint64_t{lane} << 8 * to++;
    }
};
inline constexpr PackTable kPackTable;
inline __m256i packed_from(std::uint32_t lanes)
{
    return _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(kPackTable.from[lanes])));
}
#endif

/// Writes the distances of those of eight lanes whose bits are set, in their order, and may write anything up to the
/// eighth place. \return how many there are
inline std::size_t pack(std::uint32_t lanes, const float* distances, float* out)
{
#if defined(__AVX2__)
    _mm256_storeu_ps(out, _mm256_permutevar8x32_ps(_mm256_loadu_ps(distances), packed_from(lanes)));
    return static_cast<std::size_t>(_mm_popcnt_u32(lanes));
#else
    std::size_t count = 0;
    for (std::size_t k = 0; k < 8; ++k) {
        out[count] = distances[k];
        count += lanes >> k & 1u;
    }
    return count;
#endif
}

/// The same for distances and numbers.
inline std::size_t pack(std::uint32_t lanes, const float* distances, const std::uint32_t* numbers, float* distance_out,
                        std::uint32_t* number_out)
{
#if defined(__AVX2__)
    const __m256i from = packed_from(lanes);
    _mm256_storeu_ps(distance_out, _mm256_permutevar8x32_ps(_mm256_loadu_ps(distances), from));
    _mm256_storeu_si256(
        reinterpret_cast<__m256i*>(number_out),
        _mm256_permutevar8x32_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers)), from));
    return static_cast<std::size_t>(_mm_popcnt_u32(lanes));
#else
    std::size_t count = 0;
    for (std::size_t k = 0; k < 8; ++k) {
        distance_out[count] = distances[k];
        number_out[count] = numbers[k];
        count += lanes >> k & 1u;
    }
    return count;
#endif
}

}  // namespace numbers
