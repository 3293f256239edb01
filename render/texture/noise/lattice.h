#pragma once

#include "numbers/lanes.h"
#include "render/texture/noise/noise_tables.h"

#include <cstdint>

/// The lattice noise of generators 1, 2 and of vectors in vector lanes (spec 4, 2.2 to 2.5). A lattice point has a row
/// of four numbers (twelve for vectors); the four parts of a row lie in lanes, or the points do where all are in one
/// cell. Each part is multiplied by the corner's share of the point, then by the row. One order of sums everywhere
/// (corners in pairs along x, then y, then z, then the parts), so every way gives the same bits. Compiled once per
/// instruction set.
namespace texture {

/// Four doubles, whatever the instruction set.
struct Row {
#if defined(__AVX__)
    __m256d v;
    static Row load(const double* p) { return {_mm256_load_pd(p)}; }
    static Row all(double a) { return {_mm256_set1_pd(a)}; }
    static Row of(double a, double b, double c, double d) { return {_mm256_set_pd(d, c, b, a)}; }
    friend Row operator+(Row a, Row b) { return {_mm256_add_pd(a.v, b.v)}; }
    friend Row operator-(Row a, Row b) { return {_mm256_sub_pd(a.v, b.v)}; }
    friend Row operator*(Row a, Row b) { return {_mm256_mul_pd(a.v, b.v)}; }
    /// Lane i + 1 of `b` where bit i is set, otherwise that of `a`.
    template <int Bits>
    static Row choose(Row a, Row b)
    {
        return {_mm256_blend_pd(a.v, b.v, Bits << 1)};
    }
    __m128d low() const { return _mm256_castpd256_pd128(v); }
    __m128d high() const { return _mm256_extractf128_pd(v, 1); }

    /// The totals of so many rows at once.
    static constexpr std::size_t kAtOnce = 4;
    static void store_totals(const Row* rows, double* out)
    {
        const auto pairs = [](Row a, Row b) {
            return _mm256_add_pd(_mm256_unpacklo_pd(a.v, b.v), _mm256_unpackhi_pd(a.v, b.v));
        };
        const __m256d a = pairs(rows[0], rows[1]), b = pairs(rows[2], rows[3]);
        _mm256_store_pd(out, _mm256_add_pd(_mm256_permute2f128_pd(a, b, 0x20), _mm256_permute2f128_pd(a, b, 0x31)));
    }
#else
    __m128d l, h;
    static Row load(const double* p) { return {_mm_load_pd(p), _mm_load_pd(p + 2)}; }
    static Row all(double a) { return {_mm_set1_pd(a), _mm_set1_pd(a)}; }
    static Row of(double a, double b, double c, double d) { return {_mm_set_pd(b, a), _mm_set_pd(d, c)}; }
    friend Row operator+(Row a, Row b) { return {_mm_add_pd(a.l, b.l), _mm_add_pd(a.h, b.h)}; }
    friend Row operator-(Row a, Row b) { return {_mm_sub_pd(a.l, b.l), _mm_sub_pd(a.h, b.h)}; }
    friend Row operator*(Row a, Row b) { return {_mm_mul_pd(a.l, b.l), _mm_mul_pd(a.h, b.h)}; }
    template <int Bits>
    static Row choose(Row a, Row b)
    {
        return {two<0, (Bits & 1)>(a.l, b.l), two<((Bits >> 1) & 1), (Bits >> 2)>(a.h, b.h)};
    }
    template <int First, int Second>
    static __m128d two(__m128d a, __m128d b)
    {
        return _mm_shuffle_pd(First != 0 ? b : a, Second != 0 ? b : a, 2);
    }
    __m128d low() const { return l; }
    __m128d high() const { return h; }

    static constexpr std::size_t kAtOnce = 2;
    static void store_totals(const Row* rows, double* out)
    {
        const auto pairs = [](Row a) { return _mm_add_pd(_mm_unpacklo_pd(a.l, a.h), _mm_unpackhi_pd(a.l, a.h)); };
        const __m128d a = pairs(rows[0]), b = pairs(rows[1]);
        _mm_store_pd(out, _mm_add_pd(_mm_unpacklo_pd(a, b), _mm_unpackhi_pd(a, b)));
    }
#endif
    /// (0 + 1) + (2 + 3)
    double total() const
    {
        const __m128d pairs = _mm_add_pd(_mm_unpacklo_pd(low(), high()), _mm_unpackhi_pd(low(), high()));
        return _mm_cvtsd_f64(_mm_add_sd(pairs, _mm_unpackhi_pd(pairs, pairs)));
    }
};

inline constexpr double kNearlyOne = 1.0 - 1e-10;  ///< cells of negative coordinates (spec 4, 2.2)
inline constexpr int kLatticeMask = NoiseTables::kHashSize - 1;
inline constexpr int kCellOffset = 10000;  ///< added to a cell's number before the mask

/// 3 f^2 - 2 f^3
template <class T>
inline T smooth(const T& f)
{
    return f * f * (T(3.0) - T(2.0) * f);
}

/// Of vectors, the next component's row lies so many numbers on: components are four numbers apart.
inline constexpr std::size_t kNextRow = 4 * 4;

/// The rows of the first component wanted.
inline const double* first_row(std::size_t component) { return kNoiseTables.lattice[4 * component].data(); }

/// A coordinate of a cell and of the next one.
struct CellIndex {
    std::uint32_t at, next;
};

/// Where the rows of a cell's eight corners start; bit 0 of the index: along x, 1: y, 2: z.
[[gnu::always_inline]] inline void corner_rows(const CellIndex& x, const CellIndex& y, const CellIndex& z,
                                               const double* lattice, const double* (&rows)[8])
{
    const auto& t = kNoiseTables.hash;
    const auto& r = kNoiseTables.row;
    const auto at = [&](std::uint32_t i) { return lattice + 4 * std::size_t{r[i]}; };
    const std::uint32_t x0 = t[x.at], x1 = t[x.next];
    const std::uint32_t h00 = t[x0 ^ y.at], h10 = t[x1 ^ y.at], h01 = t[x0 ^ y.next], h11 = t[x1 ^ y.next];
    rows[0] = at(h00 ^ z.at);
    rows[1] = at(h10 ^ z.at);
    rows[2] = at(h01 ^ z.at);
    rows[3] = at(h11 ^ z.at);
    rows[4] = at(h00 ^ z.next);
    rows[5] = at(h10 ^ z.next);
    rows[6] = at(h01 ^ z.next);
    rows[7] = at(h11 ^ z.next);
}

/// The sum of what every corner gives.
template <class Of>
inline auto corner_sum(Of&& of)
{
    return ((of(0) + of(1)) + (of(2) + of(3))) + ((of(4) + of(5)) + (of(6) + of(7)));
}

/// Of a point in its cell: what it has from the low corner (0.5 and the fractions), and the shares of the corners,
/// which stand `Stride` numbers behind each other.
template <int Rows, std::size_t Stride>
inline void row_sums(Row low, const double* shares, const double* const (&rows)[8], Row (&sums)[Rows])
{
    const Row high = low - Row::of(0.0, 1.0, 1.0, 1.0);
    const Row v[8] = {low * Row::all(shares[0]),
                      Row::choose<1>(low, high) * Row::all(shares[Stride]),
                      Row::choose<2>(low, high) * Row::all(shares[2 * Stride]),
                      Row::choose<3>(low, high) * Row::all(shares[3 * Stride]),
                      Row::choose<4>(low, high) * Row::all(shares[4 * Stride]),
                      Row::choose<5>(low, high) * Row::all(shares[5 * Stride]),
                      Row::choose<6>(low, high) * Row::all(shares[6 * Stride]),
                      Row::choose<7>(low, high) * Row::all(shares[7 * Stride])};
    for (std::size_t r = 0; r < Rows; ++r)
        sums[r] = corner_sum([&](int c) { return v[c] * Row::load(rows[c] + kNextRow * r); });
}

/// The share that each corner has of a point with these weights.
template <class T, class Put>
inline void corner_shares(const T& sx, const T& sy, const T& sz, Put&& put)
{
    const T one(1.0), tx = one - sx, ty = one - sy, tz = one - sz;
    const T t00 = tx * ty, t10 = sx * ty, t01 = tx * sy, t11 = sx * sy;
    put(0, t00 * tz);
    put(1, t10 * tz);
    put(2, t01 * tz);
    put(3, t11 * tz);
    put(4, t00 * sz);
    put(5, t10 * sz);
    put(6, t01 * sz);
    put(7, t11 * sz);
}

}  // namespace texture
