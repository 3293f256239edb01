#include "render/study/solver_accuracy.h"

#include "csg/freeform/freeform.h"

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

namespace study {
namespace {

bool solves(const scene::Object& object)
{
    if (const auto* freeform = std::get_if<scene::Freeform>(&object.shape)) {
        const auto& kind = freeform->shape->kind;
        return std::holds_alternative<csg::Isosurface>(kind) || std::holds_alternative<csg::Parametric>(kind) ||
               std::holds_alternative<csg::Julia>(kind);
    }
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    return csg != nullptr && std::any_of(csg->operands->begin(), csg->operands->end(), solves);
}

std::shared_ptr<const csg::FreeformShape> scaled(const std::shared_ptr<const csg::FreeformShape>& shape, double share)
{
    if (const auto* surface = std::get_if<csg::Isosurface>(&shape->kind)) {
        csg::IsosurfaceTerms terms = surface->terms();
        terms.accuracy *= share;
        return csg::make_freeform<csg::Isosurface>(std::move(terms));
    }
    if (const auto* two = std::get_if<csg::Parametric>(&shape->kind)) {
        csg::ParametricTerms terms = two->terms();
        terms.accuracy *= share;
        return csg::make_freeform<csg::Parametric>(std::move(terms));
    }
    if (const auto* julia = std::get_if<csg::Julia>(&shape->kind)) {
        csg::JuliaTerms terms = julia->terms();
        terms.precision = std::max(1.0, terms.precision / share);  // its steps are one part of so many
        return csg::make_freeform<csg::Julia>(terms);
    }
    return shape;
}

class Scaling {
public:
    explicit Scaling(double share) : share_(share) {}

    void scale(scene::Object& object)
    {
        if (!solves(object)) return;
        if (auto* freeform = std::get_if<scene::Freeform>(&object.shape)) {
            auto& known = shapes_[freeform->shape];
            if (!known) known = scaled(freeform->shape, share_);
            freeform->shape = known;
            return;
        }
        auto& operands = std::get<scene::Csg>(object.shape).operands;
        auto& known = operands_[operands];
        if (!known) {
            std::vector<scene::Object> own(operands->begin(), operands->end());
            for (scene::Object& operand : own) scale(operand);
            known = std::make_shared<const std::vector<scene::Object>>(std::move(own));
        }
        operands = known;
    }

private:
    double share_;
    std::map<std::shared_ptr<const csg::FreeformShape>, std::shared_ptr<const csg::FreeformShape>> shapes_;
    std::map<std::shared_ptr<const std::vector<scene::Object>>, std::shared_ptr<const std::vector<scene::Object>>>
        operands_;
};

}  // namespace

bool has_solvers(const scene::ObjectList& objects)
{
    for (const scene::Object& object : objects)
        if (solves(object)) return true;
    return false;
}

void scale_accuracy(scene::ObjectList& objects, double share)
{
    Scaling scaling(share);
    for (std::size_t i = 0; i < objects.size(); ++i) scaling.scale(objects[i]);
}

}  // namespace study
