#pragma once

#include <array>
#include <cstddef>
#include <cstring>

/// A polynomial's coefficients, or its Bernstein ordinates over a range (Farin, Curves and Surfaces for CAGD, 4).
namespace csg {

inline constexpr int kMostRowDegree = 15;  ///< of those with ordinates

/// 1 / (k of n)
inline constexpr auto kRowShares = [] {
    std::array<std::array<double, kMostRowDegree + 1>, kMostRowDegree + 1> out{};
    for (std::size_t n = 0; n < out.size(); ++n) {
        double ways = 1.0;
        for (std::size_t k = 0; k <= n; ++k) {
            out[n][k] = 1.0 / ways;
            ways = ways * static_cast<double>(n - k) / static_cast<double>(k + 1);
        }
    }
    return out;
}();

using EightNumbers [[gnu::vector_size(64)]] = double;

/// Of one ray, side by side in vectors of eight: an operation on all of them is one a vector, and none has to wait for
/// its neighbour through memory. Lanes behind the degree are multiplied along.
template <int blocks>
struct PolynomialRow {
    using Number = double;
    static constexpr int kSize = 8 * blocks;
    EightNumbers v[blocks];

    PolynomialRow() : v{} {}
    [[gnu::always_inline]] void clear()
    {
        for (EightNumbers& block : v) block = EightNumbers{};
    }
    /// To the constant term.
    [[gnu::always_inline]] void add(double c) { v[0] += EightNumbers{c}; }
    [[gnu::always_inline]] void add(const PolynomialRow& other)
    {
        for (int i = 0; i < blocks; ++i) v[i] += other.v[i];
    }
    /// Coefficient i + 1 becomes what i was, or the other way round; 0 comes in.
    [[gnu::always_inline]] PolynomialRow raised() const
    {
        PolynomialRow out;
        for (int i = 0; i < blocks; ++i)
            out.v[i] = __builtin_shufflevector(i > 0 ? v[i - 1] : EightNumbers{}, v[i], 7, 8, 9, 10, 11, 12, 13, 14);
        return out;
    }
    [[gnu::always_inline]] PolynomialRow lowered() const
    {
        PolynomialRow out;
        for (int i = 0; i < blocks; ++i)
            out.v[i] =
                __builtin_shufflevector(v[i], i + 1 < blocks ? v[i + 1] : EightNumbers{}, 1, 2, 3, 4, 5, 6, 7, 8);
        return out;
    }
    /// Times o + d t.
    [[gnu::always_inline]] void times(double o, double d)
    {
        const PolynomialRow up = raised();
        for (int i = 0; i < blocks; ++i) v[i] = v[i] * o + up.v[i] * d;
    }
    void store(double* to, int count) const { std::memcpy(to, v, static_cast<std::size_t>(count) * sizeof(double)); }

    /// Coefficients over 0 to 1 become ordinates.
    [[gnu::always_inline]] void to_ordinates(std::size_t degree)
    {
        PolynomialRow share;
        std::memcpy(share.v, kRowShares[degree].data(), sizeof share.v);
        for (int i = 0; i < blocks; ++i) v[i] *= share.v[i];
        const PolynomialRow place = places();
        for (std::size_t k = 1; k <= degree; ++k) {
            const PolynomialRow up = raised();
            for (int i = 0; i < blocks; ++i) v[i] += place.v[i] >= static_cast<double>(k) ? up.v[i] : EightNumbers{};
        }
    }
    /// Ordinates become those of the range's upper half.
    [[gnu::always_inline]] void halve(std::size_t degree, PolynomialRow& lower_half)
    {
        const PolynomialRow place = places();
        for (std::size_t k = 0; k <= degree; ++k) {
            const double head = v[0][0];
            const PolynomialRow down = lowered();
            for (int i = 0; i < blocks; ++i) {
                lower_half.v[i] = place.v[i] == static_cast<double>(k) ? EightNumbers{} + head : lower_half.v[i];
                v[i] = place.v[i] < static_cast<double>(degree - k) ? 0.5 * (v[i] + down.v[i]) : v[i];
            }
        }
    }

private:
    /// 0, 1, 2, ...
    [[gnu::always_inline]] static PolynomialRow places()
    {
        PolynomialRow out;
        for (int i = 0; i < blocks; ++i) out.v[i] = EightNumbers{0, 1, 2, 3, 4, 5, 6, 7} + 8.0 * i;
        return out;
    }
};

}  // namespace csg
