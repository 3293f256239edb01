#include "render/solid/files/write.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <stdexcept>

namespace solid {
namespace {

static_assert(std::endian::native == std::endian::little, "STL and PLY are written as numbers lie in memory");

template <class T>
void put(std::string& out, const T& value)
{
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    out.append(bytes, sizeof(T));
}

void put_vector(std::string& out, const glm::vec3& v)
{
    for (int k = 0; k < 3; ++k) put(out, v[k]);
}

std::string word_of(const std::string& name)
{
    std::string out = name;
    for (char& c : out)
        if (c == ' ' || c == '\n' || c == '\t') c = '_';
    return out;
}

}  // namespace

MeshFormat format_of(const std::string& path)
{
    std::string lower = path;
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
    if (lower.ends_with(".stl")) return MeshFormat::Stl;
    if (lower.ends_with(".obj")) return MeshFormat::Obj;
    if (lower.ends_with(".ply")) return MeshFormat::Ply;
    if (lower.ends_with(".3mf")) return MeshFormat::ThreeMf;
    throw std::runtime_error(fmt::format("cannot write '{}': a name that ends in .stl, .3mf, .obj or .ply", path));
}

TriangleMesh turned(const TriangleMesh& mesh)
{
    TriangleMesh out = mesh;
    for (glm::vec3& v : out.vertices) std::swap(v.y, v.z);
    for (auto& t : out.triangles) std::swap(t[1], t[2]);
    return out;
}

std::string stl_bytes(const std::vector<FilePart>& parts)
{
    std::string out = "binary STL of Whittle, units as in the scene (read as millimetres), z up";
    out.resize(80, ' ');
    std::size_t count = 0;
    for (const FilePart& part : parts) count += part.mesh.triangles.size();
    put(out, static_cast<std::uint32_t>(count));
    out.reserve(84 + 50 * count);
    for (const FilePart& part : parts) {
        const TriangleMesh mesh = turned(part.mesh);
        for (const auto& t : mesh.triangles) {
            const glm::dvec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
            const glm::dvec3 n = glm::cross(b - a, c - a);
            const double length = glm::length(n);
            put_vector(out, length > 0.0 ? glm::vec3(n / length) : glm::vec3(0.0f));
            for (const std::uint32_t v : t) put_vector(out, mesh.vertices[v]);
            put(out, std::uint16_t(0));
        }
    }
    return out;
}

std::string obj_text(const std::vector<FilePart>& parts)
{
    std::string out = "# Whittle; units as in the scene, z up\n";
    std::size_t before = 1;
    for (const FilePart& part : parts) {
        const TriangleMesh mesh = turned(part.mesh);
        out += fmt::format("o {}\n", word_of(part.name));
        for (const glm::vec3& v : mesh.vertices)
            out += fmt::format("v {:.9g} {:.9g} {:.9g} {:.4g} {:.4g} {:.4g}\n", v.x, v.y, v.z, part.color[0],
                               part.color[1], part.color[2]);
        for (const auto& t : mesh.triangles)
            out += fmt::format("f {} {} {}\n", before + t[0], before + t[1], before + t[2]);
        before += mesh.vertices.size();
    }
    return out;
}

std::string ply_bytes(const std::vector<FilePart>& parts)
{
    std::size_t vertices = 0, triangles = 0;
    for (const FilePart& part : parts) {
        vertices += part.mesh.vertices.size();
        triangles += part.mesh.triangles.size();
    }
    std::string out = fmt::format("ply\nformat binary_little_endian 1.0\ncomment Whittle; units as in the scene, z up\n"
                                  "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
                                  "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                                  "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                                  vertices, triangles);
    std::string faces;
    std::int32_t before = 0;
    for (const FilePart& part : parts) {
        const TriangleMesh mesh = turned(part.mesh);
        for (const glm::vec3& v : mesh.vertices) {
            put_vector(out, v);
            for (const double c : part.color)
                put(out, static_cast<std::uint8_t>(std::clamp(c, 0.0, 1.0) * 255.0 + 0.5));
        }
        for (const auto& t : mesh.triangles) {
            put(faces, std::uint8_t(3));
            for (const std::uint32_t v : t) put(faces, before + static_cast<std::int32_t>(v));
        }
        before += static_cast<std::int32_t>(mesh.vertices.size());
    }
    return out + faces;
}

}  // namespace solid
