#include "csg/freeform.h"
#include "function/field.h"
#include "parser/grammar/shape_makers.h"

#include <algorithm>

/// Solids made of functions (reference manual: isosurface, parametric).
namespace parser {
namespace {

constexpr std::uint32_t kCoordinates = 3;

/// Null: it wants more than a point.
std::shared_ptr<const csg::Field> field_of(const scene::StatementItem& item)
{
    const auto& function = std::get<function::FunctionPtr>(item.operands[0]);
    if (function->parameters > kCoordinates) return nullptr;
    return std::make_shared<const function::FunctionField>(function);
}

/// The last value of that name.
double number(const scene::Statement& statement, std::string_view name, double otherwise)
{
    for (const auto& item : statement.items)
        if (item.name == name) otherwise = number_of(item.operands[0]);
    return otherwise;
}

csg::Container container_of(const scene::Statement& statement)
{
    csg::Container container;
    for (const auto& item : statement.items) {
        if (item.name == "contained_by sphere")
            container = csg::Container::sphere(std::get<glm::dvec3>(item.operands[0]), number_of(item.operands[1]));
        else if (item.name == "contained_by box")
            container = csg::Container::box(std::get<glm::dvec3>(item.operands[0]), std::get<glm::dvec3>(item.operands[1]));
    }
    return container;
}

/// What must be above 0; told where it is not.
double positive(SceneBuilder& build, const scene::Statement& statement, std::string_view name, double otherwise)
{
    const double given = number(statement, name, otherwise);
    if (given > 0.0) return given;
    build.stream().warn(statement.source, std::string(name) + " must be above 0: it is " + (otherwise < 1.0 ? ".001" : "1.1") + " now");
    return otherwise;
}

}  // namespace

bool make_isosurface(SceneBuilder& build, const scene::Statement& statement, scene::Object& object)
{
    constexpr int kMostTraced = 10;
    csg::IsosurfaceTerms terms;
    terms.field = field_of(*item_of(statement, "function"));
    if (!terms.field) return false;
    terms.threshold = number(statement, "threshold", terms.threshold);
    terms.accuracy = positive(build, statement, "accuracy", terms.accuracy);
    terms.max_gradient = positive(build, statement, "max_gradient", terms.max_gradient);
    terms.container = container_of(statement);
    for (const auto& item : statement.items) {
        if (item.name == "max_trace") terms.max_trace = static_cast<int>(std::clamp(number_of(item.operands[0]), 1.0, static_cast<double>(kMostTraced)));
        else if (item.name == "all_intersections") terms.max_trace = kMostTraced;
        else if (item.name == "open") terms.open = true;
        else if (item.name == "evaluate") {
            terms.evaluate = true;
            for (int k = 0; k < 3; ++k) terms.growth[k] = number_of(item.operands[static_cast<std::size_t>(k)]);
        }
    }
    object.shape = scene::Freeform{csg::make_freeform<csg::Isosurface>(std::move(terms))};
    return true;
}

bool make_parametric(SceneBuilder& build, const scene::Statement& statement, scene::Object& object)
{
    constexpr double kMostLevels = 20.0;
    csg::ParametricTerms terms;
    std::size_t axis = 0;
    for (const auto& item : statement.items) {
        if (item.name == "function") {
            terms.field[axis] = field_of(item);
            if (!terms.field[axis++]) return false;
        } else if (item.name == "range") {
            const auto a = std::get<glm::dvec2>(item.operands[0]), b = std::get<glm::dvec2>(item.operands[1]);
            terms.lower = glm::min(a, b);
            terms.upper = glm::max(a, b);
        } else if (item.name == "precompute") {
            const double levels = number_of(item.operands[0]);
            if (!(levels >= 1.0 && levels <= kMostLevels)) build.stream().fail(statement.source, "precompute needs 1 to 20 levels");
            terms.precompute = static_cast<int>(levels);
            for (std::size_t i = 1; i < item.operands.size(); ++i)
                terms.precomputed[static_cast<std::size_t>(std::get<std::string>(item.operands[i])[0] - 'x')] = true;
        }
    }
    terms.accuracy = positive(build, statement, "accuracy", terms.accuracy);
    terms.max_gradient = number(statement, "max_gradient", terms.max_gradient);
    terms.container = container_of(statement);
    object.shape = scene::Freeform{csg::make_freeform<csg::Parametric>(std::move(terms))};
    return true;
}

}  // namespace parser
