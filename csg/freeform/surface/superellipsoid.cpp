#include "csg/freeform/surface/superellipsoid.h"

#include "numbers/functions/functions.h"
#include "numbers/safeguarded_newton.h"

#include <cmath>
#include <utility>

namespace csg {
namespace {

constexpr double kSkin = 1e-10;        // POV-Ray's inside reaches this far beyond the surface (spec 5a, 2.4)
constexpr double kClear = 1.0 + 1e-9;  // scale of the polyhedron around the surface from which Newton's steps begin
constexpr int kMostHalvings = 40;

/// (u^p + v^p)^(1/p) of numbers that are not negative, and its derivatives by both.
struct Norm {
    double value = 0.0, by_u = 0.0, by_v = 0.0;

    Norm(double u, double v, double p)
    {
        const bool swapped = u < v;
        const double most = swapped ? v : u, least = swapped ? u : v;
        if (!(most > 0.0)) return;
        const double ratio = least / most, power = numbers::pow(ratio, p), root = numbers::pow(1.0 + power, 1.0 / p);
        value = most * root;
        const double by_most = root / (1.0 + power);
        // At 0 the limit: |v| itself where p = 1, flat above, a spike below.
        const double by_least = ratio > 0.0 ? by_most * (power / ratio) : p > 1.0 ? 0.0 : p == 1.0 ? 1.0 : kInfinity;
        by_u = swapped ? by_least : by_most;
        by_v = swapped ? by_most : by_least;
    }
};

double norm(double u, double v, double p)
{
    const double most = std::max(u, v);
    if (!(most > 0.0)) return 0.0;
    return most * numbers::pow(1.0 + numbers::pow(std::min(u, v) / most, p), 1.0 / p);
}

/// The derivative of |o + t d| by t at t = 0, from the right.
double rate(double o, double d) { return o > 0.0 || (o == 0.0 && d > 0.0) ? d : -d; }

/// factor * [low, high] added to [sum_low, sum_high]; 0 times infinity is nothing.
void add_scaled(double factor, double low, double high, double& sum_low, double& sum_high)
{
    if (factor == 0.0) return;
    sum_low += factor * (factor > 0.0 ? low : high);
    sum_high += factor * (factor > 0.0 ? high : low);
}

}  // namespace

Superellipsoid::Superellipsoid(double e, double n)
    : across_(2.0 / e), along_(2.0 / n), convex_(across_ >= 1.0 && along_ >= 1.0)
{
    if (!convex_) return;
    const double widest = numbers::pow(2.0, 1.0 - 1.0 / across_);  // of |x| + |y| where the flat length is 1
    edge_ = kClear * widest;
    rim_ = kClear * numbers::pow(2.0, 1.0 - 1.0 / along_);
    // Hoelder: the most of widest h + |z| where h^c + |z|^c is 1.
    const double dual = along_ > 1.0 ? (std::isinf(along_) ? 1.0 : along_ / (along_ - 1.0)) : kInfinity;
    corner_ = kClear * norm(widest, 1.0, dual);
}

double Superellipsoid::excess(const glm::dvec3& p) const
{
    const glm::dvec3 q = glm::abs(p);
    return norm(norm(q.x, q.y, across_), q.z, along_) - 1.0;
}

bool Superellipsoid::contains(const glm::dvec3& p) const { return excess(p) < kSkin; }

glm::dvec3 Superellipsoid::gradient(const glm::dvec3& p, std::uint32_t) const
{
    const Norm flat(std::abs(p.x), std::abs(p.y), across_), whole(flat.value, std::abs(p.z), along_);
    // POV-Ray gives a coordinate of 0 no part, also at an edge.
    const auto part = [](double at, double by) { return at != 0.0 ? std::copysign(by, at) : 0.0; };
    return {part(p.x, whole.by_u * flat.by_u), part(p.y, whole.by_u * flat.by_v), part(p.z, whole.by_v)};
}

Superellipsoid::Slope Superellipsoid::along(const Line& line, double t) const
{
    const glm::dvec3 p = line.at(t), q = glm::abs(p);
    const Norm flat(q.x, q.y, across_), whole(flat.value, q.z, along_);
    double slope = 0.0;
    const auto add = [&](double by, double d) { slope += d != 0.0 ? by * d : 0.0; };
    add(whole.by_u * flat.by_u, rate(p.x, line.direction.x));
    add(whole.by_u * flat.by_v, rate(p.y, line.direction.y));
    add(whole.by_v, rate(p.z, line.direction.z));
    return {whole.value - 1.0, slope};
}

/// Whether the length only grows or only shrinks on [a, b], by bounds of its derivative there: the share of each
/// coordinate depends on quotients alone, and these run one way along a line.
bool Superellipsoid::slope_has_sign(const Line& line, double a, double b) const
{
    const glm::dvec3 p = glm::abs(line.at(a)), q = glm::abs(line.at(b)), middle = line.at(0.5 * (a + b));
    const glm::dvec3 d(rate(middle.x, line.direction.x), rate(middle.y, line.direction.y),
                       rate(middle.z, line.direction.z));
    const auto one_way = [](double x, double y, double z) {
        return (x >= 0.0 && y >= 0.0 && z >= 0.0) || (x <= 0.0 && y <= 0.0 && z <= 0.0);
    };
    if (one_way(d.x, d.y, d.z)) return true;
    const Norm first(p.x, p.y, across_), last(q.x, q.y, across_);
    double low = 0.0, high = 0.0;
    add_scaled(d.x, std::min(first.by_u, last.by_u), std::max(first.by_u, last.by_u), low, high);
    add_scaled(d.y, std::min(first.by_v, last.by_v), std::max(first.by_v, last.by_v), low, high);
    // The flat length h and |z| over it: h between its values for the least and for the most of x and y.
    const double h_low = norm(std::min(p.x, q.x), std::min(p.y, q.y), across_),
                 h_high = norm(std::max(p.x, q.x), std::max(p.y, q.y), across_);
    const Norm most_flat(h_high, std::min(p.z, q.z), along_), least_flat(h_low, std::max(p.z, q.z), along_);
    const double by_h[2] = {std::min(most_flat.by_u, least_flat.by_u), std::max(most_flat.by_u, least_flat.by_u)};
    double sum_low = 0.0, sum_high = 0.0;
    add_scaled(d.z, std::min(most_flat.by_v, least_flat.by_v), std::max(most_flat.by_v, least_flat.by_v), sum_low,
               sum_high);
    sum_low += low < 0.0 ? low * by_h[1] : low * by_h[0];
    sum_high += high > 0.0 ? high * by_h[1] : high * by_h[0];
    return sum_low >= 0.0 || sum_high <= 0.0;  // NaN: it may turn
}

/// found(t) at each change of sign in `in`, in order; `excess` at both of its ends.
template <class F>
bool Superellipsoid::each_change(const Line& line, Range in, Range ends, int depth, F&& found) const
{
    const bool changes = (ends.low > 0.0) != (ends.high > 0.0);
    // Exponents up to 1: the length is concave within an octant.
    const bool concave = across_ <= 1.0 && along_ <= 1.0;
    if (!changes && concave && ends.low > 0.0) return true;
    if (!changes) {
        // It grows with every coordinate, and each of them is least and most at an end.
        const glm::dvec3 p = glm::abs(line.at(in.low)), q = glm::abs(line.at(in.high));
        if (ends.low > 0.0 ? excess(glm::min(p, q)) > 0.0 : excess(glm::max(p, q)) <= 0.0) return true;
    }
    if ((concave && changes) || slope_has_sign(line, in.low, in.high)) {
        if (!changes) return true;
        const bool rises = ends.high > 0.0;
        const auto at = [&](double t) {
            const Slope here = along(line, t);
            return ValueAndSlope{here.value, here.slope};
        };
        return found(safeguarded_newton(at, in.low, in.high, rises, 0.5 * (in.low + in.high), {0.0, 1e-15}, 200));
    }
    const double middle = 0.5 * (in.low + in.high);
    if (depth == 0) return !changes || found(middle);
    const double value = excess(line.at(middle));
    return each_change(line, {in.low, middle}, {ends.low, value}, depth - 1, found) &&
           each_change(line, {middle, in.high}, {value, ends.high}, depth - 1, found);
}

void Superellipsoid::meet_any(const Line& line, Range in_cube, double start, IntersectionList& out) const
{
    const auto [from, to] = in_cube;
    double cuts[5] = {from};
    int count = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double t = -line.origin[axis] / line.direction[axis];
        if (!(t > from && t < to)) continue;
        int at = count++;
        for (; at > 1 && cuts[at - 1] > t; --at) cuts[at] = cuts[at - 1];
        cuts[at] = t;
    }
    cuts[count] = to;
    double value = excess(line.at(from));
    bool inside = !(value > 0.0), more = !inside || out.enter(-kInfinity, kUndrawnFace);
    const auto cross = [&](double t) {
        inside = !inside;
        more = inside ? out.enter(start + t, 0) : out.leave(start + t, 0);
        return more;
    };
    for (int i = 0; i < count && more; ++i) {
        const double next = excess(line.at(cuts[i + 1]));
        each_change(line, {cuts[i], cuts[i + 1]}, {value, next}, kMostHalvings, cross);
        value = next;
    }
}

void Superellipsoid::intersect(const Ray& ray, IntersectionList& out) const
{
    if (convex_) return intersect_many({&ray, 1}, &out);
    const double length = std::sqrt(glm::dot(ray.direction, ray.direction));
    const double start = -glm::dot(ray.origin, ray.direction) / (length * length);
    if (!std::isfinite(start) || std::isnan(across_) || std::isnan(along_)) return;
    // From the point nearest to the middle, so that the way there does not set the rounding.
    const Line line{ray.at(start), ray.direction};
    double from = -kInfinity, to = kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
        const double o = line.origin[axis], d = line.direction[axis];
        if (d == 0.0) {
            if (std::abs(o) > kReach) return;
            continue;
        }
        const double inverse = 1.0 / d, a = (-kReach - o) * inverse, b = (kReach - o) * inverse;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    if (!(from < to) || start + from > out.to || start + to < out.from) return;
    meet_any(line, {from, to}, start, out);
}

}  // namespace csg
