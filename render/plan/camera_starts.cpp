#include "render/plan/camera_starts.h"

#include <algorithm>

namespace plan {
namespace {

/// Whether anything depends on the interiors that a ray is inside of: fog and media do, and light that surfaces let
/// through or mirror by fresnel.
bool interiors_matter(const CompiledScene& scene)
{
    return !scene.fogs.empty() || !scene.media.media.empty() ||
           std::any_of(scene.surfaces.begin(), scene.surfaces.end(), [](const Surface& s) { return !s.opaque; }) ||
           std::any_of(scene.textures.finishes.begin(), scene.textures.finishes.end(),
                       [](const texture::Finish& f) { return f.fresnel; });
}

const ObjectInfo& object_of(const CompiledScene& scene, std::uint32_t item)
{
    return scene.objects[scene.geometry.items[item].object];
}

/// Items that hold some place where rays start, where it may depend on the place.
void find_start_holders(CompiledScene& scene)
{
    if (!interiors_matter(scene)) return;
    const csg::Aabb starts = camera_starts(scene.camera, scene.mesh_camera.get());
    std::vector<std::uint32_t> holders;
    for (std::uint32_t i = 0; i < scene.geometry.items.size(); ++i) {
        const ObjectInfo& object = object_of(scene, i);
        if (object.interior == kNone || object.holds_starts.intersected(starts).empty()) continue;
        if (scene.world().item_may_hold(i, starts)) holders.push_back(i);
    }
    scene.world().in_test_order(holders);
    for (const std::uint32_t i : holders)
        scene.start_holders.push_back({i, object_of(scene, i).interior, object_of(scene, i).holds_starts});
}

}  // namespace

csg::Aabb camera_starts(const scene::Camera& camera, const MeshCamera* mesh)
{
    csg::Aabb box;
    if (camera.functions && camera.functions->location[0]) {
        constexpr double kAnywhere = 1e7;  // as far as POV-Ray draws anything
        return {glm::dvec3(-kAnywhere), glm::dvec3(kAnywhere)};
    }
    if (mesh != nullptr) {
        for (const MeshCamera::Ray& ray : mesh->faces) box.include(ray.origin);
        for (const MeshCamera::Corners& corners : mesh->corners)
            for (const MeshCamera::Ray& ray : corners.rays) box.include(ray.origin);
        return box;
    }
    const bool plane = camera.kind == scene::Camera::Kind::Orthographic,
               cylinder = camera.kind == scene::Camera::Kind::Cylinder;
    // Starts reach half of these to each side, and samples of small pictures a good way farther.
    const glm::dvec3 right = plane || (cylinder && camera.cylinder_type == 4) ? camera.right : glm::dvec3(0);
    const glm::dvec3 up = plane || (cylinder && camera.cylinder_type == 3) ? camera.up : glm::dvec3(0);
    for (const double u : {-1.0, 1.0})
        for (const double v : {-1.0, 1.0}) box.include(camera.location + u * right + v * up);
    if (blurred(camera)) {
        const glm::dvec3 lens(std::abs(camera.aperture));  // twice its radius: places are jittered
        box.lower -= lens;
        box.upper += lens;
    }
    return box;
}

void find_camera_interiors(CompiledScene& scene)
{
    if (starts_differ(scene.camera)) return find_start_holders(scene);
    const glm::dvec3& start = scene.camera.location;
    std::vector<std::uint32_t> holders;
    for (std::uint32_t i = 0; i < scene.geometry.items.size(); ++i) {
        const ObjectInfo& object = object_of(scene, i);
        if (object.interior != kNone && within(object.holds_starts, start) && scene.world().item_holds_start(i, start))
            holders.push_back(i);
    }
    scene.world().in_test_order(holders);
    for (const std::uint32_t i : holders)  // as often as there are objects that share it
        scene.camera_interiors.push_back(object_of(scene, i).interior);
}

}  // namespace plan
