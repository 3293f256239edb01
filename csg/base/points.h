#pragma once

#include "csg/base/types.h"
#include "numbers/lane_arithmetic.h"

#include <type_traits>

/// Points and directions in lanes, and arithmetic that one of them, a glm::dvec3, and several go through alike: what
/// the test of a solid is written in, for a ray or for a ray a lane. Its start() is what depends on the rays' origins
/// alone.
namespace csg::lanes {

/// Directions of kDoubles rays.
struct Directions {
    Double x, y, z;
};

/// Origins of kDoubles rays.
struct Points {
    Double x, y, z;
};

/// Double, or double of a glm::dvec3.
template <class P>
using NumberOf = std::decay_t<decltype(P::x)>;
template <class P>
using TruthOf = Truth<NumberOf<P>>;
/// Of two, that which is in lanes if one is.
template <class A, class B>
using Wider = std::conditional_t<std::is_same_v<NumberOf<A>, double>, B, A>;

template <class A, class B>
inline Wider<A, B> difference(const A& a, const B& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline auto dot(const auto& a, const auto& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
/// p + t d.
template <class D>
inline D advanced(const auto& p, const auto& t, const D& d)
{
    return {p.x + t * d.x, p.y + t * d.y, p.z + t * d.z};
}

template <class D>
inline D times(const glm::dmat3& m, const D& v)
{
    return {m[0][0] * v.x + m[1][0] * v.y + m[2][0] * v.z, m[0][1] * v.x + m[1][1] * v.y + m[2][1] * v.z,
            m[0][2] * v.x + m[1][2] * v.y + m[2][2] * v.z};
}
/// Transform::inverse_vector() and inverse_point(), for one vector and for vectors in lanes.
inline auto turned(const Transform& frame, const auto& v) { return times(frame.inverse_linear, v); }
template <class P>
inline P into(const Transform& frame, const P& p)
{
    return turned(frame, difference(p, frame.offset));
}

}  // namespace csg::lanes
