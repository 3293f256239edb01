#include "render/lint/findings.h"
#include "render/lint/walk.h"
#include "render/plan/geometry/extent.h"
#include "render/plan/probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <unordered_map>
#include <unordered_set>

namespace lint {
namespace {

struct Lamp {
    glm::dvec3 location;
    scene::SourceRef source;
};

/// What the whole scene is like.
struct Survey {
    std::vector<Lamp> lamps;
    std::unordered_set<const scene::Object*> clear;  ///< top objects that let some light through
    bool glowing = false;
};

Survey survey(const scene::Description& description)
{
    Survey out;
    walk(description, [&](const Visited& at) {
        if (const auto* light = std::get_if<scene::Shared<scene::Light>>(&at.object.shape)) {
            out.lamps.push_back({at.parent_to_world.point((*light)->location), at.object.source});
            return;
        }
        const scene::TexturePtr& usual = description.default_of(at.top);
        const scene::Texture* texture = at.texture ? at.texture : usual.get();
        if (!texture) return;
        if (!out.glowing && glows(*texture)) out.glowing = true;
        if (!out.clear.contains(&at.top) && lets_light_through(*texture)) out.clear.insert(&at.top);
        if (at.object.details->interior && !at.object.details->interior->media.empty()) out.glowing = true;
    });
    return out;
}

/// Asks the top objects of a scene for points.
class Insides {
public:
    explicit Insides(const scene::Description& description) : description_(description) {}
    bool inside(const scene::Object& object, const glm::dvec3& point)
    {
        const auto box = boxes_.try_emplace(&object, csg::Aabb{});
        if (box.second) box.first->second = plan::described_extent(object);
        const csg::Aabb& extent = box.first->second;
        if (glm::any(glm::lessThan(point, extent.lower)) || glm::any(glm::greaterThan(point, extent.upper)))
            return false;
        auto& probe = probes_[&object];
        if (!probe) probe = std::make_unique<plan::ObjectProbe>(object, description_.global);
        return probe->inside(point);
    }

private:
    const scene::Description& description_;
    std::unordered_map<const scene::Object*, csg::Aabb> boxes_;
    std::unordered_map<const scene::Object*, std::unique_ptr<plan::ObjectProbe>> probes_;
};

bool hollow(const scene::Object& object)
{
    return object.flags.hollow.value_or(false) || (object.details->interior && object.details->interior->hollow);
}

void check_insides(Findings& out, const scene::Description& description, const Survey& survey)
{
    constexpr std::size_t kMostLamps = 64;
    Insides insides(description);
    for (const scene::Object& object : description.objects) {
        if (scene::is_light(object)) continue;
        const bool around_camera = insides.inside(object, description.camera.location);
        if (around_camera && !hollow(object) && !object.flags.no_image)
            out.add("camera-inside", object.source,
                    fmt::format("the camera stands inside of this {}, which is not hollow", name_of(object)),
                    {{description.camera.source, "the camera"}});
        // A room or a sky has both in it.
        if (around_camera || object.flags.no_shadow || survey.clear.contains(&object)) continue;
        for (std::size_t i = 0; i < std::min(survey.lamps.size(), kMostLamps); ++i)
            if (insides.inside(object, survey.lamps[i].location))
                out.add("light-inside", survey.lamps[i].source,
                        fmt::format("this light stands inside of a {} that lets no light through", name_of(object)),
                        {{object.source, "inside of this"}});
    }
}

/// A ray of the camera through a point of the picture; both coordinates from -0.5 to 0.5.
csg::Ray camera_ray(const scene::Camera& camera, double x, double y)
{
    const glm::dvec3 aside = x * camera.right + y * camera.up;
    if (camera.kind == scene::Camera::Kind::Orthographic)
        return {camera.location + aside, glm::normalize(camera.direction)};
    return {camera.location, glm::normalize(camera.direction + aside)};
}

bool in_view(const scene::Camera& camera, const glm::dvec3& point, glm::dvec2& at)
{
    const glm::dmat3 frame(camera.right, camera.up, camera.direction);
    if (glm::determinant(frame) == 0) return false;
    const glm::dvec3 local = glm::inverse(frame) * (point - camera.location);
    if (!(local.z > 0)) return false;
    const bool parallel = camera.kind == scene::Camera::Kind::Orthographic;
    at = parallel ? glm::dvec2(local) : glm::dvec2(local) / local.z;
    return glm::abs(at.x) <= 0.5 && glm::abs(at.y) <= 0.5;
}

bool anything_in_view(const scene::Description& description)
{
    const scene::Camera& camera = description.camera;
    scene::Csg all;
    auto operands = std::make_shared<std::vector<scene::Object>>();
    for (const scene::Object& object : description.objects)
        if (!scene::is_light(object) && !object.flags.no_image) operands->push_back(object);
    if (operands->empty()) return false;
    all.operands = operands;
    scene::Object whole;
    whole.shape = all;
    plan::ObjectProbe probe(whole, description.global);
    const auto meets = [&](const csg::Ray& ray) { return probe.trace(ray.origin, ray.direction).hit; };
    constexpr int kWide = 96, kHigh = 72;
    for (int y = 0; y < kHigh; ++y)
        for (int x = 0; x < kWide; ++x)
            if (meets(camera_ray(camera, (x + 0.5) / kWide - 0.5, (y + 0.5) / kHigh - 0.5))) return true;
    // What is too small for that: rays to points of each box.
    for (const scene::Object& object : *operands) {
        const csg::Aabb box = plan::described_extent(object);
        for (int i = 0; i < 125; ++i) {
            const glm::dvec3 share = glm::dvec3(i % 5, i / 5 % 5, i / 25) / 4.0;
            glm::dvec2 at;
            if (!in_view(camera, box.lower + share * (box.upper - box.lower), at)) continue;
            if (meets(camera_ray(camera, at.x, at.y))) return true;
        }
    }
    return false;
}

bool can_ask(const scene::Camera& camera)
{
    return (camera.kind == scene::Camera::Kind::Perspective || camera.kind == scene::Camera::Kind::Orthographic) &&
           camera.direction != glm::dvec3(0);
}

}  // namespace

void check_space(Findings& out, const scene::Description& description)
{
    if (description.objects.empty()) return;  // the parser says so
    const Survey all = survey(description);
    if (out.wants("no-light") && all.lamps.empty() && !all.glowing && !description.global.radiosity &&
        description.media.empty())
        out.add("no-light", description.camera.source, "the scene has no light, and nothing in it glows");
    if (out.wants("light-inside") || out.wants("camera-inside")) check_insides(out, description, all);
    if (out.wants("empty-picture") && !description.sky_sphere && can_ask(description.camera) &&
        !anything_in_view(description))
        out.add("empty-picture", description.camera.source, "no object is in view of this camera");
}

}  // namespace lint
