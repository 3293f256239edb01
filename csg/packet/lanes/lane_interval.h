#pragma once

#include "numbers/lane_arithmetic.h"
#include "csg/solids/sphere.h"

/// Intervals of several rays, from one point or each from its own. Every number comes from the same operations in the
/// same order as for one ray (csg/solids), so that both answers are the same to the last bit: change them together.
namespace csg::lanes {

/// Directions of kDoubles rays.
struct Directions {
    Double x, y, z;

    Directions in(const Transform& frame) const
    {
        const glm::dmat3& m = frame.inverse_linear;
        return {Double(m[0][0]) * x + Double(m[1][0]) * y + Double(m[2][0]) * z,
                Double(m[0][1]) * x + Double(m[1][1]) * y + Double(m[2][1]) * z,
                Double(m[0][2]) * x + Double(m[1][2]) * y + Double(m[2][2]) * z};
    }
    Double square() const { return x * x + y * y + z * z; }
};

/// Origins of kDoubles rays. What follows is written for these and for one origin that all share.
struct Points {
    Double x, y, z;
};

inline glm::dvec3 difference(const glm::dvec3& a, const glm::dvec3& b) { return a - b; }
inline Points difference(const Points& a, const glm::dvec3& b)
{
    return {a.x - Double(b.x), a.y - Double(b.y), a.z - Double(b.z)};
}
inline Points difference(const glm::dvec3& a, const Points& b)
{
    return {Double(a.x) - b.x, Double(a.y) - b.y, Double(a.z) - b.z};
}

inline glm::dvec3 into(const Transform& frame, const glm::dvec3& p) { return frame.inverse_point(p); }
inline Points into(const Transform& frame, const Points& p)
{
    const Points from = difference(p, frame.offset);
    const Directions v = Directions{from.x, from.y, from.z}.in(frame);
    return {v.x, v.y, v.z};
}

inline double along(const glm::dvec3& n, const glm::dvec3& p) { return glm::dot(n, p); }
inline Double along(const glm::dvec3& n, const Points& p)
{
    return Double(n.x) * p.x + Double(n.y) * p.y + Double(n.z) * p.z;
}

/// What Interval is for one ray, with faces as numbers. Where `met` is false the rest means nothing.
struct Intervals {
    Double entry, exit, entry_face = Double(0.0), exit_face = Double(0.0);
    Bool met = Bool(false);
    Bool unclear = Bool(false);  ///< perhaps more than one interval: to be asked ray by ray; only a quadric says so
};

/// sphere_roots; f runs from the centre to the rays' origins.
template <class P>
inline Intervals sphere_roots(const P& f, const Directions& d, Double inverse_a, double radius)
{
    Intervals out;
    const Double x(f.x), y(f.y), z(f.z);
    const Double foot_t = negated(x * d.x + y * d.y + z * d.z) * inverse_a;
    const Double fx = x + foot_t * d.x, fy = y + foot_t * d.y, fz = z + foot_t * d.z;
    const Double below = Double(radius * radius) - (fx * fx + fy * fy + fz * fz);
    out.met = below > Double(0.0);
    if (mask(out.met) == 0) return out;
    const Double correction = negated(fx * d.x + fy * d.y + fz * d.z) * inverse_a;
    const Double half = xsimd::sqrt(below * inverse_a);
    out.entry = foot_t + (correction - half);
    out.exit = foot_t + (correction + half);
    out.met = out.met & (out.entry <= out.exit) & (out.exit < beyond()) & (out.entry > before());
    return out;
}

/// slab() of one coordinate, 0 lower and 1 upper as faces.
inline Intervals slab(Double origin, Double direction, double lower, double upper)
{
    const Double a = (Double(lower) - origin) / direction, b = (Double(upper) - origin) / direction;
    const Bool forward = direction > Double(0.0), along = direction == Double(0.0);
    const Bool within = (origin >= Double(lower)) & (origin <= Double(upper));
    Intervals out;
    out.entry = xsimd::select(along, before(), xsimd::select(forward, a, b));
    out.exit = xsimd::select(along, beyond(), xsimd::select(forward, b, a));
    out.entry_face = xsimd::select(forward | along, Double(0.0), Double(1.0));
    out.exit_face = xsimd::select(forward & (!along), Double(1.0), Double(0.0));
    out.met = (along & within) | ((!along) & (out.entry <= out.exit));
    return out;
}

/// narrow(): keeps what both hold; on equal ends the face of `a` stays.
inline void narrow(Intervals& a, Double entry, Double exit, Double face)
{
    const Bool later = entry > a.entry, earlier = exit < a.exit;
    a.entry = xsimd::select(later, entry, a.entry);
    a.entry_face = xsimd::select(later, face, a.entry_face);
    a.exit = xsimd::select(earlier, exit, a.exit);
    a.exit_face = xsimd::select(earlier, face, a.exit_face);
    a.met = a.met & (a.entry <= a.exit);
}

}  // namespace csg::lanes
