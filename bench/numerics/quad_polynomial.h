#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

/// Polynomials in 113-bit arithmetic and where they change sign: slow, plain, and independent of what they judge.
namespace numerics {

using Quad = __float128;

inline Quad absolute(Quad v) { return v < 0 ? -v : v; }

/// c[0] + c[1] t + ...
struct QuadPolynomial {
    std::vector<Quad> c;

    QuadPolynomial(Quad constant = 0) : c{constant} {}
    QuadPolynomial(Quad constant, Quad slope) : c{constant, slope} {}

    Quad operator()(Quad t) const
    {
        Quad v = 0;
        for (std::size_t i = c.size(); i-- > 0;) v = v * t + c[i];
        return v;
    }
    QuadPolynomial derivative() const
    {
        QuadPolynomial d;
        d.c.assign(std::max<std::size_t>(1, c.size() - 1), 0);
        for (std::size_t i = 1; i < c.size(); ++i) d.c[i - 1] = c[i] * static_cast<Quad>(i);
        return d;
    }
    friend QuadPolynomial operator+(QuadPolynomial a, const QuadPolynomial& b)
    {
        a.c.resize(std::max(a.c.size(), b.c.size()), 0);
        for (std::size_t i = 0; i < b.c.size(); ++i) a.c[i] += b.c[i];
        return a;
    }
    friend QuadPolynomial operator*(const QuadPolynomial& a, const QuadPolynomial& b)
    {
        QuadPolynomial p;
        p.c.assign(a.c.size() + b.c.size() - 1, 0);
        for (std::size_t i = 0; i < a.c.size(); ++i)
            for (std::size_t j = 0; j < b.c.size(); ++j) p.c[i + j] += a.c[i] * b.c[j];
        return p;
    }
    friend QuadPolynomial operator-(const QuadPolynomial& a, const QuadPolynomial& b)
    {
        return a + QuadPolynomial(-1) * b;
    }
};

/// The root of p between a and b, where its signs differ: bisection and Newton to the last bits.
inline Quad halved_in(const QuadPolynomial& p, const QuadPolynomial& slope, Quad a, Quad b)
{
    const bool rises = p(b) > 0;
    Quad t = (a + b) / 2;
    for (int step = 0; step < 300 && a < b; ++step) {
        const Quad value = p(t);
        if (value == 0) break;
        ((value > 0) == rises ? b : a) = t;
        const Quad steepness = slope(t);
        Quad next = steepness != 0 ? t - value / steepness : a;
        if (!(next > a && next < b) || step % 3 == 2) next = (a + b) / 2;
        if (next == t || next <= a || next >= b) break;
        t = next;
    }
    return t;
}

/// Where p changes sign in [low, high], ascending: between the turns.
inline std::vector<Quad> sign_changes(const QuadPolynomial& p, Quad low, Quad high)
{
    std::size_t degree = p.c.size() - 1;
    while (degree > 0 && p.c[degree] == 0) --degree;
    if (degree == 0) return {};
    std::vector<Quad> ends{low};
    if (degree > 1) {
        QuadPolynomial shorter = p;
        shorter.c.resize(degree + 1);
        for (const Quad turn : sign_changes(shorter.derivative(), low, high)) ends.push_back(turn);
    }
    ends.push_back(high);
    const QuadPolynomial slope = p.derivative();
    std::vector<Quad> roots;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        if ((p(ends[i]) > 0) != (p(ends[i + 1]) > 0)) roots.push_back(halved_in(p, slope, ends[i], ends[i + 1]));
    return roots;
}

}  // namespace numerics
