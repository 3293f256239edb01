#pragma once

#include "csg/bvh/bvh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace csg {

/// Four triangles side by side, corners in single precision as POV-Ray keeps them (spec 5b, 3.1). An empty place
/// repeats one point: no ray meets it.
struct alignas(16) TriangleBlock {
    float corner[3][3][4];  ///< [corner][axis][place]
    std::uint32_t face[4];  ///< place in the order of declaration
    glm::dvec3 at(std::uint32_t which, std::uint32_t place) const
    {
        return {corner[which][0][place], corner[which][1][place], corner[which][2][place]};
    }
};
static_assert(sizeof(TriangleBlock) == 160, "40 bytes a triangle");

/// What a mesh is made of, in its own space.
struct MeshInput {
    static constexpr std::uint32_t kNone = 0xffffffffu;
    struct Face {
        std::array<std::uint32_t, 3> vertex;
        std::array<std::uint32_t, 3> normal{kNone, kNone, kNone};  ///< all kNone: flat
        std::array<std::uint32_t, 3> uv{kNone, kNone, kNone};      ///< all kNone: uv is (0, 0)
        std::uint32_t slot = 0;                                    ///< which of the mesh's surfaces
    };
    std::vector<glm::dvec3> vertices;
    std::vector<glm::dvec3> normals;  ///< any length; <1,0,0> stands in for those without one
    std::vector<glm::dvec2> uvs;
    std::vector<Face> faces;  ///< indices within range
    bool solid = false;       ///< will be asked what is inside: MeshShape::open_edges() are worked out
};

/// Triangles with a hierarchy of their own, in the space of the mesh; shared by every instance. A face is named by
/// block * 4 + place. Immutable once built.
class MeshShape {
public:
    explicit MeshShape(const MeshInput& input);

    const Bvh& bvh() const { return bvh_; }
    const TriangleBlock& block(std::uint32_t index) const { return blocks_[index]; }
    std::size_t blocks() const { return blocks_.size(); }
    const Aabb& bounds() const { return bvh_.bounds; }
    std::size_t triangles() const { return triangles_; }  ///< those that have an area
    /// Of a solid: edges that an odd number of faces share. None: the mesh is closed.
    const std::vector<std::array<glm::dvec3, 2>>& open_edges() const { return open_edges_; }
    std::size_t bytes() const;

    /// Some face is lit by its corners' normals.
    bool smooth() const { return !normals_.empty(); }
    /// The surface of a face.
    std::uint32_t slot(std::uint32_t face) const { return slots_.empty() ? 0 : slots_[declared(face)]; }
    /// Normal at a point of the face, in the space of the mesh, on the side of (c2 - c0) x (c1 - c0); not normalised.
    glm::dvec3 normal(std::uint32_t face, const glm::dvec3& p) const;
    glm::dvec2 uv(std::uint32_t face, const glm::dvec3& p) const;
    /// How near the point of a face is to its corners: three numbers that sum to 1.
    glm::dvec3 weights(std::uint32_t face, const glm::dvec3& p) const;

private:
    std::uint32_t declared(std::uint32_t face) const { return blocks_[face / 4].face[face % 4]; }
    void fill_blocks(const MeshInput& input);
    void fill_attributes(const MeshInput& input);

    Bvh bvh_;
    std::vector<TriangleBlock> blocks_;
    /// By place in the order of declaration; empty where the mesh has none.
    std::vector<std::array<std::uint32_t, 3>> normal_of_, uv_of_;
    std::vector<std::uint32_t> slots_;
    std::vector<glm::vec3> normals_;  ///< unit length
    std::vector<glm::vec2> uvs_;
    std::size_t triangles_ = 0;
    std::vector<std::array<glm::dvec3, 2>> open_edges_;
};

}  // namespace csg
