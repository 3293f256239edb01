#include "render/plan/geometry/geometry.h"

#include "render/plan/compile_photons.h"
#include "render/plan/lights.h"

#include "render/plan/geometry/unseen_lights.h"

#include <fmt/format.h>

#include <utility>

// Lights, which stand among the objects.
namespace plan {

void GeometryCompiler::collect_lights(const scene::Object& object, const Inherited& above)
{
    if (const auto* light = std::get_if<scene::Shared<scene::Light>>(&object.shape)) {
        add_light(object, **light, above);
        return;
    }
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    if (csg == nullptr) return;
    Inherited own;
    own.to_world = above.to_world * *object.transform;
    if (csg->light_group)
        own.light_group = light_group(object, own.to_world);  // of its own lights, none that stand deeper
    for (const scene::Object& operand : *csg->operands) collect_lights(operand, own);
}

void GeometryCompiler::add_light(const scene::Object& object, const scene::Light& light, const Inherited& above)
{
    light::Light compiled = compile_light(light, above.to_world, options_.quality);
    compiled.group = above.light_group;
    if (compiled.color == glm::vec3(0) && options_.lean.takes(LeanStep::BlackLights)) {
        ++black_lights_;
    } else {
        if (photons_) photons_->lights.push_back(photon_light(object, light, compiled));
        out_.lights.lights.push_back(std::move(compiled));
    }
    if (!light.looks_like) return;
    Inherited own = above;
    own.no_shadow = true;
    automatic_interior_.reset();
    collect_lights(*light.looks_like, own);
    add_top(*light.looks_like, own);
    automatic_interior_.reset();
}

void GeometryCompiler::drop_unseen_lights()
{
    if (!options_.lean.takes(LeanStep::UnseenLights)) return;
    const std::vector<bool> received = received_lights(out_, photons_.get());
    const auto unseen = [&](std::size_t i) { return !received[i]; };
    std::size_t kept = 0;
    auto& lights = out_.lights.lights;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (unseen(i)) {
            const glm::dvec3& at = lights[i].location;
            out_.decisions.push_back({fmt::format("light at <{:g}, {:g}, {:g}> left out", at.x, at.y, at.z),
                                      "nothing receives it",
                                      {},
                                      LeanStep::UnseenLights});
            continue;
        }
        if (kept != i) lights[kept] = std::move(lights[i]);
        if (photons_) photons_->lights[kept] = photons_->lights[i];
        ++kept;
    }
    lights.resize(kept);
    if (photons_) photons_->lights.resize(kept);
}

}  // namespace plan
