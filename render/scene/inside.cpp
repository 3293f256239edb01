#include "render/scene/inside.h"

#include "csg/freeform/freeform.h"
#include "csg/freeform/freeform_solid.h"

namespace scene {

bool is_patch(const Object& object)
{
    const auto* mesh = std::get_if<Mesh>(&object.shape);
    const auto* freeform = std::get_if<Freeform>(&object.shape);
    return std::holds_alternative<Triangle>(object.shape) ||
           std::holds_alternative<Shared<SmoothTriangle>>(object.shape) ||
           (mesh && mesh->data && !mesh->data->has_inside_vector) ||
           (freeform && csg::Freeform{freeform->shape, {}}.surface());
}

bool has_inside(const Object& object)
{
    if (is_light(object)) return false;
    const auto* freeform = std::get_if<Freeform>(&object.shape);
    if (freeform && std::holds_alternative<csg::Polygon>(freeform->shape->kind)) return true;
    const auto* csg = std::get_if<Csg>(&object.shape);
    return csg ? csg->has_inside : !is_patch(object);
}

}  // namespace scene
