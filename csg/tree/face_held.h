#pragma once

#include "csg/solids/solid.h"
#include "csg/spans/span.h"

/// Whether solids hold the points of their own faces.
namespace csg {

/// Of ends of two solids: the same face of solids of one kind in one place. Those of boxes look the same way.
inline bool alike(const Crossing& a, const Crossing& b)
{
    return a.t == b.t && a.face == b.face && kind_of(a.part) == kind_of(b.part);
}

/// Whether a solid holds the point of its own end at t, for a face that is alike. closed: what its kind says, inverted
/// or not (Crossing::closed).
///
/// A box holds its faces, but what POV-Ray asks it about is a point of the ray, rounded. From far off all points of a
/// face at 0.3 may lie beyond it, so that both boxes that share it in a merge keep it, where at 0.25 both lose it. The
/// same operations in the same order have the same outcome. (Not so where the faces look at each other, as those of
/// boxes that abut do: shadow rays may run the other way here, and a wall between two parts of one glass would show.)
inline bool holds_face(const SolidStore& store, PartId part, const Ray& ray, double t, std::uint32_t face, bool closed)
{
    const auto axis = static_cast<glm::length_t>(face / 2);
    const auto held = [&](double at, const auto& box) {
        return (face % 2 == 0 ? at >= box.lower[axis] : at <= box.upper[axis]) == closed;
    };
    if (face == kUndrawnFace) return closed;
    if (kind_of(part) == SolidKind::Box)
        return held(ray.origin[axis] + t * ray.direction[axis], store.all<Box>()[index_of(part)]);
    if (kind_of(part) != SolidKind::OrientedBox) return closed;
    const OrientedBox& box = store.all<OrientedBox>()[index_of(part)];
    return held(box.frame.inverse_point(ray.at(t))[axis], box);
}

/// Whether the end of a span belongs to it, asked for another end in its place.
inline bool holds_end(const SolidStore& store, const Ray& ray, const Crossing& end, const Crossing& other)
{
    return alike(end, other) ? holds_face(store, end.part, ray, end.t, end.face, end.closed) : end.closed;
}

}  // namespace csg
