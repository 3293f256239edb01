#pragma once

#include "function/internal/internal_polynomials.h"

/// Internal functions made of sums, products, squares and roots, over intervals of any form T (spec 5b, 16).
namespace function {

inline bool is_polynomial(std::uint32_t n)
{
    switch (n) {
    case 4:
    case 5:
    case 8:
    case 11:
    case 12:
    case 13:
    case 14:
    case 16:
    case 20:
    case 22:
    case 23:
    case 30:
    case 31:
    case 33:
    case 35:
    case 36:
    case 37:
    case 38:
    case 41:
    case 42:
    case 43:
    case 44:
    case 45:
    case 46:
    case 48:
    case 49:
    case 54:
    case 55:
    case 56:
    case 65:
    case 66:
    case 71:
    case 72:
    case 73:
    case 74: return true;
    default: return false;
    }
}

/// Functions with ranges in lanes (intervals/shape_ends.h), but for odd parameters.
inline bool has_shape_range(std::uint32_t n)
{
    switch (n) {
    case 6:
    case 7:
    case 9:
    case 10:
    case 19:
    case 25:
    case 26:
    case 32:
    case 40:
    case 51:
    case 52:
    case 53:
    case 62:
    case 63:
    case 68: return true;
    default: return false;
    }
}

template <class T>
T distance(const T& x, const T& y, const T& z)
{
    return sqrt(squared(x) + squared(y) + squared(z));
}

template <class T>
T rounded_box(const T* a)
{
    const auto beyond = [&](int k) { return larger(0.0, absolute(a[k]) - (a[4 + k] - a[3])); };
    return distance<T>(beyond(0), beyond(1), beyond(2)) - a[3] - 1e-6;
}

/// False, with nothing done, for other functions. T has + - *, squared, sqrt, absolute, larger and field_limit.
template <class T>
bool arithmetic_range(std::uint32_t n, const T* a, T& out)
{
    if (is_polynomial(n)) {
        out = polynomial<T>(n, a);
        return true;
    }
    switch (n) {
    case 17: out = distance<T>(a[3] * a[0], a[4] * a[1], a[5] * a[2]); return true;
    case 57: out = distance<T>(a[0], a[1], a[2]); return true;
    case 60: out = rounded_box(a); return true;
    case 61: out = distance<T>(a[0], a[1], a[2]) - a[3]; return true;
    case 70: out = distance<T>(distance<T>(a[0], 0.0, a[2]) - a[3], a[1], 0.0) - a[4]; return true;
    default: return false;
    }
}

}  // namespace function
