#pragma once

#include "csg/base/points.h"
#include "render/scene/base/povray.h"

/// How mirrors and interfaces turn a ray (spec 3, section 8): D is glm::dvec3, or csg::lanes::Directions for many. The
/// same bits.
namespace trace {

template <class D>
using NumberOf = csg::lanes::NumberOf<D>;

/// What is mirrored about a normal with which it has a cosine.
template <class D>
[[gnu::always_inline]] inline D mirrored_about(const D& d, const D& normal, const NumberOf<D>& cosine)
{
    const NumberOf<D> twice = NumberOf<D>(2.0) * cosine;
    return {d.x - twice * normal.x, d.y - twice * normal.y, d.z - twice * normal.z};
}

/// Of unit length; `length`: what it was.
template <class D>
[[gnu::always_inline]] inline D unit_of(const D& v, NumberOf<D>& length)
{
    length = numbers::lanes::root_of(csg::lanes::dot(v, v));
    const NumberOf<D> over = NumberOf<D>(1.0) / length;
    return {v.x * over, v.y * over, v.z * over};
}

/// A mirrored direction at unit length: 3.8 divides where 3.7 multiplies by the reciprocal (spec 7d, 6).
template <class D>
[[gnu::always_inline]] inline D mirrored_unit(const D& v, scene::PovRay povray)
{
    NumberOf<D> length;
    const D by_reciprocal = unit_of(v, length);
    if (povray == scene::PovRay::V37) return by_reciprocal;
    return {v.x / length, v.y / length, v.z / length};
}

/// The direction behind an interface. A unit vector already as a rule, up to rounding; csg::World wants unit
/// directions, so it is made exact.
/// \param d        as long as POV-Ray's direction
/// \param ratio    of the indices, incoming over outgoing
/// \param stretch  RayState::stretch behind it
/// \param total    the ray is mirrored within, and has no direction
template <class D>
[[gnu::always_inline]] inline D bent_behind(const D& d, const D& normal, const NumberOf<D>& ratio, NumberOf<D>& stretch,
                                            csg::lanes::TruthOf<D>& total)
{
    using namespace csg::lanes;
    using T = csg::lanes::NumberOf<D>;
    constexpr double kRounding = 1e-9;  // but for normals that no_bump_scale leaves longer or shorter
    const T zero(0.0), one(1.0), facing = dot(d, normal), c = size_of(facing), k = one + ratio * ratio * (c * c - one),
                                 along = ratio * c - root_of(k);
    total = k < zero;
    const Truth<T> outward = facing <= zero;
    const auto bent = [&](const T& of, const T& n) { return ratio * of + along * choose(outward, n, negated(n)); };
    T length;
    const D out = unit_of(D{bent(d.x, normal.x), bent(d.y, normal.y), bent(d.z, normal.z)}, length);
    stretch = choose(size_of(length - one) > T(kRounding), length, one);
    return out;
}

}  // namespace trace
