#pragma once

#include "csg/lanes.h"
#include "render/texture/noise_tables.h"

#include <cstdint>

/// The lattice noise of generators 1, 2 and of vectors in vector lanes (spec 4, 2.2 to 2.5). A lattice point has a row of
/// four numbers (twelve for vectors); the four parts of a row lie in lanes, or the points do where all are in one cell.
/// One order of sums everywhere (corners along x, then y, then z, then the parts), so every way gives the same bits.
/// Compiled once per instruction set.
namespace texture {

/// Four doubles, whatever the instruction set.
struct Row {
#if defined(__AVX__)
    __m256d v;
    static Row load(const double* p) { return {_mm256_loadu_pd(p)}; }
    static Row all(double a) { return {_mm256_set1_pd(a)}; }
    static Row of(double a, double b, double c, double d) { return {_mm256_set_pd(d, c, b, a)}; }
    friend Row operator+(Row a, Row b) { return {_mm256_add_pd(a.v, b.v)}; }
    friend Row operator-(Row a, Row b) { return {_mm256_sub_pd(a.v, b.v)}; }
    friend Row operator*(Row a, Row b) { return {_mm256_mul_pd(a.v, b.v)}; }
    __m128d low() const { return _mm256_castpd256_pd128(v); }
    __m128d high() const { return _mm256_extractf128_pd(v, 1); }
#else
    __m128d l, h;
    static Row load(const double* p) { return {_mm_loadu_pd(p), _mm_loadu_pd(p + 2)}; }
    static Row all(double a) { return {_mm_set1_pd(a), _mm_set1_pd(a)}; }
    static Row of(double a, double b, double c, double d) { return {_mm_set_pd(b, a), _mm_set_pd(d, c)}; }
    friend Row operator+(Row a, Row b) { return {_mm_add_pd(a.l, b.l), _mm_add_pd(a.h, b.h)}; }
    friend Row operator-(Row a, Row b) { return {_mm_sub_pd(a.l, b.l), _mm_sub_pd(a.h, b.h)}; }
    friend Row operator*(Row a, Row b) { return {_mm_mul_pd(a.l, b.l), _mm_mul_pd(a.h, b.h)}; }
    __m128d low() const { return l; }
    __m128d high() const { return h; }
#endif
    /// (0 + 1) + (2 + 3)
    double total() const
    {
        const __m128d pairs = _mm_add_pd(_mm_unpacklo_pd(low(), high()), _mm_unpackhi_pd(low(), high()));
        return _mm_cvtsd_f64(_mm_add_sd(pairs, _mm_unpackhi_pd(pairs, pairs)));
    }
};

inline constexpr double kNearlyOne = 1.0 - 1e-10;   ///< cells of negative coordinates (spec 4, 2.2)
inline constexpr int kLatticeMask = NoiseTables::kHashSize - 1;
inline constexpr int kCellOffset = 10000;     ///< added to a cell's number before the mask

/// 3 f^2 - 2 f^3
template <class T>
inline T smooth(const T& f)
{
    return f * f * (T(3.0) - T(2.0) * f);
}

/// Where the rows of a cell's eight corners start; bit 0 of the index: along x, 1: y, 2: z.
inline void corner_rows(std::uint32_t x, std::uint32_t y, std::uint32_t z, const double* lattice, const double* (&rows)[8])
{
    const auto& t = kNoiseTables.hash;
    const auto& r = kNoiseTables.row;
    const auto next = [](std::uint32_t i) { return (i + 1) & static_cast<std::uint32_t>(kLatticeMask); };
    const std::uint32_t x0 = t[x], x1 = t[next(x)], y1 = next(y), z1 = next(z);
    const std::uint32_t h00 = t[x0 ^ y], h10 = t[x1 ^ y], h01 = t[x0 ^ y1], h11 = t[x1 ^ y1];
    rows[0] = lattice + r[h00 ^ z];
    rows[1] = lattice + r[h10 ^ z];
    rows[2] = lattice + r[h01 ^ z];
    rows[3] = lattice + r[h11 ^ z];
    rows[4] = lattice + r[h00 ^ z1];
    rows[5] = lattice + r[h10 ^ z1];
    rows[6] = lattice + r[h01 ^ z1];
    rows[7] = lattice + r[h11 ^ z1];
}

/// A point in its cell: fractions and their weights.
struct LatticePoint {
    double fx, fy, fz, sx, sy, sz;
};

/// `Rows` sums over a cell's corners; their rows stand four numbers behind each other.
template <int Rows>
inline void row_sums(const LatticePoint& p, const double* const (&rows)[8], double (&sums)[Rows])
{
    const Row low = Row::of(0.5, p.fx, p.fy, p.fz);
    const Row x1 = Row::of(0.0, 1.0, 0.0, 0.0), y1 = Row::of(0.0, 0.0, 1.0, 0.0), z1 = Row::of(0.0, 0.0, 0.0, 1.0);
    const Row c1 = low - x1, c2 = low - y1, c3 = c1 - y1, c4 = low - z1, c5 = c1 - z1, c6 = c2 - z1, c7 = c3 - z1;
    const Row sx = Row::all(p.sx), sy = Row::all(p.sy), sz = Row::all(p.sz), one = Row::all(1.0);
    const Row tx = one - sx, ty = one - sy, tz = one - sz;
    for (int r = 0; r < Rows; ++r) {
        const int o = 4 * r;
        const Row a = low * Row::load(rows[0] + o) * tx + c1 * Row::load(rows[1] + o) * sx;
        const Row b = c2 * Row::load(rows[2] + o) * tx + c3 * Row::load(rows[3] + o) * sx;
        const Row c = c4 * Row::load(rows[4] + o) * tx + c5 * Row::load(rows[5] + o) * sx;
        const Row d = c6 * Row::load(rows[6] + o) * tx + c7 * Row::load(rows[7] + o) * sx;
        sums[r] = ((a * ty + b * sy) * tz + (c * ty + d * sy) * sz).total();
    }
}

}  // namespace texture
