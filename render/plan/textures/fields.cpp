#include "render/plan/textures/fields.h"

#include "function/build/builder.h"
#include "function/field/field.h"
#include "render/plan/textures/textures.h"
#include "render/texture/function_host.h"

namespace plan {
namespace {

/// What one function asks of the scene, owned by its field.
struct FieldHost final : function::Host {
    texture::TextureSet set;
    texture::FunctionHost host{set};
    const void* texture_set() const override { return &set; }

    double noise(const glm::dvec3& p, int generator) const override { return host.noise(p, generator); }
    double pattern(std::uint32_t slot, const glm::dvec3& p) const override { return host.pattern(slot, p); }
    std::array<double, 5> pigment(std::uint32_t slot, const glm::dvec3& p) const override
    {
        return host.pigment(slot, p);
    }
};

/// 1 everywhere: nothing lies inside.
function::FunctionPtr outside()
{
    function::Builder build(3);
    return build.finish(build.constant(1.0));
}

const function::FunctionField* asking(const std::shared_ptr<const csg::Field>& field)
{
    const auto* function = dynamic_cast<const function::FunctionField*>(field.get());
    return function && function->function()->asks_scene ? function : nullptr;
}

}  // namespace

std::shared_ptr<const csg::Field> FieldLinker::linked(const std::shared_ptr<const csg::Field>& field)
{
    const function::FunctionField* asks = asking(field);
    if (!asks) return field;
    const auto host = std::make_shared<FieldHost>();
    TextureCompiler compiler(scene_, quality_, host->set, notes_);
    const std::uint32_t slot = compiler.function(asks->function());
    return std::make_shared<const function::FunctionField>(
        slot == texture::kNone ? outside() : host->set.functions[slot], host, asks->negated());
}

std::shared_ptr<const csg::FreeformShape> FieldLinker::linked(const std::shared_ptr<const csg::FreeformShape>& shape)
{
    if (const auto* two = std::get_if<csg::Parametric>(&shape->kind)) {
        auto& known = known_[shape];
        if (known) return known;
        csg::ParametricTerms terms = two->terms();
        for (auto& field : terms.field) field = linked(field);
        csg::Parametric ready(std::move(terms));
        ready.prepare();
        return known = csg::make_freeform<csg::Parametric>(std::move(ready));
    }
    const auto* surface = std::get_if<csg::Isosurface>(&shape->kind);
    if (!surface || !(faithful_ || asking(surface->terms().field))) return shape;
    auto& known = known_[shape];
    if (!known) {
        csg::IsosurfaceTerms terms = surface->terms();
        terms.field = linked(terms.field);
        terms.trusting = faithful_;
        known = csg::make_freeform<csg::Isosurface>(std::move(terms));
    }
    return known;
}

}  // namespace plan
