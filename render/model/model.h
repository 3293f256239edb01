#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace model {

inline constexpr std::uint32_t kNone = 0xffffffffu;

/// Triangles with what their file says of their corners, as it is written there: no axis is turned, no unit converted.
struct Model {
    struct Face {
        std::array<std::uint32_t, 3> vertex;
        std::array<std::uint32_t, 3> normal{kNone, kNone, kNone};  ///< all of them or none
        std::array<std::uint32_t, 3> uv{kNone, kNone, kNone};      ///< the like
        std::uint32_t material = kNone;                            ///< index into materials
    };
    std::vector<glm::dvec3> vertices, normals;
    std::vector<glm::dvec2> uvs;
    std::vector<Face> faces;
    std::vector<std::string> materials;  ///< names, each once, in the order of their first use
};

/// What is wrong with a file, and where: `line` counts from 1; 0: nowhere in it.
struct ModelError : std::runtime_error {
    ModelError(const std::string& what, std::size_t at) : std::runtime_error(what), line(at) {}
    std::size_t line;
};

}  // namespace model
