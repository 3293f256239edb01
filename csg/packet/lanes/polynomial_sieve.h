#pragma once

#include "csg/packet/lanes/tile_rays.h"
#include "csg/solids/polynomial.h"
#include "csg/solids/shared/polynomial_rays.h"

/// Which rays of a tile may meet the surface of a polynomial.
namespace csg {

namespace detail {

/// Lanes of `asked` on which a polynomial may change its sign in the range of its ordinates, which are off by `error`
/// at most: infinite or no number where any of them is.
inline std::uint32_t may_change(const PolynomialRays<lanes::Double>& ordinates, std::size_t degree,
                                const lanes::Double& error, std::uint32_t asked, int halvings)
{
    using lanes::Double;
    Double least = ordinates.v[0], most = least;
    for (std::size_t i = 1; i <= degree; ++i) {
        least = lanes::smaller(least, ordinates.v[i]);
        most = lanes::larger(most, ordinates.v[i]);
    }
    const std::uint32_t none = lanes::mask((least > error) | (most < lanes::negated(error)));
    const std::uint32_t left = asked & ~none;
    // What has different signs at its ends surely does.
    const std::uint32_t sure = lanes::mask(ordinates.v[0] * ordinates.v[degree] < Double(0.0)), open = left & ~sure;
    if (open == 0 || halvings == 0) return left;
    PolynomialRays<Double> lower, upper = ordinates;
    upper.halve(degree, lower);
    std::uint32_t found = left & sure;
    found |= may_change(lower, degree, error, open, halvings - 1);
    if (const std::uint32_t rest = open & ~found; rest != 0)
        found |= may_change(upper, degree, error, rest, halvings - 1);
    return found;
}

}  // namespace detail

/// Whether rays_near() serves the solid: those of low degree are solved as quickly as sieved.
inline bool has_sieve(const Polynomial& solid)
{
    return solid.shape->degree() > 4 && solid.shape->degree() <= kMostRowDegree;
}

/// The rays that may meet the surface between t_min and limit. each_crossing() would find no crossing of the others
/// there: it decides by the same ordinates.
template <class Rays>
inline RayMask rays_near(const Polynomial& solid, const Rays& rays, RayMask asked)
{
    using lanes::Double;
    constexpr RayMask kVector = (RayMask{1} << lanes::kDoubles) - 1;
    constexpr int kHalvings = 4;
    const PolynomialShape& shape = *solid.shape;
    const auto degree = static_cast<std::size_t>(shape.degree());
    RayMask out = 0;
    each_vector(asked, [&](int i) {
        const lanes::Directions d = lanes::turned(solid.frame, rays.directions(i));
        const auto o = lanes::into(solid.frame, rays.origins(i));
        detail::PolynomialCourse<Double> course(shape, {{Double(o.x), Double(o.y), Double(o.z)}, {d.x, d.y, d.z}});
        course.clip(Double::load_aligned(rays.t_min.data() + i), Double::load_aligned(rays.limit.data() + i));
        const auto possible = static_cast<std::uint32_t>(lanes::mask(course.possible) & (asked >> i) & kVector);
        if (possible == 0) return;
        PolynomialRays<Double> c, ordinates;
        shape.sum_along(course.ray, c);
        while (c.count <= degree) c.v[c.count++] = Double(0.0);
        const std::uint32_t sure = possible & lanes::mask(shape.has_degree(c.v[degree]));
        std::uint32_t near = possible & ~sure;
        if (sure != 0) {
            shape.bound(c.v.data(), shape.degree(), course.lo, course.hi);
            const Double error = detail::ordinates_between(c.v.data(), degree, course.lo, course.hi, ordinates);
            near |= detail::may_change(ordinates, degree, error, sure, kHalvings);
        }
        out |= RayMask{near} << i;
    });
    return out;
}

}  // namespace csg
