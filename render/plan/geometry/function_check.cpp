#include "render/plan/geometry/function_check.h"

#include "csg/freeform/freeform.h"
#include "function/field/field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace plan {
namespace {

constexpr int kSide = 5;  // places along each axis
constexpr std::size_t kMostObjects = 100;

double between(double low, double high, int i) { return low + (high - low) * (i + 0.5) / kSide; }

bool asks_scene(const csg::Field& field)
{
    const auto* function = dynamic_cast<const function::FunctionField*>(&field);
    return function != nullptr && function->function()->asks_scene;
}

/// Of how many places the field gives no number, of how many.
struct Asked {
    int missing = 0, all = 0;

    void ask(const csg::Field& field, const glm::dvec3& at)
    {
        ++all;
        missing += std::isnan(field.value(at)) ? 1 : 0;
    }
};

class FunctionCheck {
public:
    explicit FunctionCheck(const scene::Description& description) : description_(description) {}

    void look(const scene::Object& object)
    {
        if (seen_.size() >= kMostObjects) return;
        if (const auto* csg = std::get_if<scene::Csg>(&object.shape)) {
            for (const scene::Object& operand : *csg->operands) look(operand);
            return;
        }
        const auto* freeform = std::get_if<scene::Freeform>(&object.shape);
        if (freeform == nullptr) return;
        const auto* solid = std::get_if<csg::Isosurface>(&freeform->shape->kind);
        const auto* sheet = std::get_if<csg::Parametric>(&freeform->shape->kind);
        if ((solid == nullptr && sheet == nullptr) || !seen_.insert(freeform->shape.get()).second) return;
        const Asked asked = solid != nullptr ? of(*solid) : of(*sheet);
        if (asked.missing == 0) return;
        out.push_back(fmt::format("{}: the function of this {} gives no number at {} of {} places that were asked: "
                                  "nothing is drawn there",
                                  scene::place_text(description_.place(object.source)),
                                  solid != nullptr ? "isosurface" : "parametric surface", asked.missing, asked.all));
    }

    std::vector<std::string> out;

private:
    static Asked of(const csg::Isosurface& solid)
    {
        Asked asked;
        const csg::Field& field = *solid.terms().field;
        const csg::Aabb box = solid.terms().container.bounds();
        if (asks_scene(field) || !box.finite()) return asked;
        for (int n = 0; n < kSide * kSide * kSide; ++n) {
            const glm::dvec3 at(between(box.lower.x, box.upper.x, n % kSide),
                                between(box.lower.y, box.upper.y, n / kSide % kSide),
                                between(box.lower.z, box.upper.z, n / (kSide * kSide)));
            if (solid.terms().container.contains(at)) asked.ask(field, at);
        }
        return asked;
    }
    static Asked of(const csg::Parametric& sheet)
    {
        Asked asked;
        const csg::ParametricTerms& terms = sheet.terms();
        for (const auto& field : terms.field)
            for (int n = 0; n < kSide * kSide && !asks_scene(*field); ++n)
                asked.ask(*field, {between(terms.lower.x, terms.upper.x, n % kSide),
                                   between(terms.lower.y, terms.upper.y, n / kSide), 0.0});
        return asked;
    }

    const scene::Description& description_;
    std::set<const csg::FreeformShape*> seen_;
};

}  // namespace

std::vector<std::string> functions_without_number(const scene::Description& description)
{
    FunctionCheck check(description);
    for (const scene::Object& object : description.objects) check.look(object);
    return std::move(check.out);
}

}  // namespace plan
