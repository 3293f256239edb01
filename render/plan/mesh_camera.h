#pragma once

#include "render/scene/description.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace plan {

/// A camera whose rays leave the faces of meshes (spec 2, section 5). Places of one mesh share its faces.
struct MeshCamera {
    enum class Method { MeshPerRay, AllInOne, SideBySide, ByUv };
    struct Ray {
        glm::dvec3 origin, direction;  ///< unit length

        Ray moved(const csg::Transform& by) const
        {
            return {by.point(origin), glm::normalize(glm::transpose(by.inverse_linear) * direction)};
        }
    };
    struct Mesh {
        std::uint32_t number = 0;            ///< of its first face, those of the meshes before it counted
        std::uint32_t first = 0, count = 0;  ///< in `faces`
        csg::Transform to_world;
    };
    struct Corners {
        std::array<glm::dvec2, 3> uv;
        std::array<Ray, 3> rays;  ///< as at the corners, world
    };

    int rays_per_pixel = 1;
    Method method = Method::MeshPerRay;
    scene::PovRay povray = scene::PovRay::V37;  ///< says which face belongs to a place
    double max_distance = 0;                    ///< what is farther is sky; 0: no limit
    std::vector<Mesh> meshes;
    std::vector<Ray> faces;        ///< at the centroids, in their mesh's space; ByUv: none
    std::vector<Corners> corners;  ///< ByUv alone
    /// ByUv: cells of the unit square, row by row; each lists faces of `corners` that touch it, in order.
    static constexpr int kCells = 64;
    std::vector<std::uint32_t> cell_first;  ///< kCells * kCells + 1
    std::vector<std::uint32_t> cell_faces;

    static int cell_of(double v) { return std::clamp(static_cast<int>(v * kCells), 0, kCells - 1); }
};

/// Null for other cameras.
std::shared_ptr<const MeshCamera> compile_mesh_camera(const scene::Camera& camera);

}  // namespace plan
