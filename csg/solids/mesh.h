#pragma once

#include "csg/mesh/mesh_shape.h"
#include "csg/solids/shared/common.h"

#include <memory>

namespace csg {

/// An instance of a mesh. Without an inside vector it is drawn but bounds nothing; with one, a point is inside where
/// the ray from it along the vector meets an odd number of faces (spec 5b, 3.6).
struct Mesh {
    std::shared_ptr<const MeshShape> shape;
    Transform frame;                  ///< from the space of the mesh to the world
    std::vector<SurfaceId> surfaces;  ///< by slot of a face
    bool blends = false;              ///< some face mixes surfaces by the weights of its corners
    glm::dvec3 inside_vector{0.0};    ///< world space, whatever the frame: POV-Ray does not carry it along; 0: none

    /// A list of crossings keeps no more than so many of one ray, the first that the walk meets; the nearest hit and
    /// shadows make no list.
    static constexpr std::uint32_t kMostCrossings = 4096;

    /// normal() may be another than the surface's.
    bool blends_normals() const { return shape->smooth(); }
    bool solid() const { return inside_vector != glm::dvec3(0.0); }
    /// At most so many faces (and walls) met along a ray.
    std::uint32_t most_crossings() const;
    /// At most so many spans along a ray, inverted or not.
    std::uint32_t most_spans() const { return solid() ? most_crossings() / 2 + 2 : 1; }

    /// What of the ray is inside, or outside if `inverted`. A mesh with holes is inside as contains() has it: behind
    /// each open edge stands an undrawn wall, against the inside vector and without end.
    void spans(const Ray& ray, bool inverted, SpanList& out) const;
    void intersect(const Ray& ray, SpanList& out) const { spans(ray, false, out); }

    bool contains(const glm::dvec3& p) const { return solid() && holds(p); }
    /// A surface has no inside, inverted or not.
    bool contains_inverted(const glm::dvec3& p) const { return solid() && !holds(p); }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t face) const;
    glm::dvec2 uv(const glm::dvec3& p, std::uint32_t face) const { return shape->uv(face, frame.inverse_point(p)); }
    glm::dvec3 weights(const glm::dvec3& p, std::uint32_t face) const
    {
        return shape->weights(face, frame.inverse_point(p));
    }
    Aabb bounds() const;  ///< infinite for a solid with holes
    Aabb drawn_bounds() const;
    SurfaceId surface(std::uint32_t face) const { return surfaces[shape->slot(face)]; }

    static constexpr bool kClosed = true, kInverseClosed = false;

private:
    bool holds(const glm::dvec3& p) const;
};

}  // namespace csg
