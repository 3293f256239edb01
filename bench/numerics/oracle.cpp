#include "bench/numerics/oracle.h"

#include "bench/numerics/isolation.h"

#include <array>

namespace numerics {
namespace {

QuadPolynomial square(const QuadPolynomial& p) { return p * p; }
QuadPolynomial weighted(const glm::dvec3& w, const Point& p)
{
    return QuadPolynomial(w.x) * p.x + QuadPolynomial(w.y) * p.y + QuadPolynomial(w.z) * p.z;
}

Parts between(const glm::dvec3& lower, const glm::dvec3& upper, const Point& p)
{
    return {QuadPolynomial(lower.x) - p.x, p.x - QuadPolynomial(upper.x), QuadPolynomial(lower.y) - p.y,
            p.y - QuadPolynomial(upper.y), QuadPolynomial(lower.z) - p.z, p.z - QuadPolynomial(upper.z)};
}

/// (a + b t)^n by the binomial theorem: all terms of a coefficient have one sign, so it has n + 3 roundings of 113
/// bits.
QuadPolynomial power(const QuadPolynomial& p, int n)
{
    const auto count = static_cast<std::size_t>(n) + 1;
    const Quad a = p.c[0], b = p.c.size() > 1 ? p.c[1] : Quad(0);
    QuadPolynomial made;
    made.c.assign(count, 1);
    Quad rising = 1, binomial = 1;  // b^k; n over k, whole and below 2^113
    for (std::size_t k = 0; k < count; ++k) {
        made.c[k] = binomial * rising;
        rising *= b;
        binomial = binomial * static_cast<Quad>(n - static_cast<int>(k)) / static_cast<Quad>(k + 1);
    }
    Quad falling = 1;  // a^(n - k)
    for (std::size_t k = count; k-- > 0; falling *= a) made.c[k] *= falling;
    return made;
}

/// Powers 0 to n of a polynomial: each worked out by power() when it is first asked for, or, for the plain judge, all
/// at once by repeated multiplication.
class Powers {
public:
    Powers(const QuadPolynomial& base, int n)
        : base_(base), made_(static_cast<std::size_t>(n) + 1, QuadPolynomial(0)), known_(made_.size())
    {
        if (!plain_judge) return;
        made_[0] = QuadPolynomial(1);
        for (std::size_t i = 1; i < made_.size(); ++i) made_[i] = made_[i - 1] * base;
        known_.assign(made_.size(), true);
    }
    const QuadPolynomial& operator()(int n)
    {
        const auto i = static_cast<std::size_t>(n);
        if (!known_[i]) made_[i] = power(base_, n), known_[i] = true;
        return made_[i];
    }

private:
    const QuadPolynomial& base_;
    std::vector<QuadPolynomial> made_;
    std::vector<bool> known_;
};

std::vector<Quad> changes_of(const QuadPolynomial& p, Quad low, Quad high)
{
    if (!plain_judge)
        if (auto found = isolated_sign_changes(p, low, high)) return std::move(*found);
    return sign_changes(p, low, high);
}

}  // namespace

Point along(const csg::Ray& ray, double shift)
{
    const auto from = [&](int i) {
        return QuadPolynomial(ray.origin[i] + static_cast<Quad>(shift) * ray.direction[i], ray.direction[i]);
    };
    return {from(0), from(1), from(2)};
}

double foot(const csg::Transform& f, const csg::Ray& ray)
{
    const Point p = local(f, along(ray, 0.0));
    const auto coefficient = [&](std::size_t i, std::size_t k) {
        return p.x.c[i] * p.x.c[k] + p.y.c[i] * p.y.c[k] + p.z.c[i] * p.z.c[k];
    };
    return static_cast<double>(-coefficient(0, 1) / coefficient(1, 1));
}

Point local(const csg::Transform& f, const Point& p)
{
    const Point from{p.x - QuadPolynomial(f.offset.x), p.y - QuadPolynomial(f.offset.y),
                     p.z - QuadPolynomial(f.offset.z)};
    const auto row = [&](int i) {
        return weighted({f.inverse_linear[0][i], f.inverse_linear[1][i], f.inverse_linear[2][i]}, from);
    };
    return {row(0), row(1), row(2)};
}

Parts parts_of(const csg::Sphere& s, const Point& p)
{
    return {square(p.x - QuadPolynomial(s.center.x)) + square(p.y - QuadPolynomial(s.center.y)) +
            square(p.z - QuadPolynomial(s.center.z)) - square(QuadPolynomial(s.radius))};
}
Parts parts_of(const csg::Ellipsoid& s, const Point& world)
{
    const Point p = local(s.frame, world);
    return {square(p.x) + square(p.y) + square(p.z) - QuadPolynomial(1)};
}
Parts parts_of(const csg::Box& s, const Point& p) { return between(s.lower, s.upper, p); }
Parts parts_of(const csg::OrientedBox& s, const Point& p) { return between(s.lower, s.upper, local(s.frame, p)); }
Parts parts_of(const csg::Plane& s, const Point& p) { return {weighted(s.normal_out, p) - QuadPolynomial(s.offset)}; }
Parts parts_of(const csg::Cylinder& s, const Point& world)
{
    const Point p = local(s.frame, world);
    return {square(p.x) + square(p.y) - QuadPolynomial(1), QuadPolynomial(0) - p.z, p.z - QuadPolynomial(1)};
}
Parts parts_of(const csg::Cone& s, const Point& world)
{
    const Point p = local(s.frame, world);
    return {square(p.x) + square(p.y) - square(p.z), QuadPolynomial(s.low) - p.z, p.z - QuadPolynomial(1)};
}
Parts parts_of(const csg::Torus& s, const Point& world)
{
    const Point p = local(s.frame, world);
    const Quad major = s.major, minor = s.minor;
    const QuadPolynomial across = square(p.x) + square(p.z);
    return {square(across + square(p.y) + QuadPolynomial(major * major - minor * minor)) -
            QuadPolynomial(4 * major * major) * across};
}
Parts parts_of(const csg::Quadric& s, const Point& world)
{
    const Point p = local(s.frame, world);
    const Point squares{square(p.x), square(p.y), square(p.z)}, mixed{p.x * p.y, p.x * p.z, p.y * p.z};
    return {weighted(s.square, squares) + weighted(s.mixed, mixed) + weighted(s.linear, p) +
            QuadPolynomial(s.constant)};
}
Parts parts_of(const csg::Polynomial& s, const Point& world)
{
    const Point p = local(s.frame, world);
    const int n = s.shape->degree();
    Powers x(p.x, n), y(p.y, n), z(p.z, n);
    QuadPolynomial sum;
    std::size_t next = 0;
    for (int i = n; i >= 0; --i)
        for (int j = n - i; j >= 0; --j)
            for (int k = n - i - j; k >= 0; --k) {
                const double c = s.shape->coefficients()[next++];
                if (c != 0.0) sum = sum + QuadPolynomial(c) * x(i) * y(j) * z(k);
            }
    return {sum};
}

bool inside(const Parts& parts, Quad t)
{
    return std::all_of(parts.begin(), parts.end(), [&](const QuadPolynomial& p) { return p(t) <= 0; });
}

std::vector<Quad> crossings(const Parts& parts, Quad low, Quad high)
{
    std::vector<Quad> ends;
    for (const QuadPolynomial& p : parts)
        for (const Quad t : changes_of(p, low, high)) ends.push_back(t);
    std::sort(ends.begin(), ends.end());
    std::vector<Quad> found;
    bool was = inside(parts, low);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        const Quad behind = i + 1 < ends.size() ? ends[i + 1] : high;
        const bool is = inside(parts, (ends[i] + behind) / 2);
        if (is != was) found.push_back(ends[i]);
        was = is;
    }
    return found;
}

std::vector<Quad> crossings(const csg::Triangle& triangle, const csg::Ray& ray, Quad low, Quad high)
{
    using Vector = std::array<Quad, 3>;
    const auto wide = [](const glm::dvec3& v) { return Vector{v.x, v.y, v.z}; };
    const auto dot = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const auto cross = [](const Vector& a, const Vector& b) {
        return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    const auto sum = [](const Vector& a, const Vector& b, Quad sign) {
        return Vector{a[0] + sign * b[0], a[1] + sign * b[1], a[2] + sign * b[2]};
    };
    const Vector way = wide(ray.direction), a = sum(wide(triangle.corner), wide(ray.origin), -1);
    const Vector b = sum(a, wide(triangle.edge1), 1), c = sum(a, wide(triangle.edge2), 1);
    const Quad u = dot(way, cross(a, b)), v = dot(way, cross(b, c)), w = dot(way, cross(c, a));
    if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || u + v + w == 0) return {};
    const Vector n = cross(wide(triangle.edge1), wide(triangle.edge2));
    const Quad t = dot(a, n) / dot(way, n);
    return t >= low && t <= high ? std::vector<Quad>{t} : std::vector<Quad>{};
}

}  // namespace numerics
