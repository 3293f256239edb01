#pragma once

#include "numbers/functions/functions.h"
#include "numbers/functions/lane_functions.h"
#include "numbers/lane_arithmetic.h"
#include "render/light/light_set.h"

#include <algorithm>
#include <cmath>

/// What cones and distance leave of a light, for a point alone or for points in lanes (spec 3, 12.2 to 12.4). V is
/// double or lanes::Double, P has x, y and z of that type.
namespace light {

using numbers::lanes::choose;

/// POV-Ray's: a fade_distance below it counts as not given.
inline constexpr double kLeastFadeDistance = 1e-10;

/// v^power, with short cuts for the exponents that most scenes write, 1 and 2. At most one square in a thousand differs
/// from pow(), in its last bit. `asked`: the points that count.
template <class V, class Mask>
V raised(const V& v, double power, const Mask& asked)
{
    if (power == 1.0) return v;
    return power == 2.0 ? v * v : numbers::pow(choose(asked, v, V(1.0)), V(power));
}

/// A cubic between 0 at low and 1 at high.
template <class V>
V smooth_step(double low, double high, const V& x)
{
    const V t = (x - V(low)) / V(high - low), cubic = t * t * (V(3.0) - V(2.0) * t);
    return choose(x < V(low), V(0.0), choose(x >= V(high), V(1.0), cubic));
}

template <class V, class P>
V dot(const P& a, const glm::dvec3& b)
{
    return a.x * V(b.x) + a.y * V(b.y) + a.z * V(b.z);
}

/// The axis points away from the light, the direction toward it.
template <class V, class P, class Mask>
V spot(const Light& light, const P& direction, const V& distance, const Mask& asked)
{
    const V zero(0.0), u = -dot<V>(direction, light.axis), ahead = choose(distance <= zero, -u, u);
    const bool bounded = light.cos_radius > 0.0;  // by a cone, beyond which it is dark
    const Mask lit = asked & (ahead > zero) &
                     (ahead >= V(bounded ? std::min(light.cos_radius, light.cos_falloff) : 0.0));
    if (numbers::lanes::mask(lit) == 0) return zero;
    V factor = light.tightness == 0.0 ? V(1.0) : raised(ahead, light.tightness, lit);
    if (bounded)
        factor = choose(ahead < V(light.cos_radius), factor * smooth_step(light.cos_falloff, light.cos_radius, ahead),
                        factor);
    return choose(lit, factor, zero);
}

template <class V, class P, class Mask>
V cylinder(const Light& light, const P& point, const Mask& asked)
{
    const glm::dvec3 &from = light.location, &axis = light.axis;
    const V x = point.x - V(from.x), y = point.y - V(from.y), z = point.z - V(from.z);
    const V along = x * V(axis.x) + y * V(axis.y) + z * V(axis.z);
    const V bx = x - along * V(axis.x), by = y - along * V(axis.y), bz = z - along * V(axis.z);
    const V beside = numbers::lanes::root_of(bx * bx + by * by + bz * bz), inside = V(1.0) - beside / V(light.falloff);
    const Mask lit = asked & (along > V(0.0)) & (beside < V(light.falloff));
    if (numbers::lanes::mask(lit) == 0) return V(0.0);
    V factor = light.tightness == 0.0 ? V(1.0) : raised(inside, light.tightness, lit);
    if (light.radius > 0.0)
        factor = choose(beside > V(light.radius), factor * smooth_step(0.0, 1.0 - light.radius / light.falloff, inside),
                        factor);
    return choose(lit, factor, V(0.0));
}

/// The light's share at a point from where it lies in a direction (unit) at a distance. `asked`: true, or the lanes
/// that count; others get anything.
template <class V, class P, class Mask>
V attenuation(const Light& light, const P& point, const P& direction, const V& distance, const Mask& asked)
{
    V factor(1.0);
    if (light.kind == Light::Kind::Spot) factor = spot(light, direction, distance, asked);
    if (light.kind == Light::Kind::Cylinder) factor = cylinder<V>(light, point, asked);
    if (!(light.fade_power > 0.0)) return factor;
    if (light.fades_from_start) return factor / raised(distance, light.fade_power, asked);
    if (std::abs(light.fade_distance) <= kLeastFadeDistance) return factor;
    const V ways = distance / V(light.fade_distance);
    const V left = factor * (V(2.0) / (V(1.0) + raised(ways, light.fade_power, asked)));
    return choose(factor > V(0.0), left, factor);
}

}  // namespace light
