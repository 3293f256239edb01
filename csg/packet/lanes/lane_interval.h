#pragma once

#include "numbers/lane_arithmetic.h"
#include "csg/solids/shared/slab.h"
#include "csg/solids/sphere.h"

/// Intervals of several rays, from one point or each from its own: what csg/solids has for a ray, with a ray a lane.
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

/// f runs from the centre to the rays' origins.
template <class P>
inline Intervals sphere_intervals(const P& f, const Directions& d, Double inverse_a, double radius)
{
    const auto roots = sphere_roots(Double(f.x), Double(f.y), Double(f.z), d.x, d.y, d.z, inverse_a, Double(radius));
    Intervals out;
    out.entry = roots.near;
    out.exit = roots.far;
    out.met = roots.met;
    return out;
}

inline Intervals slab(const Double& origin, const Double& direction, double lower, double upper)
{
    Intervals out;
    out.met = csg::slab(origin, direction, lower, upper, out);
    return out;
}

inline void narrow(Intervals& a, const Double& entry, const Double& exit, const Double& face)
{
    const Bool met = a.met;
    a.met = csg::narrow(a, Intervals{entry, exit, face, face}) & met;
}

}  // namespace csg::lanes
