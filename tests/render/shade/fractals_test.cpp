#include "render/texture/patterns/patterns.h"
#include "tests/render/shade/random_points.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>

using namespace texture;

namespace {

using Complex = std::complex<long double>;

Complex next(const Pattern& pattern, const Complex& z, const Complex& c)
{
    if (pattern.kind == PatternKind::Mandel || pattern.kind == PatternKind::Julia) {
        Complex out = z;
        for (int i = 1; i < static_cast<int>(pattern.numbers[1]); ++i) out *= z;
        return out + c;
    }
    const long double one = 1.0L, two = 2.0L, three = 3.0L;
    const Complex c1 = c - one, c2 = c - two;
    const Complex root = pattern.numbers[6] == 2.0
                             ? (z * z * z + three * c1 * z + c1 * c2) / (three * z * z + three * c2 * z + c1 * c2 + one)
                             : (z * z + c1) / (two * z + c2);
    return root * root;
}

/// The step in which a point escapes, the number of steps if it does not; -1 where one of them is too near to tell.
int escape(const Pattern& pattern, const glm::dvec3& p)
{
    const bool julia = pattern.kind == PatternKind::Julia || pattern.kind == PatternKind::MagnetJulia;
    const bool magnet = pattern.kind == PatternKind::MagnetMandel || pattern.kind == PatternKind::MagnetJulia;
    const Complex at(p.x, p.y), c = julia ? Complex(pattern.vector.x, pattern.vector.y) : at;
    Complex z = magnet && !julia ? Complex(0) : at;
    const long double far = magnet ? 1e4L : 4.0L, fixed = 1e-4L, unsure = 1e-6L;
    const int n = static_cast<int>(pattern.numbers[0]);
    for (int k = 0; k < n; ++k) {
        z = next(pattern, z, c);
        const long double size = std::norm(z), off = std::norm(z - Complex(1));
        if (!std::isfinite(size) || std::abs(size / far - 1.0L) < unsure) return -1;
        if (magnet && std::abs(off / fixed - 1.0L) < unsure) return -1;
        if (size > far || (magnet && off < fixed)) return k;
    }
    return n;
}

}  // namespace

TEST_CASE("fractals escape in the step in which complex numbers of more digits do", "[texture][fractals]")
{
    constexpr std::array kKinds{PatternKind::Mandel, PatternKind::Julia, PatternKind::MagnetMandel,
                                PatternKind::MagnetJulia};
    Rng rng(1);
    std::array<int, 4> escaped{}, stayed{};
    for (int i = 0; i < 4000; ++i) {
        const auto which = static_cast<std::size_t>(i) % kKinds.size();
        const double n = 1.0 + rng.below(12);
        Pattern pattern;
        pattern.kind = kKinds[which];
        pattern.vector = rng.vector(1.0);
        // Exterior 1 tells the step as a share of all; interior 0 tells its factor, which no share is.
        pattern.numbers = {n, 2.0 + rng.below(3), 1.0, 1.0, 0.0, 7.0, 1.0 + rng.below(2)};
        const glm::dvec3 p = rng.vector(2.0);
        const int step = escape(pattern, p);
        if (step < 0) continue;
        INFO("case " << i << ", step " << step << " of " << n);
        const bool inside = step == static_cast<int>(n);
        ++(inside ? stayed : escaped)[which];
        CHECK(fractal(pattern, p) == (inside ? 7.0 : step / n));
    }
    for (std::size_t k = 0; k < kKinds.size(); ++k) CHECK((escaped[k] > 50 && stayed[k] > 50));
}
