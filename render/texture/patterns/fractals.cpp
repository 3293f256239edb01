#include "render/texture/point_lanes.h"
#include "render/texture/patterns/patterns.h"

#include <algorithm>
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

/// power_set of as many points as there are lanes, in the same order of operations; c may be the points.
void power_set_lanes(const Pattern& pattern, ComplexLanes z, const ComplexLanes& c, std::size_t count, double* out)
{
    const int exponent = static_cast<int>(pattern.numbers[1]), n = static_cast<int>(pattern.numbers[0]);
    const auto square = [](const ComplexLanes& w) { return w.a * w.a + w.b * w.b; };
    const std::uint32_t everyone = (1u << csg::lanes::kDoubles) - 1;
    Double smallest = square(z);
    std::uint32_t escaped = 0;
    for (int k = 0; k < n && escaped != everyone; ++k) {
        ComplexLanes r = z;
        for (int i = 1; i < exponent; ++i) r = {r.a * z.a - r.b * z.b, r.a * z.b + r.b * z.a};
        z = {r.a + c.a, r.b + c.b};
        const Double size = square(z);
        smallest = xsimd::select(size < smallest, size, smallest);
        // A lane that is out stays out: its size grows or is no number, so only the first time counts.
        const auto out_now = size > Double(kEscape);
        const std::uint32_t fresh = csg::lanes::mask(out_now) & ~escaped;
        if (fresh == 0) continue;
        alignas(64) double za[csg::lanes::kDoubles], zb[csg::lanes::kDoubles];
        z.a.store_aligned(za);
        z.b.store_aligned(zb);
        for (std::size_t i = 0; i < count; ++i)
            if ((fresh >> i & 1u) != 0) out[i] = exterior(pattern, k, {za[i], zb[i]});
        escaped |= fresh;
    }
    alignas(64) double za[csg::lanes::kDoubles], zb[csg::lanes::kDoubles], least[csg::lanes::kDoubles];
    z.a.store_aligned(za);
    z.b.store_aligned(zb);
    smallest.store_aligned(least);
    for (std::size_t i = 0; i < count; ++i)
        if ((escaped >> i & 1u) == 0) out[i] = interior(pattern, least[i], {za[i], zb[i]});
}

}  // namespace

void power_set_values(const Pattern& pattern, const Points& p, Values& out)
{
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        const ComplexLanes z{Double::load_aligned(p.x.data() + i), Double::load_aligned(p.y.data() + i)};
        const ComplexLanes c =
            pattern.kind == PatternKind::Mandel ? z : ComplexLanes{Double(pattern.vector.x), Double(pattern.vector.y)};
        power_set_lanes(pattern, z, c, std::min(kLanes, p.size() - i), out.data() + i);
    }
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
