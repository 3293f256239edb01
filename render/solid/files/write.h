#pragma once

#include "render/solid/mesh/triangle_mesh.h"

#include <array>
#include <string>
#include <vector>

/// Meshes as files. POV-Ray's space is left-handed with y up, these are right-handed with z up: y and z change places,
/// which keeps threads and letters as they are.
namespace solid {

using Rgb = std::array<double, 3>;  ///< sRGB, 0 to 1

/// An object of a file.
struct FilePart {
    std::string name;
    Rgb color{0.7, 0.7, 0.7};
    std::vector<Rgb> colors;  ///< by vertex, where the pigment is no plain colour; else empty
    TriangleMesh mesh;        ///< in the scene's space
};

enum class MeshFormat { Stl, Obj, Ply, ThreeMf, Glb };

Rgb color_at(const FilePart& part, std::size_t vertex);
std::array<std::uint8_t, 3> bytes_of(const Rgb& color);

/// By the end of the name; throws std::runtime_error with those that there are.
MeshFormat format_of(const std::string& path);

/// The same triangles in the space of the files.
TriangleMesh turned(const TriangleMesh& mesh);

/// The same triangles with a vertex for each side of a sharp edge: vertex i has normal i. Which vertex each was.
TriangleMesh with_own_normals(const TriangleMesh& mesh, std::vector<std::uint32_t>& vertex_of);

/// Binary; all parts in one list of triangles.
std::string stl_bytes(const std::vector<FilePart>& parts);
/// With the colour of each vertex behind its place, and normals.
std::string obj_text(const std::vector<FilePart>& parts);
/// Binary, little-endian, with normal and colour of each vertex.
std::string ply_bytes(const std::vector<FilePart>& parts);

}  // namespace solid
