#include "render/plan/lights.h"

#include "csg/items/depth_range.h"
#include "numbers/functions/functions.h"
#include "render/light/attenuation.h"
#include "render/plan/probe.h"

#include <numbers>
#include <vector>

namespace plan {
namespace {

/// Unit vector; the axis of a light that points at itself is z.
glm::dvec3 unit(const glm::dvec3& v)
{
    const double length = glm::length(v);
    return length > 0.0 ? v / length : glm::dvec3(0, 0, 1);
}

/// Goes over an area light's nodes as they are asked for where no shadow divides the grid further.
struct NodeOrder {
    const light::Light& light;
    std::vector<bool> asked =
        std::vector<bool>(static_cast<std::size_t>(light.size1) * static_cast<std::size_t>(light.size2));
    bool fresh = false;  ///< the rectangle at hand has a corner that no other had before it

    void ask(int i, int j)
    {
        const std::size_t at = static_cast<std::size_t>(i) * static_cast<std::size_t>(light.size2) +
                               static_cast<std::size_t>(j);
        fresh = fresh || !asked[at];
        asked[at] = true;
    }
    void rectangle(int i1, int j1, int i2, int j2, int depth)
    {
        fresh = false;
        ask(i1, j1), ask(i2, j1), ask(i1, j2), ask(i2, j2);
        if (depth >= light.adaptive || !(i2 - i1 > 1 || j2 - j1 > 1)) return;
        const int i_low = (i1 + i2) / 2, i_high = (i1 + i2 + 1) / 2, j_low = (j1 + j2) / 2, j_high = (j1 + j2 + 1) / 2;
        rectangle(i1, j1, i_low, j_low, depth + 1);
        rectangle(i_high, j1, i2, j_low, depth + 1);
        rectangle(i1, j_high, i_low, j2, depth + 1);
        rectangle(i_high, j_high, i2, j2, depth + 1);
    }
};

/// Whether the last rectangle has corners of others alone.
bool ends_with_known_nodes(const light::Light& light)
{
    NodeOrder order{light};
    order.rectangle(0, 0, light.size1 - 1, light.size2 - 1, 0);
    return !order.fresh;
}

struct ProjectingObject final : light::Projector {
    explicit ProjectingObject(const scene::Object& object) : probe(object) {}
    csg::World world() const override { return probe.world(); }
    ObjectProbe probe;
};

}  // namespace

light::Light compile_light(const scene::Light& description, const csg::Transform& to_world, const Quality& quality)
{
    constexpr double kDegree = std::numbers::pi / 180.0;
    light::Light out;
    out.location = to_world.point(description.location);
    out.point_at = to_world.point(description.point_at);
    out.axis = unit(out.point_at - out.location);
    if (description.directional) {  // from farther than anything is drawn
        out.axis = unit(to_world.vector(description.point_at));
        out.point_at = glm::dvec3(0);
        out.location = -csg::DepthRange::kFar * out.axis;
    }
    out.color = description.color;
    out.shadowless = description.shadowless;
    out.parallel = description.parallel;
    switch (description.kind) {
    case scene::Light::Kind::Point: break;
    case scene::Light::Kind::Spot:
        // Parallel rays all run along the axis, so the cone has no edge; but it does not reach behind the light.
        out.kind = light::Light::Kind::Spot;
        out.cos_radius = numbers::cos(description.radius_deg * kDegree);
        out.cos_falloff = numbers::cos(description.falloff_deg * kDegree);
        break;
    case scene::Light::Kind::Cylinder:
        out.kind = light::Light::Kind::Cylinder;
        out.parallel = true;
        out.radius = description.radius_deg;
        out.falloff = description.falloff_deg;
        break;
    }
    out.tightness = description.tightness;
    out.fade_distance = description.fade_distance;
    out.fade_power = description.fade_power;
    out.fades_from_start = description.fades_from_start && out.fade_power > 0.0 &&
                           std::abs(out.fade_distance) <= light::kLeastFadeDistance;
    out.area = description.area && quality.area_lights;
    out.area_illumination = out.area && description.area_illumination;
    out.circular = description.circular || description.orient;
    out.orient = description.orient;
    out.jitter = description.jitter;
    out.axis1 = to_world.vector(description.axis1);
    out.axis2 = to_world.vector(description.axis2);
    out.size1 = description.size1;
    out.size2 = description.size2;
    out.adaptive = description.adaptive;
    out.dimmed_twice = out.area && description.media_attenuation && ends_with_known_nodes(out);
    out.in_media = description.media_interaction && !description.shadowless;
    out.atmosphere = description.media_attenuation && description.media_interaction;
    if (description.projected_through) {
        scene::Object object = *description.projected_through;
        object.transform_by(to_world);
        out.projector = std::make_shared<ProjectingObject>(object);
    }
    return out;
}

}  // namespace plan
