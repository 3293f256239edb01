#include "numbers/remainder.h"
#include "render/texture/points/point_lanes.h"
#include "render/texture/patterns/patterns.h"

#include <algorithm>
#include <bit>
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
    case 7: return std::trunc(f) == 0.0 ? 0.0 : numbers::fmod(k, std::trunc(f)) / f;
    case 8: return std::trunc(1.0 + f) == 0.0 ? 0.0 : numbers::fmod(k, std::trunc(1.0 + f)) / f;
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

/// power_set of as many points as there are lanes, in the same order of operations; the point itself may be the
/// constant. Squares: the exponent is 2, and products that are alike are made once.
template <bool Squares>
struct Orbits {
    Double a, b, of_a, of_b;        ///< z, and what is added to each of its powers
    Double a2, b2, size, smallest;  ///< squares of the parts of z; their sum, and the least that it was
    std::uint32_t inside;           ///< lanes that have not escaped

    Orbits(const Pattern& pattern, const Double& x, const Double& y, std::uint32_t lanes)
        : a(x), b(y), of_a(x), of_b(y), a2(x * x), b2(y * y), size(a2 + b2), smallest(size), inside(lanes)
    {
        if (pattern.kind != PatternKind::Mandel) of_a = Double(pattern.vector.x), of_b = Double(pattern.vector.y);
    }

    /// The lanes that escape now. A lane that is out stays out: its size grows or is no number.
    [[gnu::always_inline]] std::uint32_t step(int exponent)
    {
        Double ra = a, rb = b;
        if constexpr (Squares) {
            const Double product = a * b;
            ra = a2 - b2;
            rb = product + product;
        } else {
            for (int i = 1; i < exponent; ++i) {
                const Double next = ra * a - rb * b;
                rb = ra * b + rb * a;
                ra = next;
            }
        }
        a = ra + of_a;
        b = rb + of_b;
        a2 = a * a;
        b2 = b * b;
        size = a2 + b2;
        smallest = xsimd::select(size < smallest, size, smallest);
        const std::uint32_t fresh = csg::lanes::mask(size > Double(kEscape)) & inside;
        inside &= ~fresh;
        return fresh;
    }
};

/// value(z, the least square of its length) of some lanes.
template <class Value>
void put_lanes(const Double& a, const Double& b, const Double& smallest, std::uint32_t lanes, double* out,
               Value&& value)
{
    alignas(64) double za[kLanes], zb[kLanes], least[kLanes];
    a.store_aligned(za);
    b.store_aligned(zb);
    smallest.store_aligned(least);
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(lanes));
        out[i] = value(Complex{za[i], zb[i]}, least[i]);
    }
}

template <bool Squares>
[[gnu::noinline]] void put_escaped(const Pattern& pattern, int k, const Orbits<Squares> orbits, std::uint32_t lanes,
                                   double* out)
{
    put_lanes(orbits.a, orbits.b, orbits.smallest, lanes, out,
              [&](Complex z, double) { return exterior(pattern, k, z); });
}

/// Two vectors of points in turn: a step waits for the one before it.
template <bool Squares>
void power_set_points(const Pattern& pattern, const Points& p, double* out)
{
    const int exponent = static_cast<int>(pattern.numbers[1]), n = static_cast<int>(pattern.numbers[0]);
    static_assert(kMostPoints % (2 * kLanes) == 0);
    for (std::size_t i = 0; i < p.size(); i += 2 * kLanes) {
        const auto lanes = [&](std::size_t at) {
            return at < p.size() ? (1u << std::min(kLanes, p.size() - at)) - 1u : 0u;
        };
        Orbits<Squares> first(pattern, get(p.x, i), get(p.y, i), lanes(i));
        // A vector behind the last point is anything; nobody asks for it.
        Orbits<Squares> second(pattern, get(p.x, i + kLanes), get(p.y, i + kLanes), lanes(i + kLanes));
        for (int k = 0; k < n && (first.inside | second.inside) != 0; ++k) {
            const std::uint32_t fresh = first.step(exponent), others = second.step(exponent);
            if ((fresh | others) == 0) continue;
            if (fresh != 0) put_escaped(pattern, k, first, fresh, out + i);
            if (others != 0) put_escaped(pattern, k, second, others, out + i + kLanes);
        }
        const auto put_inside = [&](const Orbits<Squares>& of, double* to) {
            put_lanes(of.a, of.b, of.smallest, of.inside, to,
                      [&](Complex z, double least) { return interior(pattern, least, z); });
        };
        put_inside(first, out + i);
        put_inside(second, out + i + kLanes);
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
