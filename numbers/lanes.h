#pragma once

#include "numbers/instructions.h"

#include <xsimd/xsimd.hpp>

#include <array>
#include <bit>
#include <cstdint>

/// The vector unit of the instruction set that this file is compiled for. Code for different ones may share nothing
/// that has it in its interface: sizes differ.
namespace numbers::lanes {

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

// xsimd 8, Debian 12's, has other names for these two than later ones.
#if XSIMD_VERSION_MAJOR == 8
template <class To, class From>
inline To same_bits(const From& v)
{
    return xsimd::bitwise_cast<To>(v);
}
template <class Batch>
inline auto sum(const Batch& v)
{
    return xsimd::hadd(v);
}
#else
template <class To, class From>
inline To same_bits(const From& v)
{
    return xsimd::bitwise_cast<typename To::value_type>(v);
}
template <class Batch>
inline auto sum(const Batch& v)
{
    return xsimd::reduce_add(v);
}
#endif

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

/// The lanes of a mask; bits beyond them are ignored.
inline Double::batch_bool_type lanes_of(std::uint32_t mask)
{
#if defined(__AVX512F__)
    return Double::batch_bool_type(static_cast<__mmask8>(mask));
#else
    constexpr std::uint32_t kMasks = 1u << kDoubles;
    struct Table {
        alignas(64) std::array<std::array<double, kDoubles>, kMasks> rows{};
        constexpr Table()
        {
            for (std::uint32_t m = 0; m < kMasks; ++m)
                for (std::size_t lane = 0; lane < kDoubles; ++lane)
                    rows[m][lane] = std::bit_cast<double>((m >> lane & 1u) != 0 ? ~std::uint64_t{0} : std::uint64_t{0});
        }
    };
    static constexpr Table kTable;
    return Double::batch_bool_type(Double::load_aligned(kTable.rows[mask & (kMasks - 1)].data()).data);
#endif
}

/// Numbers out of a table, by their places.
inline Double gathered(const double* from, const xsimd::batch<std::uint64_t>& at)
{
#if defined(__AVX512F__)
    return Double(_mm512_i64gather_pd(at.data, from, sizeof(double)));
#elif defined(__AVX2__)
    return Double(_mm256_i64gather_pd(from, at.data, sizeof(double)));
#else
    alignas(64) std::array<std::uint64_t, static_cast<std::size_t>(kDoubles)> places;
    alignas(64) std::array<double, static_cast<std::size_t>(kDoubles)> out;
    at.store_aligned(places.data());
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = from[places[k]];
    return Double::load_aligned(out.data());
#endif
}

}  // namespace numbers::lanes
