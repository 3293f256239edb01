#pragma once

#include "csg/freeform/shared/intersection_list.h"
#include "csg/mesh/mesh_shape.h"

#include <array>
#include <memory>
#include <vector>

namespace csg {

/// A Bezier patch as POV-Ray draws it (spec 5b, 5; manual: Bicubic Patch): halved until flat or often enough, two
/// triangles a piece, shaded with the normals of the true surface at their corners. Drawn, without an inside.
class BicubicPatch {
public:
    using Points = std::array<std::array<glm::dvec3, 4>, 4>;  ///< [row, along u][column, along v]
    struct Input {
        Points points;
        double flatness = 0.0;         ///< 0: never flat enough; a length in the patch's own space
        int u_steps = 0, v_steps = 0;  ///< halvings at most; kMostSteps at most
        /// At (u, v) = (0, 0), (0, 1), (1, 1), (1, 0).
        std::array<glm::dvec2, 4> uv{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    };
    static constexpr int kMostSteps = 10;

    explicit BicubicPatch(const Input& input);
    /// A description: nothing but input() may be called.
    enum class Later { Divide };
    BicubicPatch(const Input& input, Later) : input_(input) {}

    void intersect(const Ray& ray, IntersectionList& out) const;
    bool contains(const glm::dvec3&) const { return false; }
    bool contains_inverted(const glm::dvec3&) const { return false; }
    glm::dvec3 gradient(const glm::dvec3& p, std::uint32_t face) const { return world_gradient({}, p, face); }
    /// In the world, not normalised: blended there between the corners'.
    glm::dvec3 world_gradient(const Transform& frame, const glm::dvec3& p, std::uint32_t face) const;
    bool blends_normals() const { return true; }
    glm::dvec2 uv(const glm::dvec3& p, std::uint32_t face) const;
    Aabb bounds() const { return mesh_->bounds(); }
    Aabb extent() const;

    const Input& input() const { return input_; }
    /// How many pieces the patch was divided into.
    std::size_t pieces() const { return pieces_.size(); }

    static constexpr bool kSurface = true, kClosed = false, kInverseClosed = false;

private:
    /// A rectangle of the parameters; halvings of [0, 1] are exact in single precision.
    struct Piece {
        float u0, u1, v0, v1;
    };
    /// The number of a face as the patch made it (two a piece, in order), and the corners of its piece that it has, in
    /// the order of Input::uv.
    std::uint32_t declared(std::uint32_t face) const { return mesh_->block(face / 4).face[face % 4]; }
    static std::array<std::size_t, 3> corners(std::uint32_t declared)
    {
        return declared % 2 == 0 ? std::array<std::size_t, 3>{0, 1, 2} : std::array<std::size_t, 3>{0, 2, 3};
    }
    static std::array<glm::dvec2, 4> parameters(const Piece& piece);
    glm::dvec3 normal_at(const glm::dvec2& q) const;
    void divide(const Points& points, const Piece& piece, int depth, MeshInput& out);
    bool flat(const Points& points) const;

    Input input_;
    std::vector<Piece> pieces_;
    std::vector<std::array<glm::vec3, 4>> normals_;  ///< at the corners of a piece, any length; 0: there is none
    std::shared_ptr<const MeshShape> mesh_;
};

}  // namespace csg
