#pragma once

#include "csg/solids/shared/polynomial_row.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace csg {

/// What PolynomialRow is for one ray, for a ray a lane: the same sums in the same order of what is not 0.
template <class V>
struct PolynomialRays {
    using Number = V;
    std::array<V, kMostRowDegree + 1> v;
    std::size_t count = 0;  ///< of coefficients; the others are 0

    void clear() { count = 0; }
    void add(const V& c)
    {
        v[0] = count == 0 ? c : v[0] + c;
        count = std::max<std::size_t>(count, 1);
    }
    void add(const PolynomialRays& other)
    {
        for (std::size_t i = 0; i < other.count; ++i) v[i] = i < count ? v[i] + other.v[i] : other.v[i];
        count = std::max(count, other.count);
    }
    /// Times o + d t.
    void times(const V& o, const V& d)
    {
        if (count == 0) return;
        v[count] = v[count - 1] * d;
        for (std::size_t i = count; --i > 0;) v[i] = v[i] * o + v[i - 1] * d;
        v[0] = v[0] * o;
        ++count;
    }
    void to_ordinates(std::size_t degree)
    {
        while (count <= degree) v[count++] = V(0.0);
        for (std::size_t i = 0; i <= degree; ++i) v[i] = v[i] * V(kRowShares[degree][i]);
        for (std::size_t k = 1; k <= degree; ++k)
            for (std::size_t i = degree; i >= k; --i) v[i] = v[i] + v[i - 1];
    }
    void halve(std::size_t degree, PolynomialRays& lower_half)
    {
        lower_half.count = count;
        for (std::size_t k = 0; k <= degree; ++k) {
            lower_half.v[k] = v[0];
            for (std::size_t i = 0; i < degree - k; ++i) v[i] = V(0.5) * (v[i] + v[i + 1]);
        }
    }
};

}  // namespace csg
