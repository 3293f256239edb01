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
    if (lower.ends_with(".glb")) return MeshFormat::Glb;
    throw std::runtime_error(
        fmt::format("cannot write '{}': a name that ends in .stl, .3mf, .obj, .ply or .glb", path));
}

TriangleMesh turned(const TriangleMesh& mesh)
{
    TriangleMesh out = mesh;
    for (glm::vec3& v : out.vertices) std::swap(v.y, v.z);
    for (auto& t : out.triangles) std::swap(t[1], t[2]);
    for (glm::vec3& n : out.normals) std::swap(n.y, n.z);
    for (auto& t : out.normal_of) std::swap(t[1], t[2]);
    return out;
}

TriangleMesh with_own_normals(const TriangleMesh& mesh, std::vector<std::uint32_t>& vertex_of)
{
    TriangleMesh out;
    out.triangles = mesh.triangles;
    vertex_of.clear();
    if (mesh.normal_of.empty()) {
        out.vertices = mesh.vertices;
        for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) vertex_of.push_back(v);
        return out;
    }
    // A normal belongs to one vertex.
    out.normals = mesh.normals;
    out.vertices.resize(mesh.normals.size());
    vertex_of.resize(mesh.normals.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t n = mesh.normal_of[i][k], v = mesh.triangles[i][k];
            out.triangles[i][k] = n;
            out.vertices[n] = mesh.vertices[v];
            vertex_of[n] = v;
        }
    return out;
}

Rgb color_at(const FilePart& part, std::size_t vertex)
{
    return part.colors.empty() ? part.color : part.colors[vertex];
}

std::array<std::uint8_t, 3> bytes_of(const Rgb& color)
{
    std::array<std::uint8_t, 3> out{};
    for (std::size_t k = 0; k < 3; ++k)
        out[k] = static_cast<std::uint8_t>(std::clamp(color[k], 0.0, 1.0) * 255.0 + 0.5);
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
    std::size_t before = 1, normals_before = 1;
    for (const FilePart& part : parts) {
        const TriangleMesh mesh = turned(part.mesh);
        out += fmt::format("o {}\n", word_of(part.name));
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            const glm::vec3& v = mesh.vertices[i];
            const Rgb c = color_at(part, i);
            out += fmt::format("v {:.9g} {:.9g} {:.9g} {:.4g} {:.4g} {:.4g}\n", v.x, v.y, v.z, c[0], c[1], c[2]);
        }
        for (const glm::vec3& n : mesh.normals) out += fmt::format("vn {:.7g} {:.7g} {:.7g}\n", n.x, n.y, n.z);
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            out += 'f';
            for (std::size_t k = 0; k < 3; ++k) {
                out += fmt::format(" {}", before + mesh.triangles[i][k]);
                if (!mesh.normal_of.empty()) out += fmt::format("//{}", normals_before + mesh.normal_of[i][k]);
            }
            out += '\n';
        }
        before += mesh.vertices.size();
        normals_before += mesh.normals.size();
    }
    return out;
}

std::string ply_bytes(const std::vector<FilePart>& parts)
{
    std::vector<TriangleMesh> meshes;
    std::size_t vertices = 0, triangles = 0;
    bool normals = true;
    std::vector<std::vector<std::uint32_t>> vertex_of(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        meshes.push_back(with_own_normals(turned(parts[i].mesh), vertex_of[i]));
        vertices += meshes[i].vertices.size();
        triangles += meshes[i].triangles.size();
        normals = normals && !meshes[i].normals.empty();
    }
    std::string out = fmt::format("ply\nformat binary_little_endian 1.0\ncomment Whittle; units as in the scene, z up\n"
                                  "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n{}"
                                  "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                                  "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                                  vertices, normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "",
                                  triangles);
    std::string faces;
    std::int32_t before = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const TriangleMesh& mesh = meshes[i];
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
            put_vector(out, mesh.vertices[v]);
            if (normals) put_vector(out, mesh.normals[v]);
            for (const std::uint8_t c : bytes_of(color_at(parts[i], vertex_of[i][v]))) put(out, c);
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
