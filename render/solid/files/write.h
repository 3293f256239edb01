#pragma once

#include "render/solid/mesh/triangle_mesh.h"

#include <array>
#include <string>
#include <vector>

/// Meshes as files. POV-Ray's space is left-handed with y up, these are right-handed with z up: y and z change places,
/// which keeps threads and letters as they are.
namespace solid {

/// An object of a file.
struct FilePart {
    std::string name;
    std::array<double, 3> color{0.7, 0.7, 0.7};  ///< sRGB, 0 to 1
    TriangleMesh mesh;                           ///< in the scene's space
};

enum class MeshFormat { Stl, Obj, Ply, ThreeMf };

/// By the end of the name; throws std::runtime_error with those that there are.
MeshFormat format_of(const std::string& path);

/// The same triangles in the space of the files.
TriangleMesh turned(const TriangleMesh& mesh);

/// Binary; all parts in one list of triangles.
std::string stl_bytes(const std::vector<FilePart>& parts);
std::string obj_text(const std::vector<FilePart>& parts);
/// Binary, little-endian, with the colour of each vertex.
std::string ply_bytes(const std::vector<FilePart>& parts);

}  // namespace solid
