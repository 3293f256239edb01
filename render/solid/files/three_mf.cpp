#include "render/solid/files/three_mf.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace solid {

void write_three_mf(const std::string& module, const std::string& path, const std::vector<FilePart>& parts)
{
    void* const handle = dlopen(module.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (!handle) throw std::runtime_error(fmt::format("cannot load the writer of 3MF: {}", dlerror()));
    const auto write = reinterpret_cast<WriteThreeMf>(dlsym(handle, kThreeMfEntry));
    if (!write) throw std::runtime_error(fmt::format("the writer of 3MF is not ours: {}", dlerror()));
    std::vector<TriangleMesh> meshes;
    for (const FilePart& part : parts) meshes.push_back(turned(part.mesh));
    static_assert(sizeof(glm::vec3) == 12 && sizeof(meshes[0].triangles[0]) == 12);
    std::vector<std::vector<std::array<std::uint8_t, 3>>> colors(parts.size());
    std::vector<ThreeMfPart> plain;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        ThreeMfPart p{};
        p.name = parts[i].name.c_str();
        const auto own = bytes_of(parts[i].color);
        std::copy(own.begin(), own.end(), p.color);
        for (const Rgb& c : parts[i].colors) colors[i].push_back(bytes_of(c));
        p.colors = colors[i].empty() ? nullptr : colors[i][0].data();
        p.vertices = &meshes[i].vertices[0].x;
        p.vertex_count = static_cast<std::uint32_t>(meshes[i].vertices.size());
        p.triangles = meshes[i].triangles[0].data();
        p.triangle_count = static_cast<std::uint32_t>(meshes[i].triangles.size());
        plain.push_back(p);
    }
    char reason[256] = "";
    if (!write(path.c_str(), plain.data(), static_cast<std::uint32_t>(plain.size()), reason, sizeof(reason)))
        throw std::runtime_error(fmt::format("cannot write '{}': {}", path, reason));
}

}  // namespace solid
