#pragma once

#include "csg/packet/lanes/lane_interval.h"
#include "csg/solids/solid.h"

/// interval() of the convex solids in vector lanes.
namespace csg::lanes {

/// A solid prepared for rays from one origin (P is glm::dvec3) or from as many as there are lanes (Points):
/// (directions) -> Intervals.
template <class T, class P>
class Test {
public:
    Test(const T& solid, const P& origin) : solid_(solid), start_(solid.start(origin)) {}
    Intervals operator()(const Directions& d) const
    {
        Intervals out;
        out.met = solid_.interval(start_, d, out);
        return out;
    }

private:
    const T& solid_;
    decltype(solid_.start(std::declval<P>())) start_;
};

/// Quadric::intersect(): as an interval where it gives one span, else unclear.
template <class P>
class Test<Quadric, P> {
public:
    Test(const Quadric& s, const P& origin) : solid_(s), start_(s.start(origin)) {}
    Intervals operator()(const Directions& d) const
    {
        Intervals second;
        Intervals out = both(d, second);
        out.unclear = out.unclear | second.met;
        out.met = out.met & !second.met;
        return out;
    }

    /// The first span and, of rays that pass between two sheets, the second. Unclear: it opens with neither sign.
    Intervals both(const Directions& d, Intervals& second) const
    {
        const auto at = solid_.course(start_, d);
        const Bool crosses = at.discriminant > Double(0.0), misses = at.discriminant <= Double(0.0);
        const Bool closes = at.a > Double(0.0), opens = at.a < Double(0.0);
        Intervals out;
        out.unclear = (!(closes | opens)) | (!(crosses | misses));
        out.entry = xsimd::select(opens, lanes::before(), at.near);
        out.exit = xsimd::select(opens, xsimd::select(crosses, at.near, lanes::beyond()), at.far);
        out.met = (opens | crosses) & !out.unclear;
        second.entry = at.far;
        second.exit = lanes::beyond();
        second.met = opens & crosses & !out.unclear;
        return out;
    }

private:
    const Quadric& solid_;
    P start_;
};

/// Calls f(both), where both(i, second) gives Test<Quadric>::both() of the rays from i on.
template <class Rays, class F>
inline void with_spans(const Quadric& quadric, const Rays& rays, F&& f)
{
    if constexpr (Rays::kShared) {
        const Test<Quadric, glm::dvec3> test(quadric, rays.origin);
        f([&](int i, Intervals& second) { return test.both(rays.directions(i), second); });
    } else {
        f([&](int i, Intervals& second) {
            return Test<Quadric, Points>(quadric, rays.origins(i)).both(rays.directions(i), second);
        });
    }
}

/// Whether with_test() gives one interval for every ray.
inline bool has_test(const SolidStore& store, PartId part)
{
    switch (kind_of(part)) {
    case SolidKind::Sphere:
    case SolidKind::Ellipsoid:
    case SolidKind::Box:
    case SolidKind::OrientedBox:
    case SolidKind::Plane:
    case SolidKind::Cylinder: return true;
    case SolidKind::Cone: return store.all<Cone>()[index_of(part)].convex();
    default: return false;
    }
}

/// Calls f(at) for a quadric, a triangle or a solid that has_test(); at(i) gives the Intervals of the rays from i on.
template <class Rays, class F>
inline void with_test(const SolidStore& store, PartId part, const Rays& rays, F&& f)
{
    const auto prepared = [&](const auto& solid) {
        using T = std::decay_t<decltype(solid)>;
        if constexpr (Rays::kShared) {
            const Test<T, glm::dvec3> test(solid, rays.origin);
            f([&](int i) { return test(rays.directions(i)); });
        } else {
            f([&](int i) { return Test<T, Points>(solid, rays.origins(i))(rays.directions(i)); });
        }
    };
    const std::uint32_t i = index_of(part);
    switch (kind_of(part)) {
    case SolidKind::Sphere: prepared(store.all<Sphere>()[i]); return;
    case SolidKind::Ellipsoid: prepared(store.all<Ellipsoid>()[i]); return;
    case SolidKind::Box: prepared(store.all<Box>()[i]); return;
    case SolidKind::OrientedBox: {
        const OrientedBox& box = store.all<OrientedBox>()[i];
        rays.turned.turn(box.frame, rays);
        f([&](int at) {
            rays.turned.find(at, rays);
            Intervals out;
            out.met = box_interval(BoxCorners(box.lower, box.upper, rays.turned.origins(at)),
                                   rays.turned.directions(at), rays.turned.inverses(at), out);
            return out;
        });
        return;
    }
    case SolidKind::Plane: prepared(store.all<Plane>()[i]); return;
    case SolidKind::Cylinder: prepared(store.all<Cylinder>()[i]); return;
    case SolidKind::Cone: prepared(store.all<Cone>()[i]); return;
    case SolidKind::Quadric: prepared(store.all<Quadric>()[i]); return;
    case SolidKind::Triangle: prepared(store.all<Triangle>()[i]); return;
    default: return;
    }
}

}  // namespace csg::lanes
