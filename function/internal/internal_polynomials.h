#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

/// Surfaces given by polynomials, clamped to +-10 (spec 5b, 16 and 16.1). T: a number or an interval.
namespace function {

inline double field_limit(double v) { return std::min(10.0, std::max(-10.0, v)); }
inline double squared(double v) { return v * v; }

template <class T>
T boy_surface(const T& x, const T& y, const T& z)
{
    const double r2 = std::numbers::sqrt2;
    const T w = 1.0 - z, h = squared(x) + squared(y), z2 = squared(z), w2 = squared(w);
    const T first = 64.0 * (w2 * w) * (z2 * z) - 48.0 * w2 * z2 * (3.0 * h + 2.0 * z2);
    const T third =
        12.0 * w * z *
        (27.0 * squared(h) - 24.0 * z2 * h + 36.0 * r2 * y * z * (squared(y) - 3.0 * squared(x)) + 4.0 * squared(z2));
    const T last = (9.0 * h - 2.0 * z2) * (-81.0 * squared(h) - 72.0 * z2 * h +
                                           108.0 * r2 * x * z * (squared(x) - 3.0 * squared(y)) + 4.0 * squared(z2));
    return first + third + last;
}

template <class T>
T dupin_cyclid(const T& x, const T& y, const T& s, const T* p)
{
    const T R = p[1], r = p[2], X = p[3], Y = p[4], J = squared(p[5]);
    const T r2 = squared(r), R2 = squared(R), X2 = squared(X), Y2 = squared(Y), J2 = squared(J);
    const T alpha = r2 - Y2 - squared(X + R), beta = r2 - Y2 - squared(X - R);
    const T along = X * x + Y * y;
    return alpha * beta * squared(s) + 2.0 * J * ((r2 + R2 - X2 - Y2) * (2.0 * along - J) - 4.0 * Y * r2 * y) * s +
           4.0 * J2 * along * (along - J) + 4.0 * J2 * R2 * squared(y) + squared(J2);
}

/// Polynomials without its strength and sign: value * strength * sign is clamped.
template <class T>
T polynomial_body(std::uint32_t n, const T* a, double& sign)
{
    const T x = a[0], y = a[1], z = a[2], x2 = squared(x), y2 = squared(y), z2 = squared(z), s = x2 + y2 + z2;
    const T* p = a + 3;
    sign = -1.0;
    switch (n) {
    case 4: {
        sign = 1.0;
        const T d = squared(p[1]);
        return y2 * (d - x2 - z2) - squared(x2 + z2 + 2.0 * p[1] * y - d);
    }
    case 5: return squared(s) - p[1] * (x2 + z2) * y;
    case 8: sign = 1.0; return p[1] * boy_surface(x, y, z);
    case 11: sign = 1.0; return x2 * z2 - y;
    case 12: return x2 * x - y2 * y - z;
    case 13:
    case 43:
        sign = 1.0;
        return x2 * z2 - squared(z2) - 2.0 * z * x2 + 2.0 * z2 * z + x2 - z2 - squared(x2 - z) - squared(y2) -
               2.0 * x2 * y2 - y2 * z2 + 2.0 * y2 * z + y2;
    case 14: return squared(x2) + 2.0 * x2 * z2 - 0.36 * x2 - squared(y2) + 0.25 * y2 + squared(z2);
    case 16: return dupin_cyclid(x, y, s, p);
    case 20: sign = 1.0; return (y2 + z2) * (1.0 + (p[2] - 4.0 * p[1]) * x) + x2 * (1.0 + p[2]);
    case 22: sign = 1.0; return 0.5 * squared(x2) * x + 0.5 * squared(x2) - y2 - z2;
    case 23: {
        const T q = 2.0 * x2 + y2 + z2 - 1.0;
        return squared(q) * q - 0.1 * x2 * (z2 * z) - y2 * (z2 * z);
    }
    case 30: {
        const T q = s - 13.0;
        return 4.0 * squared(q) * q + 27.0 * squared(3.0 * x2 + y2 - 4.0 * z2 - 12.0);
    }
    case 31: {
        const T u = squared(p[1]), v = squared(p[2]);
        return squared(x2) + 2.0 * x2 * y2 - 2.0 * x2 * z2 - 2.0 * (u + v) * x2 + squared(y2) - 2.0 * y2 * z2 +
               2.0 * (u - v) * y2 + squared(z2) + 2.0 * (u + v) * z2 + squared(u - v);
    }
    case 33: return y2 + z2 - squared(p[2]) * squared(x2) + squared(p[2]) * squared(p[1]) * x2;
    case 35: {
        const T q = s - 2.0 * y - 1.0;
        return (s + 2.0 * y - 1.0) * (squared(q) - 8.0 * z2) + 16.0 * x * z * q;
    }
    case 36: return squared(x2) + squared(y2) + squared(z2) - s - x2 * y2 - x2 * z2 - y2 * z2 + 1.0;
    case 37:
        return squared(x2) + squared(y2) + squared(z2) + p[1] * s + p[2] * (x2 * y2 + x2 * z2 + y2 * z2) +
               p[3] * x * y * z - 1.0;
    case 38: return squared(x2) - x2 + y2 + z2;
    case 41: return 4.0 * x2 * s - y2 * (1.0 - y2 - z2);
    case 42: return y2 * y + z2 * z - 6.0 * y * z;
    case 44: return squared(s + squared(p[1])) - p[3] * squared(p[1]) * (x2 + z2) - squared(p[2]);
    case 45: return x2 - y + z2;
    case 46: {
        const T u = squared(p[1]), v = squared(p[2]);
        return squared(x2) + 2.0 * x2 * y2 - 2.0 * x2 * z - (u + v) * x2 + squared(y2) - 2.0 * y2 * z + (u - v) * y2 +
               z2 + (u + v) * z + squared(u - v);
    }
    case 48: sign = 1.0; return squared(x2) + squared(y2) + squared(z2) - s;
    case 49: sign = 1.0; return squared(x2) - x2 * x + y2 + z2;
    case 54: return squared(x2) + squared(z2) - y;
    case 55: return squared(x2) - squared(z2) - y;
    case 56: {
        const T q = x2 + z2, w = squared(p[2]);
        return q * y2 + w * q - w * squared(p[1]);
    }
    case 65: return x2 * y2 + x2 * z2 + y2 * z2 + x * y * z;
    case 66: return (p[2] - x) * (y2 + z2) - squared(p[3]) * p[1] * x2 - squared(p[3]) * (x2 * x);
    case 71: {
        const T u = squared(p[1]), v = squared(p[2]);
        return squared(s) - 2.0 * (u + v) * x2 + 2.0 * (u - v) * y2 - 2.0 * (u + v) * z2 + squared(u - v);
    }
    case 72: {
        const T q = y2 + z2;
        return 4.0 * (squared(x2) + squared(q)) + 17.0 * x2 * q - 20.0 * (x2 + q) + 17.0;
    }
    case 73: return x2 - y * z2;
    default: return p[1] * (y - 1.0) + (x2 + z2) * y;  // 74
    }
}

template <class T>
T polynomial(std::uint32_t n, const T* a)
{
    double sign = 1.0;
    const T value = polynomial_body(n, a, sign);
    return field_limit(sign * a[3] * value);
}

}  // namespace function
