#include "render/plan/geometry/light_stops.h"

#include "render/plan/textures/dark_texture.h"

#include <algorithm>
#include <vector>

namespace plan {
namespace {

/// Of a texture: whether light comes through.
enum class Light : std::uint8_t { Comes, Stops, Opaque };

/// By texture.
std::vector<Light> light_through(const texture::TextureSet& set)
{
    std::vector<Light> out;
    const std::vector<bool> dark = dark_textures(set);
    for (std::uint32_t i = 0; i < set.textures.size(); ++i)
        out.push_back(set.textures[i].stops_light ? Light::Opaque : dark[i] ? Light::Stops : Light::Comes);
    return out;
}

/// The least that any of the surface's textures stops.
Light least_of(const CompiledScene& scene, const std::vector<Light>& through, const Surface& surface)
{
    Light least = Light::Opaque;
    const auto add = [&](std::uint32_t texture) {
        if (texture != kNone) least = std::min(least, through[texture]);
    };
    add(surface.texture);
    if (!surface.opaque_outside) add(surface.interior_texture);
    for (const std::uint32_t corner : surface.corner_textures) add(corner);
    for (std::uint32_t k = 0; k < surface.part_count; ++k) add(scene.part_textures[surface.first_part + k]);
    return least;
}

/// Calls f(surface) for all that an item may draw.
template <class F>
void each_surface(const csg::WorldData& world, const csg::WorldItem& item, F&& f)
{
    const auto part = [&](csg::PartId id) {
        if (csg::kind_of(id) != csg::SolidKind::Mesh) return f(world.store.surface(id));
        for (const csg::SurfaceId surface : world.store.all<csg::Mesh>()[csg::index_of(id)].surfaces) f(surface);
    };
    if (item.instance != csg::Hit::kNoInstance) {
        const csg::Instance& one = world.instances[item.instance];
        for (std::size_t k = 0; k < one.world->surface_opaque.size(); ++k)
            f(world.instance_surfaces[one.first_surface + k]);
    } else if (item.solid != csg::kNoPart) {
        part(item.solid);
    } else {
        for (const csg::Node& node : world.programs[item.program].nodes)
            if (node.op == csg::Op::Leaf) part(node.solid);
    }
}

/// What clear surfaces lie in; of more than a few one box is made.
class ClearPlaces {
public:
    void add(csg::Aabb box)
    {
        constexpr double kBeside = 0.01;  // ten times POV-Ray's tolerance
        constexpr std::size_t kMost = 64;
        box.lower -= kBeside;
        box.upper += kBeside;
        if (boxes_.size() < kMost) boxes_.push_back(box);
        else boxes_.front().include(box);
    }
    bool intersects(const csg::Aabb& box) const
    {
        return std::any_of(boxes_.begin(), boxes_.end(),
                           [&](const csg::Aabb& clear) { return !clear.intersected(box).empty(); });
    }

private:
    std::vector<csg::Aabb> boxes_;
};

}  // namespace

void find_light_stops(CompiledScene& scene)
{
    std::vector<Light> light;
    const std::vector<Light> through = light_through(scene.textures);
    for (const Surface& surface : scene.surfaces) light.push_back(least_of(scene, through, surface));
    const auto is = [&](Light what) {
        return [&light, what](csg::SurfaceId s) { return s < light.size() && light[s] == what; };
    };
    csg::WorldData& world = scene.geometry;
    const auto each_box = [&](auto&& which, auto&& f) {
        for (const csg::WorldItem& item : world.items) {
            bool some = false;
            each_surface(world, item, [&](csg::SurfaceId s) { some = some || which(s); });
            if (some) f(item, csg::drawn_bounds(world, item));
        }
    };
    if (std::find(light.begin(), light.end(), Light::Stops) != light.end()) {
        ClearPlaces clear;
        const auto comes = is(Light::Comes), stops = is(Light::Stops);
        each_box([&](csg::SurfaceId s) { return comes(s) && !scene.surfaces[s].no_shadow; },
                 [&](const csg::WorldItem&, const csg::Aabb& box) { clear.add(box); });
        each_box(stops, [&](const csg::WorldItem& item, const csg::Aabb& box) {
            if (!clear.intersects(box)) return;
            each_surface(world, item, [&](csg::SurfaceId s) {
                if (stops(s)) light[s] = Light::Comes;
            });
        });
    }
    world.surface_opaque.clear();
    for (std::size_t i = 0; i < light.size(); ++i) {
        scene.surfaces[i].opaque = light[i] != Light::Comes;
        world.surface_opaque.push_back(scene.surfaces[i].opaque ? 1 : 0);
    }
}

}  // namespace plan
