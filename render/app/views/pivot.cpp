#include "render/app/views/pivot.h"

#include "csg/world/world.h"

#include <algorithm>

namespace app {
namespace {

constexpr double kNearestPivot = 1e-4;   // scene units: an eye that stands on a surface turns about what is before it
constexpr std::uint8_t kAnyKind = 0xff;  // whatever rays an object is hidden from

}  // namespace

double pivot_distance(const plan::CompiledScene& compiled)
{
    const scene::Camera& camera = compiled.camera;
    const double length = glm::length(camera.direction);
    if (length == 0.0) return 1.0;
    const csg::Ray ray{camera.location, camera.direction / length};
    csg::Scratch scratch;
    const csg::Hit hit = compiled.world().nearest(ray, kNearestPivot, numbers::kInfinity, kAnyKind, scratch);
    if (hit.found()) return hit.t;
    const csg::Aabb& box = compiled.geometry.bvh.bounds;
    const glm::dvec3 middle = box.finite() ? 0.5 * (box.lower + box.upper) : glm::dvec3(0.0);
    return std::max(glm::length(middle - camera.location), kNearestPivot);
}

}  // namespace app
