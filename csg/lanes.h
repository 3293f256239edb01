#pragma once

#include <xsimd/xsimd.hpp>

#include <cstdint>

/// The vector unit of the instruction set that this file is compiled for. Include only from code that is compiled once
/// per instruction set: sizes differ.
namespace csg::lanes {

using Double = xsimd::batch<double>;
inline constexpr int kDoubles = static_cast<int>(Double::size);

#if defined(__AVX__)
using FloatPart = xsimd::make_sized_batch_t<float, 8>;
inline constexpr int kFloatParts = 1;
#else
using FloatPart = xsimd::make_sized_batch_t<float, 4>;
inline constexpr int kFloatParts = 2;
#endif
inline constexpr int kFloatPart = static_cast<int>(FloatPart::size);

// xsimd 8 has no mask of a batch_bool; one overload a register type.
inline std::uint32_t bits(__m128 r) { return static_cast<std::uint32_t>(_mm_movemask_ps(r)); }
inline std::uint32_t bits(__m128d r) { return static_cast<std::uint32_t>(_mm_movemask_pd(r)); }
#if defined(__AVX__)
inline std::uint32_t bits(__m256 r) { return static_cast<std::uint32_t>(_mm256_movemask_ps(r)); }
inline std::uint32_t bits(__m256d r) { return static_cast<std::uint32_t>(_mm256_movemask_pd(r)); }
#endif
#if defined(__AVX512F__)
inline std::uint32_t bits(__mmask8 r) { return r; }
inline std::uint32_t bits(__mmask16 r) { return r; }
#endif

/// Bit i: lane i.
template <class Bool>
inline std::uint32_t mask(const Bool& b)
{
    return bits(b.data);
}

}  // namespace csg::lanes
