#include "csg/freeform/field/julia.h"
#include "csg/freeform/field/julia_march.h"
#include "csg/freeform/field/julia_ranges.h"

#include <algorithm>

/// Every crossing of a line with a set whose function is a polynomial.
namespace csg {
namespace {

// Relative to the radius of the sphere that holds the set:
constexpr double kAround = 1e-6;  // the ray is followed from this far outside of the sphere, which the set may touch
constexpr double kShort = 1e-6;   // the shortest stretch that is divided
constexpr double kPlace = 1e-12;  // how exactly a crossing is found
constexpr double kBeyond = 0.01;  // relative to the range asked for: how far beyond its ends the ray is followed
constexpr int kMostDivisions = 48;

}  // namespace

/// What is certain of every point of the segment from p - half to p + half: the orbits of all of them at once, each
/// number a range.
Julia::Where Julia::where(const glm::dvec3& p, const glm::dvec3& half) const
{
    julia::OrbitPart q;
    q.a = lifted(p);
    q.b = {half, -glm::dot(tilt_, half)};
    bool crosses = false;
    for (int k = 1;; ++k) {
        const julia::SizeRange size(q);
        if (size.low > escape_) return Where::Outside;
        if (!(size.high <= escape_)) {
            if (crosses || !size.one_way) return Where::Unknown;
            crosses = true;
        }
        if (k >= terms_.iterations) return crosses ? Where::CrossesOnce : Where::Inside;
        q = julia::apply(terms_.function, q);
        q.a += terms_.constant;
    }
}

/// Halves stretches of the ray until each is certainly inside, certainly outside, crossed once, or too short.
void Julia::intersect_whole(const Ray& ray, IntersectionList& out) const
{
    const julia::Way way(ray, true, false, (1.0 + kAround) * radius_, out);
    if (!way.meets) return;
    const Ray& unit = way.unit;
    const double from = out.from * way.length - way.start, to = out.to * way.length - way.start;
    const double spare = to - from < kInfinity ? kBeyond * (to - from) + kShort * radius_ : 0.0;
    double t = std::max(way.entry, from - spare);
    const double end = std::min(way.exit, to + spare), shortest = kShort * radius_;
    bool inside = stays(unit.at(t));
    if (inside && !out.enter(way.world(t), kUndrawnFace)) return;
    const auto change = [&](double low, double high) {
        while (high - low > kPlace * radius_) {
            const double middle = 0.5 * (low + high);
            if (!(middle > low && middle < high)) break;
            (stays(unit.at(middle)) == inside ? low : high) = middle;
        }
        inside = !inside;
        return inside ? out.enter(way.world(high), 0) : out.leave(way.world(low), 0);
    };
    double ends[kMostDivisions];  // of the parts that are next, the nearest last
    int next = 0;
    ends[next++] = end;
    while (next > 0) {
        const double far = ends[next - 1], half = 0.5 * (far - t);
        const Where here = where(unit.at(t + half), half * unit.direction);
        if (here == Where::Unknown && far - t > shortest && next < kMostDivisions) {
            ends[next++] = t + half;
            continue;
        }
        const bool after = here == Where::Inside || (here != Where::Outside && stays(unit.at(far)));
        if (after != inside && !change(t, far)) return;
        t = far;
        --next;
    }
    if (inside) out.leave(way.world(end), kUndrawnFace);
}

/// The gradient of half the squared size of the orbit's largest member, the first to leave as p moves out of the set.
glm::dvec3 Julia::whole_gradient(const glm::dvec3& p) const
{
    glm::dvec3 slope(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        julia::OrbitPart q;
        q.a = lifted(p);
        q.b[axis] = 1.0;
        q.b.w = -tilt_[axis];
        double most = -kInfinity;
        for (int k = 0; k < terms_.iterations; ++k) {
            if (k > 0) {
                q = julia::apply(terms_.function, q);
                q.a += terms_.constant;
            }
            const double size = julia::norm(q.a);
            if (size <= most) continue;
            most = size;
            slope[axis] = glm::dot(q.a, q.b);
        }
    }
    return slope;
}

}  // namespace csg
