#include "csg/freeform/field/julia.h"

#include "csg/freeform/field/julia_functions.h"
#include "csg/freeform/field/julia_march.h"
#include "numbers/lane_power.h"

#include <algorithm>
#include <cmath>

namespace csg {
namespace {

using Function = JuliaTerms::Function;

constexpr double kQuaternionReach = 2.0, kHyperReach = 4.0;

/// How the size of an orbit's last point n grows with x, y and z; v is the derivative of the orbit (spec 5b, 12.3).
glm::dvec3 growth(const glm::dvec4& v, const glm::dvec4& n)
{
    return {v.x * n.x + v.y * n.y + v.z * n.z + v.w * n.w, -v.y * n.x + v.x * n.y - v.w * n.z + v.z * n.w,
            -v.z * n.x - v.w * n.y + v.x * n.z + v.y * n.w};
}

}  // namespace

struct Julia::Orbit {
    bool escaped;
    double size;       ///< of the last point, squared
    glm::dvec3 slope;  ///< of the size, up to a factor
};

Julia::Julia(const JuliaTerms& terms) : terms_(terms), step_(1.0 / terms.precision)
{
    const glm::dvec4 n = terms.slice / std::sqrt(glm::dot(terms.slice, terms.slice));
    tilt_ = glm::dvec3(n) / n.w;
    offset_ = terms.slice_distance / n.w;  // not divided by the length of the normal: POV-Ray's way
    const double size = std::sqrt(glm::dot(terms.constant, terms.constant));
    radius_ = quaternion() ? std::min(kQuaternionReach, 1.0 + size + julia::kNearest) : kHyperReach;
    escape_ = quaternion() ? radius_ * radius_ + julia::kNearest : radius_ * radius_;
}

/// POV-Ray starts the orbits of functions with y where z belongs, except while it marches (spec 5b, 12.1).
glm::dvec4 Julia::plain_start(const glm::dvec3& p) const
{
    glm::dvec4 q = lifted(p);
    if (terms_.as_37 && terms_.function > Function::Reciprocal) q.z = q.y;
    return q;
}

double Julia::size(const glm::dvec4& q) const
{
    return terms_.function == Function::HyperSquare ? julia::norm<true>(q) : julia::norm(q);
}

bool Julia::stays(const glm::dvec3& p) const
{
    glm::dvec4 q = plain_start(p);
    const auto all = [&](auto&& next) {
        for (int k = 0;; q = next(q) + terms_.constant) {
            if (gone(q)) return false;
            if (++k == terms_.iterations) return true;
        }
    };
    switch (terms_.function) {
    case Function::Square: return all([](const glm::dvec4& v) { return julia::square(v); });
    case Function::Cube: return all([](const glm::dvec4& v) { return julia::cube(v); });
    case Function::HyperSquare:
    case Function::HyperCube: return all([](const glm::dvec4& v) { return julia::product(v, v); });
    default: return all([&](const glm::dvec4& v) { return julia::apply(terms_, v); });
    }
}

Julia::Orbit Julia::follow(glm::dvec4 q) const
{
    glm::dvec4 v = q;
    double factor = 2.0;  // of the derivative of k squares: 2^k, and 2 for none
    int k = 0;
    for (; k < terms_.iterations && !gone(q); ++k) {
        const glm::dvec4 next = julia::apply(terms_, q);
        if (k > 0) {
            factor *= 2.0;
            v = julia::product(julia::rate(terms_, q, next), v);
        }
        q = next + terms_.constant;
    }
    const glm::dvec4 n = terms_.function == Function::HyperSquare ? factor * q : q;  // POV-Ray forgets it for the cube
    return {k < terms_.iterations, size(q), growth(v, n)};
}

Julia::March Julia::look_quaternion(const glm::dvec3& p) const
{
    glm::dvec4 q = lifted(p);
    const bool square = terms_.function == Function::Square;
    double sizes = 1.0, scale = 1.0;  // squares of the sizes so far, multiplied; p^(k + 1)
    for (int k = 0; k < terms_.iterations; ++k) {
        const double size = julia::norm(q);
        scale *= square ? 2.0 : 3.0;
        if (!(size <= escape_))
            return {false, (size < kMostSize ? lanes::logarithm(size) : size) / (scale * std::sqrt(sizes))};
        sizes *= size;
        q = (square ? julia::square(q) : julia::cube(q)) + terms_.constant;
    }
    return {true, step_};
}

Julia::March Julia::look(const glm::dvec3& p, const glm::dvec3& way) const
{
    if (quaternion()) return look_quaternion(p);
    const Orbit orbit = follow(lifted(p));
    if (!orbit.escaped) return {true, step_};
    const double slope = glm::dot(orbit.slope, way), fall = -2.0 * slope, size = orbit.size;
    const bool guess = slope < julia::kLeastSlope && size > julia::kLeastGuess * step_ * fall &&
                       size < julia::kMostGuess * step_ * fall;
    return {false, guess ? size / fall : step_};
}

glm::dvec3 Julia::into(const Transform& frame, const glm::dvec3& point) const
{
    // From far away the sum would cost the digits that the difference keeps.
    const double far = julia::kManyRadii * radius_;
    if (!(glm::dot(frame.inverse_offset, frame.inverse_offset) < far * far)) return frame.inverse_point(point);
    return frame.inverse_linear * point + frame.inverse_offset;
}

void Julia::intersect(const Ray& ray, IntersectionList& out, bool moved) const
{
    if (whole()) return intersect_whole(ray, out);
    const julia::Way way(ray, moved, !terms_.as_37, radius_, out);
    if (!way.meets) return;
    const Ray& unit = way.unit;
    double t = way.begin;
    March at = look(unit.at(t), unit.direction);
    if (at.inside) {
        t += 2.0 * julia::kNearest;
        at = look(unit.at(t), unit.direction);
    }
    if (at.inside && !out.enter(way.world(way.entry), kUndrawnFace)) return;
    while (true) {
        double step = std::max(at.step, step_);
        if (!way.goes_on(t, step)) break;
        const March next = look(unit.at(t + step), unit.direction);
        if (next.inside != at.inside) {
            double same = t;  // still as it was
            const double behind = t + step;
            while (step > way.nearest) {
                step *= 0.5;
                if (stays(unit.at(same + step)) == at.inside) same += step;
            }
            if (!(at.inside ? out.leave(way.world(same), 0) : out.enter(way.world(same, step), 0))) return;
            if (out.first_only) return;  // POV-Ray looks no farther, though the crossing may be too near to count
            t = behind;
        } else {
            t += step;
        }
        at = next;
    }
    if (at.inside) out.leave(way.world(way.exit), kUndrawnFace);
}

bool Julia::contains(const glm::dvec3& p) const { return stays(p); }

/// The rows of the Jacobian times the orbit's last point; w is taken as fixed (spec 5b, 12.3).
glm::dvec3 Julia::quaternion_slope(glm::dvec4 q) const
{
    glm::dvec4 rows[3] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    const bool square = terms_.function == Function::Square;
    for (int k = 0; k < terms_.iterations; ++k) {
        const double x = q.x, y = q.y, z = q.z, w = q.w, n = y * y + z * z + w * w;
        for (glm::dvec4& r : rows) {
            if (square) {
                r = {r.x * x - r.y * y - r.z * z - r.w * w, r.x * y + r.y * x, r.x * z + r.z * x, r.x * w + r.w * x};
            } else {
                const double turn = 2.0 * (r.y * y + r.z * z + r.w * w), along = 6.0 * x * r.x - turn,
                             other = 3.0 * x * x - n;
                r = {3.0 * (r.x * (x * x - n) - x * turn), r.y * other + y * along, r.z * other + z * along,
                     r.w * other + w * along};
            }
        }
        q = (square ? julia::square(q) : julia::cube(q)) + terms_.constant;
    }
    return {glm::dot(rows[0], q), glm::dot(rows[1], q), glm::dot(rows[2], q)};
}

glm::dvec3 Julia::gradient(const glm::dvec3& p, std::uint32_t) const
{
    if (whole()) return whole_gradient(p);
    if (quaternion()) return quaternion_slope(plain_start(p));
    // Where the plain orbit escapes POV-Ray goes on with what the last look has left: the orbit of the same point as
    // marched.
    glm::dvec4 plain = plain_start(p), q = plain, marched = lifted(p), v = q;
    bool left = false;
    for (int k = 0; k < terms_.iterations; ++k) {
        if (k > 0) v = julia::product(julia::rate(terms_, q, julia::apply(terms_, q)), v);
        left = left || gone(plain);
        plain = julia::apply(terms_, plain) + terms_.constant;
        marched = julia::apply(terms_, marched) + terms_.constant;
        q = left ? marched : plain;
    }
    return growth(v, q);
}

}  // namespace csg
