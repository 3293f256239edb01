#pragma once

#include "numbers/lane_arithmetic.h"
#include "numbers/lanes.h"
#include "numbers/row.h"
#include "render/texture/noise/noise_tables.h"

#include <cstdint>
#include <utility>

/// The lattice noise of generators 1, 2 and of vectors in vector lanes (spec 4, 2.2 to 2.5). A lattice point has a row
/// of four numbers (twelve for vectors); the four parts of a row lie in lanes, or the points do where all are in one
/// cell. Each part is multiplied by the corner's share of the point, then by the row. One order of sums everywhere
/// (corners in pairs along x, then y, then z, then the parts), so every way gives the same bits.
namespace texture {

using numbers::Row;

/// std::clamp(v, 0.0, 1.0), NaN and signs of zero as there. V is double or Double.
template <class V>
inline V clamp01(const V& v)
{
    using numbers::lanes::choose;
    const V zero(0.0), one(1.0);
    return choose(v < zero, zero, choose(one < v, one, v));
}

/// Noise of generator 1 or 2 from the sum over a cell's corners.
template <class V>
inline V noise_of_sum(const V& sum, int generator)
{
    return clamp01(generator == 1 ? V(sum + V(0.5)) : V((sum + V(1.05242)) * V(0.48985582)));
}

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

/// Points that lie on the lattice in y or in z, as those of a terrain or of a picture do: half of their corners have no
/// share, and are left out.
enum class Flat { No, Y, Z };

/// Whether corner c is asked for.
constexpr bool counts(Flat flat, int c) { return flat == Flat::No || (c & (flat == Flat::Y ? 2 : 4)) == 0; }

/// Where the rows of a cell's eight corners start; bit 0 of the index: along x, 1: y, 2: z.
template <Flat F = Flat::No>
[[gnu::always_inline]] inline void corner_rows(const CellIndex& x, const CellIndex& y, const CellIndex& z,
                                               const double* lattice, const double* (&rows)[8])
{
    const auto& t = kNoiseTables.hash;
    const auto& r = kNoiseTables.row;
    const auto at = [&](std::uint32_t i) { return lattice + 4 * std::size_t{r[i]}; };
    const std::uint32_t x0 = t[x.at], x1 = t[x.next];
    const std::uint32_t h00 = t[x0 ^ y.at], h10 = t[x1 ^ y.at];
    rows[0] = at(h00 ^ z.at);
    rows[1] = at(h10 ^ z.at);
    if constexpr (F != Flat::Z) {
        rows[4] = at(h00 ^ z.next);
        rows[5] = at(h10 ^ z.next);
    }
    if constexpr (F == Flat::Y) return;
    const std::uint32_t h01 = t[x0 ^ y.next], h11 = t[x1 ^ y.next];
    rows[2] = at(h01 ^ z.at);
    rows[3] = at(h11 ^ z.at);
    if constexpr (F == Flat::Z) return;
    rows[6] = at(h01 ^ z.next);
    rows[7] = at(h11 ^ z.next);
}

/// The sum of what every corner gives.
template <Flat F = Flat::No, class Of>
inline auto corner_sum(Of&& of)
{
    if constexpr (F == Flat::Y) return (of(0) + of(1)) + (of(4) + of(5));
    else if constexpr (F == Flat::Z) return (of(0) + of(1)) + (of(2) + of(3));
    else return ((of(0) + of(1)) + (of(2) + of(3))) + ((of(4) + of(5)) + (of(6) + of(7)));
}

/// Of a point in its cell: what it has from the low corner (0.5 and the fractions), and the shares of the corners,
/// which stand `Stride` numbers behind each other.
template <int Rows, std::size_t Stride, Flat F = Flat::No>
inline void row_sums(Row low, const double* shares, const double* const (&rows)[8], Row (&sums)[Rows])
{
    const Row high = low - Row::of(0.0, 1.0, 1.0, 1.0);
    Row v[8];
    const auto corner = [&]<int C>() {
        if constexpr (!counts(F, C)) return;
        else if constexpr (C == 0) v[C] = low * Row::all(shares[0]);
        else v[C] = Row::choose<C>(low, high) * Row::all(shares[C * Stride]);
    };
    [&]<int... C>(std::integer_sequence<int, C...>) { (corner.template operator()<C>(), ...); }
    (std::make_integer_sequence<int, 8>());
    for (std::size_t r = 0; r < Rows; ++r)
        sums[r] = corner_sum<F>([&](int c) { return v[c] * Row::load(rows[c] + kNextRow * r); });
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
