#include "render/plan/mesh_camera.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace plan {
namespace {

constexpr double kTiny = 1e-10;

/// What leaves a mesh at a place, both in its own space.
MeshCamera::Ray ray_from(const scene::Camera& camera, const glm::dvec3& p, const glm::dvec3& normal)
{
    const glm::dvec3 n = glm::normalize(normal);
    return {p + camera.location.z * n, camera.direction.z < -kTiny ? -n : n};
}

void add_faces(MeshCamera& out, const scene::MeshData& mesh, const scene::Camera& camera,
               const csg::Transform& to_world, bool smooth)
{
    constexpr std::uint32_t kNone = scene::MeshData::kNone;
    for (const scene::MeshData::Face& face : mesh.faces) {
        const auto corner = [&](std::size_t k) { return mesh.vertices[face.vertex[k]]; };
        const glm::dvec3 normal = glm::cross(corner(2) - corner(0), corner(1) - corner(0));
        if (out.method != MeshCamera::Method::ByUv) {
            out.faces.push_back(ray_from(camera, (corner(0) + corner(1) + corner(2)) / 3.0, normal));
            continue;
        }
        MeshCamera::Corners corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            if (face.uv[k] != kNone) corners.uv[k] = mesh.uvs[face.uv[k]];
            const bool own = smooth && face.normal[k] != kNone;
            corners.rays[k] = ray_from(camera, corner(k), own ? mesh.normals[face.normal[k]] : normal).moved(to_world);
        }
        out.corners.push_back(corners);
    }
}

void sort_into_cells(MeshCamera& out)
{
    constexpr auto kAll = static_cast<std::size_t>(MeshCamera::kCells) * MeshCamera::kCells;
    std::vector<std::vector<std::uint32_t>> cells(kAll);
    for (std::uint32_t f = 0; f < out.corners.size(); ++f) {
        const auto& uv = out.corners[f].uv;
        const glm::dvec2 low = glm::min(glm::min(uv[0], uv[1]), uv[2]), high = glm::max(glm::max(uv[0], uv[1]), uv[2]);
        for (int y = MeshCamera::cell_of(low.y); y <= MeshCamera::cell_of(high.y); ++y)
            for (int x = MeshCamera::cell_of(low.x); x <= MeshCamera::cell_of(high.x); ++x)
                cells[static_cast<std::size_t>(y) * MeshCamera::kCells + static_cast<std::size_t>(x)].push_back(f);
    }
    out.cell_first = {0};
    for (const std::vector<std::uint32_t>& cell : cells) {
        out.cell_faces.insert(out.cell_faces.end(), cell.begin(), cell.end());
        out.cell_first.push_back(static_cast<std::uint32_t>(out.cell_faces.size()));
    }
}

}  // namespace

std::shared_ptr<const MeshCamera> compile_mesh_camera(const scene::Camera& camera)
{
    if (camera.kind != scene::Camera::Kind::Mesh || !camera.mesh) return nullptr;
    const scene::MeshCamera& written = *camera.mesh;
    auto out = std::make_shared<MeshCamera>();
    out->rays_per_pixel = written.rays_per_pixel;
    out->method = static_cast<MeshCamera::Method>(written.distribution);
    out->povray = camera.povray;
    out->max_distance = written.max_distance < kTiny ? 0.0 : written.max_distance;
    std::map<const scene::MeshData*, std::uint32_t> known;  // the first face of each
    std::uint32_t number = 0;
    for (const scene::MeshCamera::Member& member : written.meshes) {
        const scene::Object& object = *member.object;
        const scene::MeshData& mesh = *std::get<scene::Mesh>(object.shape).data;
        if (out->method == MeshCamera::Method::ByUv && !out->corners.empty()) continue;  // further meshes are not used
        const auto [at, fresh] = known.emplace(&mesh, static_cast<std::uint32_t>(out->faces.size()));
        if (fresh) add_faces(*out, mesh, camera, *object.transform, written.smooth);
        const auto count = static_cast<std::uint32_t>(mesh.faces.size());
        out->meshes.push_back({number, at->second, count, *object.transform});
        number += count;
    }
    if (out->method == MeshCamera::Method::ByUv) sort_into_cells(*out);
    return out;
}

}  // namespace plan
