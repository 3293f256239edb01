#include "render/kernel/camera/mesh_camera_ray.h"

#include <algorithm>
#include <cmath>

namespace trace {

using plan::MeshCamera;
using Method = MeshCamera::Method;

namespace {

constexpr double kUvEdge = 1e-9;  // of a triangle: no place between two of them belongs to neither

/// Shares of the corners at a point of the plane; one below 0 outside.
glm::dvec3 shares(const std::array<glm::dvec2, 3>& c, const glm::dvec2& p)
{
    const glm::dvec2 a = c[1] - c[0], b = c[2] - c[0], q = p - c[0];
    const double area = a.x * b.y - a.y * b.x;
    const double second = (q.x * b.y - q.y * b.x) / area, third = (a.x * q.y - a.y * q.x) / area;
    return {1.0 - second - third, second, third};
}

bool ray_by_uv(const MeshCamera& camera, const glm::dvec2& at, csg::Ray& out)
{
    const std::size_t cell = static_cast<std::size_t>(MeshCamera::cell_of(at.y)) * MeshCamera::kCells +
                             static_cast<std::size_t>(MeshCamera::cell_of(at.x));
    for (std::uint32_t i = camera.cell_first[cell]; i < camera.cell_first[cell + 1]; ++i) {
        const MeshCamera::Corners& face = camera.corners[camera.cell_faces[i]];
        const glm::dvec3 w = shares(face.uv, at);
        if (!(w.x >= -kUvEdge && w.y >= -kUvEdge && w.z >= -kUvEdge)) continue;
        out.origin = w.x * face.rays[0].origin + w.y * face.rays[1].origin + w.z * face.rays[2].origin;
        out.direction =
            glm::normalize(w.x * face.rays[0].direction + w.y * face.rays[1].direction + w.z * face.rays[2].direction);
        return true;
    }
    return false;
}

/// The column and the row of faces that a sample shows, whole numbers in 3.8; in 3.7 places between them.
glm::dvec2 place_of(const MeshCamera& camera, double px, double py, int width, int height)
{
    const auto within = [](double v, int count) { return std::clamp(v, 0.0, count - 1.0); };
    if (camera.povray == scene::PovRay::V38)
        return {within(std::floor(px + 0.5), width), within(std::floor(py + 0.5), height)};
    // Half a pixel above the sample: the first two rows of a picture show the same faces, as POV-Ray 3.7's do.
    return {within(px + 0.5, width), within(py - 0.5, height)};
}

/// Where a sample lies in the unit square of coordinates.
glm::dvec2 uv_of(const MeshCamera& camera, double px, double py, int width, int height)
{
    if (camera.povray == scene::PovRay::V38) return {(px + 0.5) / width, 1.0 - (py + 0.5) / height};
    const glm::dvec2 at = place_of(camera, px, py, width, height);
    return {(at.x - 0.5) / width, 1.0 - (at.y + 0.5) / height};
}

/// The face that a sample shows and its mesh; nulls: there is none.
struct Shown {
    const MeshCamera::Ray* face = nullptr;
    const MeshCamera::Mesh* mesh = nullptr;
};

/// Not for method ByUv.
Shown shown(const MeshCamera& camera, double x, double y, int width, int k)
{
    const double column = std::floor(x), row = std::floor(y);
    double face = row * width + column;
    const MeshCamera::Mesh* mesh = &camera.meshes.back();
    if (camera.method == Method::MeshPerRay) {
        mesh = &camera.meshes[static_cast<std::size_t>(k)];
    } else if (camera.method == Method::AllInOne) {
        face += static_cast<double>(k) * (mesh->number + mesh->count);
        if (face >= mesh->number + mesh->count) return {};
        const auto begins_after = [](double number, const MeshCamera::Mesh& m) { return number < m.number; };
        mesh = &*std::prev(std::upper_bound(camera.meshes.begin(), camera.meshes.end(), face, begins_after));
        face -= mesh->number;
    } else {
        const double wide = static_cast<double>(width) / static_cast<double>(camera.meshes.size());
        const auto which = std::min(static_cast<std::size_t>(x / wide), camera.meshes.size() - 1);
        mesh = &camera.meshes[which];
        face = row * std::floor(wide) + column;
    }
    if (!(face < mesh->count)) return {};
    return {camera.faces.data() + (mesh->first + static_cast<std::uint32_t>(face)), mesh};
}

}  // namespace

bool mesh_camera_ray(const MeshCamera& camera, double px, double py, int width, int height, int k, csg::Ray& out)
{
    if (camera.method == Method::ByUv) return ray_by_uv(camera, uv_of(camera, px, py, width, height), out);
    const glm::dvec2 at = place_of(camera, px, py, width, height);
    const auto [face, mesh] = shown(camera, at.x, at.y, width, k);
    if (face == nullptr) return false;
    const MeshCamera::Ray ray = face->moved(mesh->to_world);
    out = {ray.origin, ray.direction};
    return true;
}

void fetch_mesh_camera_ray(const MeshCamera& camera, double px, double py, int width, int height, int k)
{
    if (camera.method == Method::ByUv) return;
    const glm::dvec2 at = place_of(camera, px, py, width, height);
    const MeshCamera::Ray* const face = shown(camera, at.x, at.y, width, k).face;
    if (face == nullptr) return;
    __builtin_prefetch(face);
    __builtin_prefetch(&face->direction.z);
}

}  // namespace trace
