#pragma once

#include "csg/packet/lanes/tile_rays.h"
#include "csg/solids/extrusion.h"

/// Which rays of a tile come near a prism or a letter.
namespace csg {

/// The rays that meet the solid's box in its own space between t_min and limit. Flat letters that stand askew fill
/// little of their box in the world: three of four rays that meet that one miss this.
template <class Rays>
inline RayMask rays_near(const Extrusion& solid, const Rays& rays, RayMask asked)
{
    using lanes::Double;
    const glm::dvec3 lower(solid.shape->lower(), solid.low), upper(solid.shape->upper(), solid.high);
    // Far more than the roundings of where walls are found.
    constexpr double kMargin = 1e-10;
    const glm::dvec3 size = glm::max(glm::abs(lower), glm::abs(upper));
    const Double own(kMargin * (size.x + size.y + size.z)), one(1.0);
    RayMask out = 0;
    each_vector(asked, [&](int i) {
        const auto o = lanes::into(solid.frame, rays.origins(i));
        const lanes::Directions d = lanes::turned(solid.frame, rays.directions(i));
        const Double x(o.x), y(o.y), z(o.z);
        const Double room = own + Double(kMargin) * (xsimd::abs(x) + xsimd::abs(y) + xsimd::abs(z));
        Double first = Double::load_aligned(rays.t_min.data() + i), last = Double::load_aligned(rays.limit.data() + i);
        const auto axis = [&](const Double& from, const Double& direction, double low, double high) {
            const Double inverse = one / direction;
            const Double a = (Double(low) - room - from) * inverse, b = (Double(high) + room - from) * inverse;
            first = xsimd::max(first, xsimd::min(a, b));
            last = xsimd::min(last, xsimd::max(a, b));
        };
        axis(x, d.x, lower.x, upper.x);
        axis(y, d.y, lower.y, upper.y);
        axis(z, d.z, lower.z, upper.z);
        out |= RayMask{lanes::mask(first <= last)} << i;
    });
    return out & asked;
}

}  // namespace csg
