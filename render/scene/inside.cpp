#include "render/scene/inside.h"

#include "csg/freeform/freeform.h"
#include "csg/freeform/freeform_solid.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

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

bool some_forget_inverse(const Object& object)
{
    const auto& operands = *std::get<Csg>(object.shape).operands;
    return std::any_of(operands.begin(), operands.end(), [](const Object& one) { return one.forgets_inverse; });
}

namespace {

/// \param turned  inverted by what holds it
void forget_inverse(Object& object, bool turned)
{
    if (!object.forgets_inverse) return;
    turned = turned != object.inverse;
    auto* csg = std::get_if<Csg>(&object.shape);
    if (csg == nullptr) {
        object.inverse = object.inverse != turned;
        return;
    }
    auto operands = std::make_shared<std::vector<Object>>(*csg->operands);
    for (Object& one : *operands)
        forget_inverse(one, turned != (csg->op == CsgOp::Difference && &one != &operands->front()));
    csg->operands = std::move(operands);
}

}  // namespace

void forget_inverse(Object& object) { forget_inverse(object, false); }

}  // namespace scene
