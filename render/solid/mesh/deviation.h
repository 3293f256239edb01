#pragma once

#include "render/solid/measure/body.h"
#include "render/solid/mesh/triangle_mesh.h"

#include <atomic>

namespace solid {

/// How far a mesh and a body are apart, as sampled: greatest and root of the mean square, in scene units.
struct Deviation {
    double from_mesh = 0.0, from_mesh_rms = 0.0;  ///< of places of the triangles from the body
    double from_body = 0.0, from_body_rms = 0.0;  ///< of places of the body's surface from the triangles
    glm::dvec3 worst_of_body{0.0};                ///< where
    std::size_t samples = 0;
};

/// \param most places of the mesh that are looked at; those of the body are about as many
/// \param wanted what is nearer is near enough to look no further
Deviation deviation(const Body& body, const csg::Aabb& extent, const TriangleMesh& mesh, std::size_t most,
                    double wanted, const std::atomic<bool>* cancel);

}  // namespace solid
