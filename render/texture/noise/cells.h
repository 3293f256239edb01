#pragma once

#include "render/texture/noise/lattice.h"
#include "render/texture/points/point_lanes.h"

#include <algorithm>

/// The sums of lattice noise for as many points as there are lanes.
namespace texture {

/// Toward zero to 32 bits and back; out of range and NaN give the least integer. `index`, `next`: the numbers of the
/// cells and of those behind them.
inline Double truncated(const Double& v, std::uint32_t* index, std::uint32_t* next)
{
#if defined(__AVX512F__)
    const __m256i i = _mm512_cvttpd_epi32(v.data), mask = _mm256_set1_epi32(kLatticeMask),
                  at = _mm256_add_epi32(i, _mm256_set1_epi32(kCellOffset)),
                  behind = _mm256_add_epi32(i, _mm256_set1_epi32(kCellOffset + 1));
    _mm256_store_si256(reinterpret_cast<__m256i*>(index), _mm256_and_si256(at, mask));
    _mm256_store_si256(reinterpret_cast<__m256i*>(next), _mm256_and_si256(behind, mask));
    return Double(_mm512_cvtepi32_pd(i));
#else
#if defined(__AVX__)
    const __m128i i = _mm256_cvttpd_epi32(v.data);
#else
    const __m128i i = _mm_cvttpd_epi32(v.data);
#endif
    const __m128i mask = _mm_set1_epi32(kLatticeMask),
                  at = _mm_and_si128(_mm_add_epi32(i, _mm_set1_epi32(kCellOffset)), mask),
                  behind = _mm_and_si128(_mm_add_epi32(i, _mm_set1_epi32(kCellOffset + 1)), mask);
#if defined(__AVX__)
    _mm_store_si128(reinterpret_cast<__m128i*>(index), at);
    _mm_store_si128(reinterpret_cast<__m128i*>(next), behind);
    return Double(_mm256_cvtepi32_pd(i));
#else
    _mm_storel_epi64(reinterpret_cast<__m128i*>(index), at);
    _mm_storel_epi64(reinterpret_cast<__m128i*>(next), behind);
    return Double(_mm_cvtepi32_pd(i));
#endif
#endif
}

/// One coordinate of as many points as there are lanes, in their cells.
struct Axis {
    Double fraction, weight;
    alignas(32) std::uint32_t index[kLanes], next[kLanes];

    CellIndex cell(std::size_t k) const { return {index[k], next[k]}; }

    /// True if all are in one cell.
    bool prepare(const Double& v)
    {
        const Double zero(0.0);
        const Double moved = xsimd::select(v >= zero, v, v - Double(kNearlyOne));
        const Double whole = truncated(moved, index, next);
        fraction = v - whole;
        weight = smooth(fraction);
        alignas(64) double cells[kLanes];
        whole.store_aligned(cells);
        return numbers::lanes::mask(whole == Double(cells[0])) == (1u << kLanes) - 1;
    }
};

/// The three of some points, in one place: a loop over points then has one base.
struct Axes {
    Axis x, y, z;

    /// True if all points are in one cell.
    bool prepare(const Double& px, const Double& py, const Double& pz)
    {
        const bool in_x = x.prepare(px), in_y = y.prepare(py), in_z = z.prepare(pz);
        return in_x && in_y && in_z;
    }

    /// How all points lie; none is out of all cells then, where shares may be endless.
    Flat flat() const
    {
        const Double zero(0.0), one(1.0), farthest = xsimd::max(xsimd::abs(x.fraction), one);
        const auto lie = [&](const Axis& on, const Axis& other) {
            return xsimd::all((on.fraction == zero) & (xsimd::max(farthest, xsimd::abs(other.fraction)) == one));
        };
        return lie(y, z) ? Flat::Y : lie(z, y) ? Flat::Z : Flat::No;
    }
};

/// The sums of points in one cell: points in lanes, rows broadcast.
template <int Rows, Flat F = Flat::No>
[[gnu::always_inline]] inline void shared_cell(const Axes& at, const double* lattice, double* const (&out)[Rows])
{
    const double* rows[8];
    corner_rows<F>(at.x.cell(0), at.y.cell(0), at.z.cell(0), lattice, rows);
    Double shares[8], sums[4][Rows];
    corner_shares(at.x.weight, at.y.weight, at.z.weight, [&](int c, const Double& share) { shares[c] = share; });
    const auto part = [&](std::size_t k, const auto& factor) {
        Double v[8];
        for (int c = 0; c < 8; ++c)
            if (counts(F, c)) v[c] = factor(c) * shares[c];
        for (std::size_t r = 0; r < Rows; ++r)
            sums[k][r] = corner_sum<F>([&](int c) { return v[c] * Double(rows[c][kNextRow * r + k]); });
    };
    const Double one(1.0), half(0.5), fx = at.x.fraction, fy = at.y.fraction, fz = at.z.fraction, gx = fx - one,
                                      gy = fy - one, gz = fz - one;
    part(0, [&](int) { return half; });
    part(1, [&](int c) { return (c & 1) != 0 ? gx : fx; });
    part(2, [&](int c) { return (c & 2) != 0 ? gy : fy; });
    part(3, [&](int c) { return (c & 4) != 0 ? gz : fz; });
    for (int r = 0; r < Rows; ++r) ((sums[0][r] + sums[1][r]) + (sums[2][r] + sums[3][r])).store_aligned(out[r]);
}

#if defined(__AVX512F__)
/// Points in cells of their own, where a register holds two rows: those of the corners at the low and at the high z.
/// What one point needs stands in one place.
struct OwnCells {
    alignas(64) double shares[kLanes][8];
    alignas(64) double low[kLanes][4];  ///< 0.5 and the fractions

    [[gnu::always_inline]] OwnCells(const Axes& at)
    {
        __m512d s[8];
        corner_shares(at.x.weight, at.y.weight, at.z.weight, [&](int c, const Double& share) { s[c] = share.data; });
        each_two(_mm512_set1_pd(0.5), at.x.fraction.data, at.y.fraction.data, at.z.fraction.data,
                 [&](std::size_t k, __m512d two) {
                     _mm256_store_pd(low[k], _mm512_castpd512_pd256(two));
                     _mm256_store_pd(low[k + 2], _mm512_extractf64x4_pd(two, 1));
                 });
        __m512d in_low_z[kLanes];
        each_two(s[0], s[1], s[2], s[3], [&](std::size_t k, __m512d two) { in_low_z[k] = two; });
        // Stored whole: parts that are stored one by one can't be loaded whole before they have left the pipeline.
        each_two(s[4], s[5], s[6], s[7], [&](std::size_t k, __m512d two) {
            _mm512_store_pd(shares[k], _mm512_shuffle_f64x2(in_low_z[k], two, 0x44));
            _mm512_store_pd(shares[k + 2], _mm512_shuffle_f64x2(in_low_z[k], two, 0xee));
        });
    }

    /// The sum of every row at point k.
    template <int Rows, Flat F>
    [[gnu::always_inline]] void sum(std::size_t k, const double* const (&rows)[8], Row (&sums)[Rows]) const
    {
        if constexpr (F == Flat::Z) return row_sums<Rows, 1, F>({_mm256_load_pd(low[k])}, shares[k], rows, sums);
        const __m512d p = _mm512_broadcast_f64x4(_mm256_load_pd(low[k])), share = _mm512_load_pd(shares[k]);
        // The fractions from the corner, part by part of the row: x, y and, in the high half, z less one.
        const __m512d v0 = (p - _mm512_set_pd(1, 0, 0, 0, 0, 0, 0, 0)) * _mm512_permutex_pd(share, 0x00),
                      v1 = (p - _mm512_set_pd(1, 0, 1, 0, 0, 0, 1, 0)) * _mm512_permutex_pd(share, 0x55),
                      v2 = (p - _mm512_set_pd(1, 1, 0, 0, 0, 1, 0, 0)) * _mm512_permutex_pd(share, 0xaa),
                      v3 = (p - _mm512_set_pd(1, 1, 1, 0, 0, 1, 1, 0)) * _mm512_permutex_pd(share, 0xff);
        for (int r = 0; r < Rows; ++r) {
            const auto both = [&](int c) {
                const std::size_t row = kNextRow * static_cast<std::size_t>(r);
                return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_load_pd(rows[c] + row)),
                                          _mm256_load_pd(rows[c + 4] + row), 1);
            };
            __m512d total = v0 * both(0) + v1 * both(1);
            if constexpr (F == Flat::No) total = total + (v2 * both(2) + v3 * both(3));
            sums[r].v = _mm512_castpd512_pd256(total) + _mm512_extractf64x4_pd(total, 1);
        }
    }

private:
    /// Calls put(k, lanes k of a, b, c, d and lanes k + 2 of them).
    template <class Put>
    [[gnu::always_inline]] static void each_two(__m512d a, __m512d b, __m512d c, __m512d d, const Put& put)
    {
        const __m512i first = _mm512_set_epi64(11, 10, 3, 2, 9, 8, 1, 0),
                      second = _mm512_set_epi64(15, 14, 7, 6, 13, 12, 5, 4);
        const __m512d even_ab = _mm512_unpacklo_pd(a, b), even_cd = _mm512_unpacklo_pd(c, d),
                      odd_ab = _mm512_unpackhi_pd(a, b), odd_cd = _mm512_unpackhi_pd(c, d);
        put(0, _mm512_permutex2var_pd(even_ab, first, even_cd));
        put(4, _mm512_permutex2var_pd(even_ab, second, even_cd));
        put(1, _mm512_permutex2var_pd(odd_ab, first, odd_cd));
        put(5, _mm512_permutex2var_pd(odd_ab, second, odd_cd));
    }
};
#else
/// Points in cells of their own: a row's parts lie in a register.
struct OwnCells {
    alignas(64) double f[3][kLanes], shares[8][kLanes];

    [[gnu::always_inline]] OwnCells(const Axes& at)
    {
        at.x.fraction.store_aligned(f[0]);
        at.y.fraction.store_aligned(f[1]);
        at.z.fraction.store_aligned(f[2]);
        corner_shares(at.x.weight, at.y.weight, at.z.weight,
                      [&](int c, const Double& share) { share.store_aligned(shares[c]); });
    }

    /// The sum of every row at point k.
    template <int Rows, Flat F>
    [[gnu::always_inline]] void sum(std::size_t k, const double* const (&rows)[8], Row (&sums)[Rows]) const
    {
        row_sums<Rows, kLanes, F>(Row::of(0.5, f[0][k], f[1][k], f[2][k]), shares[0] + k, rows, sums);
    }
};
#endif

/// Each point in its own cell: parts in lanes.
template <int Rows, Flat F = Flat::No>
[[gnu::always_inline]] inline void own_cells(const Axes& at, std::size_t count, const double* lattice,
                                             double* const (&out)[Rows])
{
    const OwnCells cells(at);
    Row sums[Rows][kLanes];
    for (std::size_t i = 0; i < count; ++i) {
        const double* rows[8];
        corner_rows<F>(at.x.cell(i), at.y.cell(i), at.z.cell(i), lattice, rows);
        Row s[Rows];
        cells.sum<Rows, F>(i, rows, s);
        for (int r = 0; r < Rows; ++r) sums[r][i] = s[r];
    }
    for (int r = 0; r < Rows; ++r)
        for (std::size_t i = 0; i < kLanes; i += Row::kAtOnce) Row::store_totals(sums[r] + i, out[r] + i);
}

}  // namespace texture
