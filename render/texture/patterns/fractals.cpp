#include "render/texture/point_lanes.h"
#include "render/texture/patterns/patterns.h"

#include <algorithm>
#include <array>
#include <cmath>

/// numbers: iterations, exponent, exterior type and factor, interior type and factor, magnet type (spec 4, 5.6).
namespace texture {
namespace {

/// Own complex number: std::complex handles infinities at a cost that these loops need not pay.
struct Complex {
    double a = 0, b = 0;
    double square() const { return a * a + b * b; }
};
Complex operator+(Complex x, Complex y) { return {x.a + y.a, x.b + y.b}; }
Complex operator-(Complex x, Complex y) { return {x.a - y.a, x.b - y.b}; }
Complex operator*(Complex x, Complex y) { return {x.a * y.a - x.b * y.b, x.a * y.b + x.b * y.a}; }
Complex operator*(double s, Complex y) { return {s * y.a, s * y.b}; }
Complex operator/(Complex x, Complex y)
{
    const double q = y.square();
    return {(x.a * y.a + x.b * y.b) / q, (x.b * y.a - x.a * y.b) / q};
}

constexpr double kEscape = 4.0;                 // |z|^2 of mandel and julia
constexpr double kMagnetEscape = 10000.0;       // |z|^2 of the magnets
constexpr double kMagnetFixed = 1.0 / 10000.0;  // |z - 1|^2 below which a magnet has converged

double exterior(const Pattern& pattern, int k, Complex z)
{
    const double f = pattern.numbers[3];
    switch (static_cast<int>(pattern.numbers[2])) {
    case 0: return f;
    case 1: return k / pattern.numbers[0];
    case 2: return f * z.a;
    case 3: return f * z.b;
    case 4: return f * z.a * z.a;
    case 5: return f * z.b * z.b;
    case 6: return f * std::sqrt(z.square());
    case 7: return std::trunc(f) == 0.0 ? 0.0 : std::fmod(k, std::trunc(f)) / f;
    case 8: return std::trunc(1.0 + f) == 0.0 ? 0.0 : std::fmod(k, std::trunc(1.0 + f)) / f;
    default: return 0.0;
    }
}

double interior(const Pattern& pattern, double smallest, Complex z)
{
    const double f = pattern.numbers[5];
    switch (static_cast<int>(pattern.numbers[4])) {
    case 0: return f;
    case 1: return f * std::sqrt(smallest);
    case 2: return f * z.a;
    case 3: return f * z.b;
    case 4: return f * z.a * z.a;
    case 5: return f * z.b * z.b;
    case 6: return z.a * z.a + z.b * z.b * f;
    default: return 0.0;
    }
}

template <class Step, class Escaped>
double iterate(const Pattern& pattern, Complex z, double smallest, Step step, Escaped escaped)
{
    const int n = static_cast<int>(pattern.numbers[0]);
    for (int k = 0; k < n; ++k) {
        z = step(z);
        smallest = std::min(smallest, z.square());
        if (escaped(z)) return exterior(pattern, k, z);
    }
    return interior(pattern, smallest, z);
}

Complex to_power(Complex z, int exponent)
{
    Complex r = z;
    for (int i = 1; i < exponent; ++i) r = r * z;
    return r;
}

double power_set(const Pattern& pattern, Complex z, Complex c)
{
    const int exponent = static_cast<int>(pattern.numbers[1]);
    return iterate(
        pattern, z, z.square(), [c, exponent](Complex w) { return to_power(w, exponent) + c; },
        [](Complex w) { return w.square() > kEscape; });
}

double magnet(const Pattern& pattern, Complex z, double smallest, Complex c)
{
    const Complex one{1, 0}, two{2, 0};
    const auto first = [c, one, two](Complex w) {
        const Complex q = (w * w + c - one) / (2.0 * w + c - two);
        return q * q;
    };
    const Complex c1 = c - one, c2 = c - two, c12 = c1 * c2;
    const auto second = [c1, c2, c12, one](Complex w) {
        const Complex q = (w * w * w + 3.0 * c1 * w + c12) / (3.0 * w * w + 3.0 * c2 * w + c12 + one);
        return q * q;
    };
    const auto escaped = [one](Complex w) { return w.square() > kMagnetEscape || (w - one).square() < kMagnetFixed; };
    return pattern.numbers[6] == 2.0 ? iterate(pattern, z, smallest, second, escaped)
                                     : iterate(pattern, z, smallest, first, escaped);
}

}  // namespace

double mandel(const Pattern& pattern, const glm::dvec3& p) { return power_set(pattern, {p.x, p.y}, {p.x, p.y}); }

namespace {

using csg::lanes::Double;

struct ComplexLanes {
    Double a, b;
};

/// power_set of some vectors of points, in the same order of operations; c may be the points. A step waits for the one
/// before it, so several vectors are worked on in turn. Squares: the exponent is 2, and products that are alike are
/// made once.
template <bool Squares, std::size_t Vectors>
void power_set_lanes(const Pattern& pattern, std::array<ComplexLanes, Vectors> z,
                     const std::array<ComplexLanes, Vectors>& c, std::size_t count, double* out)
{
    const int exponent = static_cast<int>(pattern.numbers[1]), n = static_cast<int>(pattern.numbers[0]);
    constexpr std::uint32_t kEveryone = (1u << kLanes) - 1;
    const auto part = [](const Double& v, std::size_t lane) {
        alignas(64) double parts[kLanes];
        v.store_aligned(parts);
        return parts[lane];
    };
    std::array<Double, Vectors> smallest, a2, b2;  // a2, b2: squares of the parts of z
    std::array<std::uint32_t, Vectors> inside{};
    for (std::size_t v = 0; v < Vectors; ++v) {
        a2[v] = z[v].a * z[v].a;
        b2[v] = z[v].b * z[v].b;
        smallest[v] = a2[v] + b2[v];
        if (count > v * kLanes) inside[v] = kEveryone;
    }
    for (int k = 0; k < n; ++k) {
        std::uint32_t left = 0;
        for (std::size_t v = 0; v < Vectors; ++v) {
            ComplexLanes r = z[v];
            if constexpr (Squares) {
                const Double product = r.a * r.b;
                r = {a2[v] - b2[v], product + product};
            } else {
                for (int i = 1; i < exponent; ++i) r = {r.a * z[v].a - r.b * z[v].b, r.a * z[v].b + r.b * z[v].a};
            }
            z[v] = {r.a + c[v].a, r.b + c[v].b};
            a2[v] = z[v].a * z[v].a;
            b2[v] = z[v].b * z[v].b;
            const Double size = a2[v] + b2[v];
            smallest[v] = xsimd::select(size < smallest[v], size, smallest[v]);
            // A lane that is out stays out: its size grows or is no number, so only the first time counts.
            const std::uint32_t fresh = csg::lanes::mask(size > Double(kEscape)) & inside[v];
            if (fresh != 0) [[unlikely]] {
                for (std::size_t i = 0; i < kLanes && v * kLanes + i < count; ++i)
                    if ((fresh >> i & 1u) != 0)
                        out[v * kLanes + i] = exterior(pattern, k, {part(z[v].a, i), part(z[v].b, i)});
                inside[v] &= ~fresh;
            }
            left |= inside[v];
        }
        if (left == 0) return;
    }
    for (std::size_t v = 0; v < Vectors; ++v)
        for (std::size_t i = 0; i < kLanes && v * kLanes + i < count; ++i)
            if ((inside[v] >> i & 1u) != 0)
                out[v * kLanes + i] = interior(pattern, part(smallest[v], i), {part(z[v].a, i), part(z[v].b, i)});
}

template <bool Squares>
void power_set_points(const Pattern& pattern, const Points& p, double* out)
{
    constexpr std::size_t kVectors = 2, kAtOnce = kVectors * kLanes;
    static_assert(kMostPoints % kAtOnce == 0);
    for (std::size_t i = 0; i < p.size(); i += kAtOnce) {
        std::array<ComplexLanes, kVectors> z, c;
        for (std::size_t v = 0; v < kVectors; ++v) {
            // A vector behind the last point is anything; nobody asks for it.
            z[v] = {get(p.x, i + v * kLanes), get(p.y, i + v * kLanes)};
            c[v] = pattern.kind == PatternKind::Mandel
                       ? z[v]
                       : ComplexLanes{Double(pattern.vector.x), Double(pattern.vector.y)};
        }
        power_set_lanes<Squares>(pattern, z, c, std::min(kAtOnce, p.size() - i), out + i);
    }
}

}  // namespace

void power_set_values(const Pattern& pattern, const Points& p, Values& out)
{
    if (static_cast<int>(pattern.numbers[1]) == 2) power_set_points<true>(pattern, p, out.data());
    else power_set_points<false>(pattern, p, out.data());
}

double julia(const Pattern& pattern, const glm::dvec3& p)
{
    return power_set(pattern, {p.x, p.y}, {pattern.vector.x, pattern.vector.y});
}

double magnet_mandel(const Pattern& pattern, const glm::dvec3& p)
{
    return magnet(pattern, {}, kMagnetEscape, {p.x, p.y});
}

double magnet_julia(const Pattern& pattern, const glm::dvec3& p)
{
    const Complex z{p.x, p.y};
    return magnet(pattern, z, z.square(), {pattern.vector.x, pattern.vector.y});
}

}  // namespace texture
