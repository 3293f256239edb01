#pragma once

#include "numbers/functions/functions.h"

#include <cmath>
#include <numbers>

/// The bounds that sampling to a `confidence` and `variance` goes by.
namespace plan {

/// ln of the gamma function of n / 2.
inline double log_gamma_of_half(int n)
{
    double sum = n % 2 == 0 ? 0.0 : 0.5 * numbers::log(std::numbers::pi);
    for (double k = n / 2.0 - 1.0; k > 0.0; k -= 1.0) sum += numbers::log(k);
    return sum;
}

/// Share of a chi-square variable of n degrees of freedom above x: by the series of the incomplete gamma function, or
/// its continued fraction (Numerical Recipes 6.2).
inline double chi_square_above(int n, double x)
{
    const double a = n / 2.0, z = x / 2.0;
    if (z <= 0.0) return 1.0;
    const double scale = numbers::exp(a * numbers::log(z) - z - log_gamma_of_half(n));
    if (z < a + 1.0) {
        double term = 1.0 / a, sum = term;
        for (double k = a + 1.0; term > sum * 1e-17; k += 1.0) sum += term *= z / k;
        return 1.0 - sum * scale;
    }
    double b = z + 1.0 - a, c = 1e300, d = 1.0 / b, h = d;
    for (int i = 1; i < 10000; ++i) {
        const double an = -i * (i - a);
        b += 2.0;
        d = 1.0 / (an * d + b);
        c = b + an / c;
        h *= d * c;
        if (std::abs(d * c - 1.0) < 1e-15) break;
    }
    return h * scale;
}

/// What a chi-square variable of n degrees of freedom exceeds with that probability.
inline double chi_square(int n, double probability)
{
    if (n <= 0) return 0.0;
    double low = 0.0, high = 1.0;
    while (chi_square_above(n, high) > probability && high < 1e12) high *= 2.0;
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (chi_square_above(n, middle) > probability ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace plan
