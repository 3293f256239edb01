#include "numbers/remainder.h"
#include "render/texture/points/point_lanes.h"
#include "render/texture/patterns/patterns.h"

#include <algorithm>
#include <bit>
#include <cmath>

/// numbers: iterations, exponent, exterior type and factor, interior type and factor, magnet type (spec 4, 5.6).
namespace texture {
namespace {

/// Complex numbers in lanes, without the infinities that std::complex looks after.
struct Number {
    Double a, b;
};
Number operator+(const Number& x, const Number& y) { return {x.a + y.a, x.b + y.b}; }
Number operator-(const Number& x, const Number& y) { return {x.a - y.a, x.b - y.b}; }
Number operator*(const Number& x, const Number& y) { return {x.a * y.a - x.b * y.b, x.a * y.b + x.b * y.a}; }
Number operator*(double s, const Number& y) { return {Double(s) * y.a, Double(s) * y.b}; }
Number operator/(const Number& x, const Number& y)
{
    const Double q = y.a * y.a + y.b * y.b;
    return {(x.a * y.a + x.b * y.b) / q, (x.b * y.a - x.a * y.b) / q};
}
Number whole(double a) { return {Double(a), Double(0.0)}; }

/// What is told of a point that has escaped in step k, with z there.
double exterior(const Pattern& pattern, int k, double a, double b)
{
    const double f = pattern.numbers[3];
    switch (static_cast<int>(pattern.numbers[2])) {
    case 0: return f;
    case 1: return k / pattern.numbers[0];
    case 2: return f * a;
    case 3: return f * b;
    case 4: return f * a * a;
    case 5: return f * b * b;
    case 6: return f * std::sqrt(a * a + b * b);
    case 7: return std::trunc(f) == 0.0 ? 0.0 : numbers::fmod(k, std::trunc(f)) / f;
    case 8: return std::trunc(1.0 + f) == 0.0 ? 0.0 : numbers::fmod(k, std::trunc(1.0 + f)) / f;
    default: return 0.0;
    }
}

/// The value of a point that never escapes.
/// \param smallest  the least |z|^2 that it had
double interior(const Pattern& pattern, double smallest, double a, double b)
{
    const double f = pattern.numbers[5];
    switch (static_cast<int>(pattern.numbers[4])) {
    case 0: return f;
    case 1: return f * std::sqrt(smallest);
    case 2: return f * a;
    case 3: return f * b;
    case 4: return f * a * a;
    case 5: return f * b * b;
    case 6: return a * a + b * b * f;
    default: return 0.0;
    }
}

/// z on its way, with the squares of its parts, which both its size and most rules ask for.
struct Orbit {
    Number z;
    Double a2, b2, size;
    explicit Orbit(const Number& at) : z(at), a2(at.a * at.a), b2(at.b * at.b), size(a2 + b2) {}
    Number square() const
    {
        const Double product = z.a * z.b;
        return {a2 - b2, product + product};
    }
};

/// z^exponent + c. Squares: the exponent is 2.
template <bool Squares>
struct PowerRule {
    Number c;
    int exponent;
    PowerRule(const Pattern& pattern, const Number& of) : c(of), exponent(static_cast<int>(pattern.numbers[1])) {}
    Number next(const Orbit& at) const
    {
        if constexpr (Squares) return at.square() + c;
        Number r = at.z;
        for (int i = 1; i < exponent; ++i) r = r * at.z;
        return r + c;
    }
    static auto escaped(const Orbit& at) { return at.size > Double(4.0); }
};

struct MagnetRule {
    static constexpr double kFar = 10000.0, kFixed = 1.0 / 10000.0;  // |z|^2, and |z - 1|^2 where it has converged
    static auto escaped(const Orbit& at)
    {
        const Double off = at.z.a - Double(1.0);
        return (at.size > Double(kFar)) | (off * off + at.b2 < Double(kFixed));
    }
};

/// ((z^2 + c - 1) / (2z + c - 2))^2
struct FirstMagnet : MagnetRule {
    Number c;
    FirstMagnet(const Pattern&, const Number& of) : c(of) {}
    Number next(const Orbit& at) const
    {
        const Number q = (at.square() + c - whole(1)) / (2.0 * at.z + c - whole(2));
        return q * q;
    }
};

/// ((z^3 + 3 (c - 1) z + (c - 1) (c - 2)) / (3 z^2 + 3 (c - 2) z + (c - 1) (c - 2) + 1))^2
struct SecondMagnet : MagnetRule {
    Number c1, c2, c12;
    SecondMagnet(const Pattern&, const Number& of) : c1(of - whole(1)), c2(of - whole(2)), c12(c1 * c2) {}
    Number next(const Orbit& at) const
    {
        const Number above = at.square() * at.z + 3.0 * c1 * at.z + c12;
        const Number q = above / (3.0 * at.z * at.z + 3.0 * c2 * at.z + c12 + whole(1));
        return q * q;
    }
};

/// As many points as there are lanes, each on its own way.
template <class Rule>
struct Walk {
    Rule rule;
    Orbit at;
    Double smallest;
    std::uint32_t inside;  ///< lanes that have not escaped

    Walk(const Pattern& pattern, const Number& start, const Number& c, const Double& least, std::uint32_t lanes)
        : rule(pattern, c), at(start), smallest(least), inside(lanes)
    {}
    /// The lanes that escape now.
    [[gnu::always_inline]] std::uint32_t step()
    {
        at = Orbit(rule.next(at));
        smallest = xsimd::select(at.size < smallest, at.size, smallest);
        const std::uint32_t fresh = numbers::lanes::mask(Rule::escaped(at)) & inside;
        inside &= ~fresh;
        return fresh;
    }
};

/// value(a, b, the least |z|^2) of some lanes.
template <class Rule, class Value>
void put_lanes(const Walk<Rule>& walk, std::uint32_t lanes, double* out, Value&& value)
{
    alignas(64) double a[kLanes], b[kLanes], least[kLanes];
    walk.at.z.a.store_aligned(a);
    walk.at.z.b.store_aligned(b);
    walk.smallest.store_aligned(least);
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(lanes));
        out[i] = value(a[i], b[i], least[i]);
    }
}

template <class Rule>
[[gnu::noinline]] void put_escaped(const Pattern& pattern, int k, const Walk<Rule> walk, std::uint32_t lanes,
                                   double* out)
{
    put_lanes(walk, lanes, out, [&](double a, double b, double) { return exterior(pattern, k, a, b); });
}

/// Iterates two vectors of points in turn, since each step has to wait for the one before it.
/// \param start  (point) -> a walk
template <class Rule, class Start>
void walk_all(const Pattern& pattern, const Points& p, double* out, Start&& start)
{
    const int n = static_cast<int>(pattern.numbers[0]);
    static_assert(kMostPoints % (2 * kLanes) == 0);
    const auto walk_from = [&](std::size_t i) {
        // A vector behind the last point is anything; nobody asks for it.
        const std::uint32_t lanes = i < p.size() ? (1u << std::min(kLanes, p.size() - i)) - 1u : 0u;
        return start(Number{get(p.x, i), get(p.y, i)}, lanes);
    };
    for (std::size_t i = 0; i < p.size(); i += 2 * kLanes) {
        Walk<Rule> first = walk_from(i), second = walk_from(i + kLanes);
        for (int k = 0; k < n && (first.inside | second.inside) != 0; ++k) {
            const std::uint32_t fresh = first.step(), others = second.step();
            if ((fresh | others) == 0) continue;
            if (fresh != 0) put_escaped(pattern, k, first, fresh, out + i);
            if (others != 0) put_escaped(pattern, k, second, others, out + i + kLanes);
        }
        const auto put_inside = [&](const Walk<Rule>& of, double* to) {
            put_lanes(of, of.inside, to,
                      [&](double a, double b, double least) { return interior(pattern, least, a, b); });
        };
        put_inside(first, out + i);
        put_inside(second, out + i + kLanes);
    }
}

Number constant_of(const Pattern& pattern) { return {Double(pattern.vector.x), Double(pattern.vector.y)}; }

template <class Rule>
void power_set(const Pattern& pattern, const Points& p, double* out)
{
    const bool julia = pattern.kind == PatternKind::Julia;
    walk_all<Rule>(pattern, p, out, [&](const Number& at, std::uint32_t lanes) {
        return Walk<Rule>(pattern, at, julia ? constant_of(pattern) : at, Orbit(at).size, lanes);
    });
}

template <class Rule>
void magnet(const Pattern& pattern, const Points& p, double* out)
{
    const bool julia = pattern.kind == PatternKind::MagnetJulia;
    walk_all<Rule>(pattern, p, out, [&](const Number& at, std::uint32_t lanes) {
        if (julia) return Walk<Rule>(pattern, at, constant_of(pattern), Orbit(at).size, lanes);
        return Walk<Rule>(pattern, whole(0), at, Double(MagnetRule::kFar), lanes);
    });
}

}  // namespace

void fractal_values(const Pattern& pattern, const Points& p, Values& out)
{
    if (pattern.kind == PatternKind::Mandel || pattern.kind == PatternKind::Julia) {
        if (static_cast<int>(pattern.numbers[1]) == 2) power_set<PowerRule<true>>(pattern, p, out.data());
        else power_set<PowerRule<false>>(pattern, p, out.data());
    } else if (pattern.numbers[6] == 2.0) {
        magnet<SecondMagnet>(pattern, p, out.data());
    } else {
        magnet<FirstMagnet>(pattern, p, out.data());
    }
}

double fractal(const Pattern& pattern, const glm::dvec3& p)
{
    Points one;
    one.add(p);
    one.pad();
    Values out;
    fractal_values(pattern, one, out);
    return out[0];
}

}  // namespace texture
