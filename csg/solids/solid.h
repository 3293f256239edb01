#pragma once

#include "csg/solids/box.h"
#include "csg/solids/cone.h"
#include "csg/solids/cylinder.h"
#include "csg/solids/disc.h"
#include "csg/solids/extrusion.h"
#include "csg/freeform/freeform_solid.h"
#include "csg/solids/mesh.h"
#include "csg/solids/plane.h"
#include "csg/solids/polynomial.h"
#include "csg/solids/quadric.h"
#include "csg/solids/sphere.h"
#include "csg/solids/torus/torus.h"
#include "csg/solids/triangle.h"

#include <cstdlib>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

namespace csg {

/// Closed on purpose: visitors have no catch-all, so the compiler lists what a new solid lacks. The order is that of
/// SolidKind.
using Solid = std::variant<Sphere, Ellipsoid, Box, OrientedBox, Plane, Cylinder, Cone, Torus, Quadric, Disc, Triangle,
                           Mesh, Extrusion, Polynomial, Freeform>;

enum class SolidKind : std::uint32_t {
    Sphere,
    Ellipsoid,
    Box,
    OrientedBox,
    Plane,
    Cylinder,
    Cone,
    Torus,
    Quadric,
    Disc,
    Triangle,
    Mesh,
    Extrusion,
    Polynomial,
    Freeform
};
inline constexpr std::uint32_t kSolidKinds = std::variant_size_v<Solid>;

inline constexpr std::uint32_t kPartIndexBits = 28;
inline constexpr std::uint32_t kMaxPartsOfKind = 1u << kPartIndexBits;
constexpr PartId make_part(SolidKind kind, std::uint32_t index)
{
    return (static_cast<std::uint32_t>(kind) << kPartIndexBits) | index;
}
constexpr SolidKind kind_of(PartId part) { return static_cast<SolidKind>(part >> kPartIndexBits); }
constexpr std::uint32_t index_of(PartId part) { return part & (kMaxPartsOfKind - 1); }

/// All solids of a scene, one array a kind, with the surface of each beside it.
class SolidStore {
public:
    /// Throws std::length_error beyond 2^28 solids of a kind.
    PartId add(const Solid& solid, SurfaceId surface = kNoSurface);

    template <class T>
    const std::vector<T>& all() const
    {
        return std::get<std::vector<T>>(solids_);
    }
    const std::vector<SurfaceId>& surfaces(SolidKind kind) const { return surfaces_[static_cast<std::uint32_t>(kind)]; }
    SurfaceId surface(PartId part) const { return surfaces(kind_of(part))[index_of(part)]; }
    /// Of a face: those of a mesh may differ.
    SurfaceId surface(PartId part, std::uint32_t face) const
    {
        return kind_of(part) == SolidKind::Mesh ? all<Mesh>()[index_of(part)].surface(face) : surface(part);
    }
    Solid get(PartId part) const;

private:
    std::tuple<std::vector<Sphere>, std::vector<Ellipsoid>, std::vector<Box>, std::vector<OrientedBox>,
               std::vector<Plane>, std::vector<Cylinder>, std::vector<Cone>, std::vector<Torus>, std::vector<Quadric>,
               std::vector<Disc>, std::vector<Triangle>, std::vector<Mesh>, std::vector<Extrusion>,
               std::vector<Polynomial>, std::vector<Freeform>>
        solids_;
    std::array<std::vector<SurfaceId>, kSolidKinds> surfaces_;
};

/// Calls f with the solid itself; the kind is decided by one switch, nothing is virtual.
template <class F>
inline decltype(auto) with_solid(const SolidStore& store, PartId part, F&& f)
{
    const std::uint32_t i = index_of(part);
    switch (kind_of(part)) {
    case SolidKind::Sphere: return f(store.all<Sphere>()[i]);
    case SolidKind::Ellipsoid: return f(store.all<Ellipsoid>()[i]);
    case SolidKind::Box: return f(store.all<Box>()[i]);
    case SolidKind::OrientedBox: return f(store.all<OrientedBox>()[i]);
    case SolidKind::Plane: return f(store.all<Plane>()[i]);
    case SolidKind::Cylinder: return f(store.all<Cylinder>()[i]);
    case SolidKind::Cone: return f(store.all<Cone>()[i]);
    case SolidKind::Torus: return f(store.all<Torus>()[i]);
    case SolidKind::Quadric: return f(store.all<Quadric>()[i]);
    case SolidKind::Disc: return f(store.all<Disc>()[i]);
    case SolidKind::Triangle: return f(store.all<Triangle>()[i]);
    case SolidKind::Mesh: return f(store.all<Mesh>()[i]);
    case SolidKind::Extrusion: return f(store.all<Extrusion>()[i]);
    case SolidKind::Polynomial: return f(store.all<Polynomial>()[i]);
    case SolidKind::Freeform: return f(store.all<Freeform>()[i]);
    }
    std::abort();
}

/// Whether the point of a boundary belongs to the solid (spec 5a, 2.4).
template <class T>
inline bool holds_surface(const T& solid, bool inverted)
{
    if constexpr (std::is_same_v<T, Cylinder> || std::is_same_v<T, Cone>) return solid.open != inverted;
    else if constexpr (std::is_same_v<T, Freeform>) return inverted ? solid.inverse_closed() : solid.closed();
    else return inverted ? T::kInverseClosed : T::kClosed;
}

/// The spans of any solid: those of convex kinds come from their interval, a triangle has none.
template <class T>
inline void intersect(const T& solid, const Ray& ray, SpanList& out)
{
    if constexpr (std::is_same_v<T, Triangle>) {
        return;
    } else if constexpr (requires { solid.intersect(ray, out); }) {
        solid.intersect(ray, out);
    } else {
        Interval in;
        if (solid.interval(ray, in))
            out.push({{.t = in.entry, .face = in.entry_face}, {.t = in.exit, .face = in.exit_face}});
    }
}

/// No ray has more spans in a solid of the kind; not for meshes.
template <class T>
constexpr std::uint32_t most_plain_spans()
{
    if constexpr (std::is_same_v<T, Extrusion>) return Extrusion::kMostWalls / 2 + 1;
    else if constexpr (std::is_same_v<T, Polynomial>) return Polynomial::kMostSpans;
    else if constexpr (std::is_same_v<T, Freeform>) return Freeform::kMostSpans;
    else return 4;
}

/// Outward unit normal of the part's surface at world point p, negated if the crossing was inverted.
inline glm::dvec3 normal_at(const SolidStore& store, PartId part, std::uint32_t face, bool inverted,
                            const glm::dvec3& p)
{
    const glm::dvec3 n = with_solid(store, part, [&](const auto& solid) { return solid.normal(p, face); });
    return inverted ? -n : n;
}

/// Surface coordinates at p; (x, y) of the point in the scene for kinds that have none of their own (spec 5a, 6).
inline glm::dvec2 uv_at(const SolidStore& store, PartId part, std::uint32_t face, const glm::dvec3& p,
                        const glm::dvec3& in_scene)
{
    return with_solid(store, part, [&](const auto& solid) {
        if constexpr (requires { solid.uv(p, face); }) return solid.uv(p, face);
        else return glm::dvec2(in_scene);
    });
}

}  // namespace csg
