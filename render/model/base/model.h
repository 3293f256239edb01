#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace model {

inline constexpr std::uint32_t kNone = 0xffffffffu;

/// Triangles with what their file says of their corners. A reader says which axes it turns (docs/tools/meshes.md).
struct Model {
    struct Face {
        std::array<std::uint32_t, 3> vertex;
        std::array<std::uint32_t, 3> normal{kNone, kNone, kNone};  ///< all of them or none
        std::array<std::uint32_t, 3> uv{kNone, kNone, kNone};      ///< the like
        std::array<std::uint32_t, 3> color{kNone, kNone, kNone};   ///< the like
        std::uint32_t material = kNone;                            ///< index into materials
    };
    std::vector<glm::dvec3> vertices, normals;
    std::vector<glm::dvec2> uvs;
    std::vector<glm::vec3> colors;  ///< of corners
    std::vector<Face> faces;
    /// What faces are made of.
    struct Material {
        std::string name;
        bool told = false;  ///< the file says what it looks like
        glm::vec3 color{1}, emission{0};
        float opacity = 1;
        bool opaque = false;  ///< whatever its picture's alpha says
        /// Over which `color` is laid: its place among `pictures`, or the path that the file names it by.
        std::uint32_t picture = kNone;
        std::string picture_path;
    };
    std::vector<Material> materials;     ///< each name once, in the order of their first use
    std::vector<std::string> libraries;  ///< files that say what materials look like, as the file names them
    std::vector<std::string> pictures;   ///< files that stand in this one, PNG or JPEG
    bool linear = false;                 ///< colours are light from 0 to 1; else they are levels of sRGB
};

/// What is wrong with a file, and where: a text's `line` counts from 1, another file's `byte` from 0. 0 and kNowhere:
/// the file as a whole.
struct ModelError : std::runtime_error {
    static constexpr std::size_t kNowhere = ~std::size_t{0};

    ModelError(const std::string& what, std::size_t at) : std::runtime_error(what), line(at) {}
    static ModelError at_byte(const std::string& what, std::size_t at)
    {
        ModelError error(what, 0);
        error.byte = at;
        return error;
    }
    std::size_t line, byte = kNowhere;
};

}  // namespace model
