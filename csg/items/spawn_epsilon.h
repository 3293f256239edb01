#pragma once

#include "csg/solids/solid_crossings.h"
#include "csg/base/tolerance.h"
#include "csg/items/leaving.h"

/// Where a ray that leaves a solid begins to look. POV-Ray skips a fixed length, and with it what the solid itself has
/// there: light leaks through edges, and a flat solid has no far side. The others' crossings are skipped all the same:
/// pictures depend on what coincident faces make of it.
namespace csg {

/// Whether normal() may be another than the surface's.
template <class T>
inline bool blends_normals(const T& solid)
{
    if constexpr (requires { solid.blends_normals(); }) return solid.blends_normals();
    else return false;
}

/// Whether it is soon known that a ray that begins on the solid meets no more of it before `usual`.
template <class T>
inline bool leaves(const T& solid, const Ray& ray, bool inward, double own, double usual)
{
    if (leaves_for_good<T>(inward)) return true;
    if constexpr (std::is_same_v<T, Mesh>) return false;  // to be within takes a ray
    if constexpr (std::is_same_v<T, Freeform>) {
        if (solid.surface()) return false;
        if (solid.meets_no_more(ray, own, usual)) return true;
        inward = solid.contains(ray.at(own));  // at an edge the normal may be that of another wall
    }
    // Of a solid that may be met again and again walls and gaps both thinner than that go unseen.
    return solid.contains(ray.at(usual)) == inward;
}

/// The solid's farthest coordinate: rounding counts in its lengths too.
template <class T>
inline double farthest(const T& solid)
{
    const Aabb box = solid.bounds();
    const glm::dvec3 far = glm::max(glm::abs(box.lower), glm::abs(box.upper));
    return glm::max(far.x, glm::max(far.y, far.z));
}

/// `usual`, or before a crossing that the solid itself has nearer than that.
/// \param length     of the ray that came to `ray.origin`
/// \param incidence  cosine of the ray's angle with the normal there
/// \param inward     it goes into the solid
template <class T>
inline double spawn_epsilon(const T& solid, const Ray& ray, double length, double incidence, bool inward, double usual)
{
    constexpr double kUnbounded = 1e-3;  // of `usual` is left to an unbounded solid's own start
    if constexpr (std::is_same_v<T, Freeform>)
        if (solid.has_open_surface() || solid.round()) return usual;
    if (blends_normals(solid)) incidence = 0.0;
    double own = Tolerance::own(ray.origin, length, incidence);
    if (!(own < usual) || leaves(solid, ray, inward, own, usual)) return usual;
    const auto nearest = [&] {
        double t = usual;
        solid_crossings(solid, ray, own, usual, false,
                        [&](double crossing, std::uint32_t) { t = glm::min(t, crossing); });
        return t;
    };
    double t = nearest();
    if (!(t < usual)) return usual;
    const double size = farthest(solid), surely = size < kInfinity
                                                      ? Tolerance::own(ray.origin, glm::max(length, size), incidence)
                                                      : kUnbounded * usual;
    if (surely > own) {
        own = glm::min(surely, usual);
        if (t < own) t = nearest();
    }
    return t < usual ? 0.5 * (own + t) : usual;
}

}  // namespace csg
