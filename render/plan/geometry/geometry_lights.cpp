#include "render/plan/geometry/geometry.h"

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
    if (compiled.color != glm::vec3(0)) {
        if (photons_) photons_->lights.push_back(photon_light(object, light, compiled));
        out_.lights.lights.push_back(std::move(compiled));
    } else out_.decisions.push_back({"left out a black light", "it lights nothing", {}});
    if (!light.looks_like) return;
    Inherited own = above;
    own.no_shadow = true;
    automatic_interiors_.clear();
    collect_lights(*light.looks_like, own);
    add_top(*light.looks_like, own);
    automatic_interiors_.clear();
}

}  // namespace plan
