#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace solid {

/// Triangles that share vertices; counter-clockwise as seen from outside in a right-handed space. Vertices are numbers
/// of single precision, as the files hold them.
struct TriangleMesh {
    std::vector<glm::vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<glm::vec3> normals;  ///< of the surface, unit length; a vertex on a sharp edge has one for each side
    std::vector<std::array<std::uint32_t, 3>> normal_of;  ///< by triangle: of its corners; empty where none are known
};

}  // namespace solid
