#pragma once

#include "render/texture/noise/cells.h"

#include <cstring>

/// Lattice noise in single precision: what is summed over a cell's corners; cells themselves are found in double
/// precision. Every point is alone in its cell. A register holds rows of as many corners as there are quads, lanes of
/// four numbers. One order of sums for all instruction sets: corners that lie one above the other in z, then in y, then
/// in x, then the parts of the row.
namespace texture {

#if defined(__AVX512F__)
using Floats = __m512;
inline Floats floats(const float* p) { return _mm512_load_ps(p); }
inline void put_floats(float* p, Floats v) { _mm512_store_ps(p, v); }
inline Floats all_floats(float v) { return _mm512_set1_ps(v); }
inline std::uint32_t beyond(Floats a, Floats b) { return numbers::lanes::bits(_mm512_cmp_ps_mask(a, b, _CMP_NLE_UQ)); }
inline Floats low_pairs(Floats a, Floats b) { return _mm512_unpacklo_ps(a, b); }
inline Floats high_pairs(Floats a, Floats b) { return _mm512_unpackhi_ps(a, b); }
template <int Order>
inline Floats shuffled(Floats a, Floats b)
{
    return _mm512_shuffle_ps(a, b, Order);
}
inline Floats rounded(const Double& a, const Double& b)
{
    const __m512 low = _mm512_castps256_ps512(_mm512_cvtpd_ps(a.data));
    return _mm512_castpd_ps(_mm512_insertf64x4(_mm512_castps_pd(low), _mm256_castps_pd(_mm512_cvtpd_ps(b.data)), 1));
}
#elif defined(__AVX2__)
using Floats = __m256;
inline Floats floats(const float* p) { return _mm256_load_ps(p); }
inline void put_floats(float* p, Floats v) { _mm256_store_ps(p, v); }
inline Floats all_floats(float v) { return _mm256_set1_ps(v); }
inline std::uint32_t beyond(Floats a, Floats b) { return numbers::lanes::bits(_mm256_cmp_ps(a, b, _CMP_NLE_UQ)); }
inline Floats low_pairs(Floats a, Floats b) { return _mm256_unpacklo_ps(a, b); }
inline Floats high_pairs(Floats a, Floats b) { return _mm256_unpackhi_ps(a, b); }
template <int Order>
inline Floats shuffled(Floats a, Floats b)
{
    return _mm256_shuffle_ps(a, b, Order);
}
inline Floats rounded(const Double& a, const Double& b)
{
    return _mm256_set_m128(_mm256_cvtpd_ps(b.data), _mm256_cvtpd_ps(a.data));
}
#else
using Floats = __m128;
inline Floats floats(const float* p) { return _mm_load_ps(p); }
inline void put_floats(float* p, Floats v) { _mm_store_ps(p, v); }
inline Floats all_floats(float v) { return _mm_set1_ps(v); }
inline std::uint32_t beyond(Floats a, Floats b) { return numbers::lanes::bits(_mm_cmpnle_ps(a, b)); }
inline Floats low_pairs(Floats a, Floats b) { return _mm_unpacklo_ps(a, b); }
inline Floats high_pairs(Floats a, Floats b) { return _mm_unpackhi_ps(a, b); }
template <int Order>
inline Floats shuffled(Floats a, Floats b)
{
    return _mm_shuffle_ps(a, b, Order);
}
inline Floats rounded(const Double& a, const Double& b)
{
    return _mm_movelh_ps(_mm_cvtpd_ps(a.data), _mm_cvtpd_ps(b.data));
}
#endif
inline constexpr std::size_t kSingles = sizeof(Floats) / sizeof(float), kQuads = kSingles / 4;

/// Adds up pairs of parts: of four registers whose quads are points' sums, in four steps of points. What comes out has
/// the points 4 q to 4 q + 3 in quad q.
inline Floats quad_totals(Floats a, Floats b, Floats c, Floats d)
{
    const Floats ab = low_pairs(a, b) + high_pairs(a, b), cd = low_pairs(c, d) + high_pairs(c, d);
    return shuffled<0x44>(ab, cd) + shuffled<0xee>(ab, cd);
}

/// As many points as there are single lanes, in their cells. Point 4 q + j lies in quad q of the j-th.
struct SingleCells {
    alignas(64) std::uint32_t x[kSingles], y[kSingles], z[kSingles], next_y[kSingles], next_z[kSingles];
    alignas(64) float low[4][kSingles];        ///< 0.5 and the fractions
    alignas(64) float shares[2][4][kSingles];  ///< of the corners at the low and at the high z
    std::uint32_t far;                         ///< points, a bit each, out of all cells: their numbers may overflow

    /// The points are those at `first` and, behind them, those at `second`: two vectors of coordinates.
    SingleCells(const double* px, const double* py, const double* pz, std::size_t first, std::size_t second)
    {
        alignas(32) std::uint32_t next_x[kSingles];
        const Floats fx = prepared(px + first, px + second, x, next_x),
                     fy = prepared(py + first, py + second, y, next_y),
                     fz = prepared(pz + first, pz + second, z, next_z), one = all_floats(1.0f);
        far = beyond(fx, one) | beyond(fy, one) | beyond(fz, one);
        const Floats sx = eased(fx), sy = eased(fy), sz = eased(fz), tx = one - sx, ty = one - sy, tz = one - sz;
        const Floats t00 = tx * ty, t10 = sx * ty, t01 = tx * sy, t11 = sx * sy;
        put_quads(all_floats(0.5f), fx, fy, fz, low);
        put_quads(t00 * tz, t10 * tz, t01 * tz, t11 * tz, shares[0]);
        put_quads(t00 * sz, t10 * sz, t01 * sz, t11 * sz, shares[1]);
    }

private:
    static Floats prepared(const double* first, const double* second, std::uint32_t* index, std::uint32_t* next)
    {
        const auto fraction = [&](const double* from, std::size_t to) {
            const Double v = Double::load_aligned(from),
                         moved = xsimd::select(v >= Double(0.0), v, v - Double(kNearlyOne));
            return v - truncated(moved, index + to, next + to);
        };
        return rounded(fraction(first, 0), fraction(second, kLanes));
    }
    static Floats eased(Floats f) { return f * f * (all_floats(3.0f) - all_floats(2.0f) * f); }
    static void put_quads(Floats a, Floats b, Floats c, Floats d, float (*out)[kSingles])
    {
        const Floats ab = low_pairs(a, b), cd = low_pairs(c, d), ab2 = high_pairs(a, b), cd2 = high_pairs(c, d);
        put_floats(out[0], shuffled<0x44>(ab, cd));
        put_floats(out[1], shuffled<0xee>(ab, cd));
        put_floats(out[2], shuffled<0x44>(ab2, cd2));
        put_floats(out[3], shuffled<0xee>(ab2, cd2));
    }
};

/// The rows of a component (0 to 2) begin there.
inline const float* first_single(std::size_t component) { return kNoiseTables.singles[0].data() + 4 * component; }

/// Where the rows of a cell's corners start; bit 0 of the index: along x, 1: y, 2: z. The next component's lie four
/// numbers on.
class SingleRows {
public:
    [[gnu::always_inline]] SingleRows(const SingleCells& c, std::size_t i, const float* first)
        : first_(first), z_{c.z[i], c.next_z[i]}
    {
        const auto& t = kNoiseTables.hash;
        std::uint32_t both;  // the next one lies behind it
        std::memcpy(&both, t.data() + c.x[i], sizeof(both));
        const std::uint32_t x0 = both & 0xffffu, x1 = both >> 16;
        hash_[0] = t[x0 ^ c.y[i]];
        hash_[1] = t[x1 ^ c.y[i]];
        hash_[2] = t[x0 ^ c.next_y[i]];
        hash_[3] = t[x1 ^ c.next_y[i]];
    }
    [[gnu::always_inline]] const float* operator[](std::size_t corner) const
    {
        return first_ + kNoiseTables.single_row[hash_[corner & 3] ^ z_[corner >> 2]];
    }

private:
    const float* first_;
    std::uint32_t hash_[4], z_[2];
};

/// The fractions of point Q of a quad's, from each corner, times the corner's share.
template <std::size_t Q>
struct SingleFactors;

#if defined(__AVX512F__)
template <std::size_t Q>
struct SingleFactors {
    Floats at_low_z, at_high_z;

    [[gnu::always_inline]] SingleFactors(Floats low, Floats shares_low, Floats shares_high)
    {
        constexpr int kQ = 4 * static_cast<int>(Q);
        const __m512i spread =
            _mm512_add_epi32(_mm512_set_epi32(3, 3, 3, 3, 2, 2, 2, 2, 1, 1, 1, 1, 0, 0, 0, 0), _mm512_set1_epi32(kQ));
        const __m512 p = _mm512_shuffle_f32x4(low, low, 0x55 * static_cast<int>(Q));
        at_low_z = (p - _mm512_set_ps(0, 1, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0)) *
                   _mm512_permutexvar_ps(spread, shares_low);
        at_high_z = (p - _mm512_set_ps(1, 1, 1, 0, 1, 1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 0)) *
                    _mm512_permutexvar_ps(spread, shares_high);
    }

    /// The sums of the corners one above the other in z, a quad each.
    [[gnu::always_inline]] Floats sum(const SingleRows& rows, std::size_t component) const
    {
        const auto four = [&](std::size_t c) {
            const auto row = [&](std::size_t k) { return _mm_load_ps(rows[c + k] + 4 * component); };
            __m512 r = _mm512_castps128_ps512(row(0));
            r = _mm512_mask_broadcast_f32x4(r, 0x00f0, row(1));
            r = _mm512_mask_broadcast_f32x4(r, 0x0f00, row(2));
            return _mm512_mask_broadcast_f32x4(r, 0xf000, row(3));
        };
        return at_low_z * four(0) + at_high_z * four(4);
    }

    /// The sums over the corners of three components, a quad each; the fourth is anything.
    [[gnu::always_inline]] Floats three(const SingleRows& rows) const
    {
        const auto corner = [&]<int C>() {
            const __m512 v = C < 4 ? at_low_z : at_high_z;
            return _mm512_shuffle_f32x4(v, v, 0x55 * (C & 3)) * _mm512_load_ps(rows[C]);
        };
        const auto above = [&]<int C>() {
            return corner.template operator()<C>() + corner.template operator()<C + 4>();
        };
        return (above.template operator()<0>() + above.template operator()<2>()) +
               (above.template operator()<1>() + above.template operator()<3>());
    }
};

/// Of four points: their corners' sums in quads become one sum each.
inline Floats joined(Floats a, Floats b, Floats c, Floats d)
{
    const auto halves = [](Floats s, Floats t) {
        return _mm512_shuffle_f32x4(s, t, 0x44) + _mm512_shuffle_f32x4(s, t, 0xee);
    };
    const Floats ab = halves(a, b), cd = halves(c, d);
    return _mm512_shuffle_f32x4(ab, cd, 0x88) + _mm512_shuffle_f32x4(ab, cd, 0xdd);
}
#else
template <std::size_t Q>
struct SingleFactors {
    Floats of[8 / kQuads];  ///< by pairs of corners, or corners

    [[gnu::always_inline]] SingleFactors(Floats low, Floats shares_low, Floats shares_high)
    {
#if defined(__AVX2__)
        constexpr int kQ = 4 * static_cast<int>(Q);
        const __m256 p = _mm256_permute2f128_ps(low, low, Q == 0 ? 0x00 : 0x11);
        const __m256i first = _mm256_set_epi32(kQ + 1, kQ + 1, kQ + 1, kQ + 1, kQ, kQ, kQ, kQ),
                      second = _mm256_add_epi32(first, _mm256_set1_epi32(2));
        const auto pair = [&](float y, float z, __m256 shares, __m256i which) {
            return (p - _mm256_set_ps(z, y, 1, 0, z, y, 0, 0)) * _mm256_permutevar8x32_ps(shares, which);
        };
        of[0] = pair(0, 0, shares_low, first);
        of[1] = pair(1, 0, shares_low, second);
        of[2] = pair(0, 1, shares_high, first);
        of[3] = pair(1, 1, shares_high, second);
#else
        const auto corner = [&](float x, float y, float z, Floats share) {
            return (low - _mm_set_ps(z, y, x, 0)) * share;
        };
        of[0] = corner(0, 0, 0, shuffled<0x00>(shares_low, shares_low));
        of[1] = corner(1, 0, 0, shuffled<0x55>(shares_low, shares_low));
        of[2] = corner(0, 1, 0, shuffled<0xaa>(shares_low, shares_low));
        of[3] = corner(1, 1, 0, shuffled<0xff>(shares_low, shares_low));
        of[4] = corner(0, 0, 1, shuffled<0x00>(shares_high, shares_high));
        of[5] = corner(1, 0, 1, shuffled<0x55>(shares_high, shares_high));
        of[6] = corner(0, 1, 1, shuffled<0xaa>(shares_high, shares_high));
        of[7] = corner(1, 1, 1, shuffled<0xff>(shares_high, shares_high));
#endif
    }

    /// The sums of the corners at the low and at the high x, a quad each; or of all of them.
    [[gnu::always_inline]] Floats sum(const SingleRows& rows, std::size_t component) const
    {
        const auto row = [&](std::size_t c) { return _mm_load_ps(rows[c] + 4 * component); };
#if defined(__AVX2__)
        const auto term = [&](std::size_t i) { return of[i] * _mm256_set_m128(row(2 * i + 1), row(2 * i)); };
        return (term(0) + term(2)) + (term(1) + term(3));
#else
        const auto above = [&](std::size_t c) { return of[c] * row(c) + of[c + 4] * row(c + 4); };
        return (above(0) + above(2)) + (above(1) + above(3));
#endif
    }
};

/// Of as many points as there are quads: their sums in quads become one each.
#if defined(__AVX2__)
inline Floats joined(Floats a, Floats b)
{
    return _mm256_permute2f128_ps(a, b, 0x20) + _mm256_permute2f128_ps(a, b, 0x31);
}
#else
inline Floats joined(Floats a) { return a; }
#endif
#endif

}  // namespace texture
