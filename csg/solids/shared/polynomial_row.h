#pragma once

#include <cstddef>
#include <cstring>

/// A polynomial's coefficients, or its ordinates, side by side in vectors of eight: an operation on all of them is one
/// a vector, and none has to wait for its neighbour through memory. Lanes behind the degree are multiplied along.
namespace csg {

using EightNumbers [[gnu::vector_size(64)]] = double;

template <int blocks>
struct PolynomialRow {
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
};

/// 0, 1, 2, ...
template <int blocks>
[[gnu::always_inline]] inline PolynomialRow<blocks> row_places()
{
    PolynomialRow<blocks> out;
    for (int i = 0; i < blocks; ++i) out.v[i] = EightNumbers{0, 1, 2, 3, 4, 5, 6, 7} + 8.0 * i;
    return out;
}

}  // namespace csg
