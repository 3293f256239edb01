#include "csg/freeform.h"
#include "parser/grammar/shape_makers.h"

#include <algorithm>
#include <map>

/// julia_fractal (reference manual: Julia Fractal).
namespace parser {
namespace {

using Function = csg::JuliaTerms::Function;

constexpr double kNoSlice = 1e-10;        // a normal is too short, or does not lean into the fourth dimension (spec 5b, 12.1)
constexpr double kMostIterations = 1e6;   // what does not end is of no use

Function function_of(std::string_view name, bool quaternion)
{
    static const std::map<std::string_view, Function> kFunctions = {
        {"sqr", Function::HyperSquare}, {"cube", Function::HyperCube}, {"reciprocal", Function::Reciprocal}, {"exp", Function::Exp},
        {"ln", Function::Ln},           {"sin", Function::Sin},        {"asin", Function::Asin},             {"cos", Function::Cos},
        {"acos", Function::Acos},       {"tan", Function::Tan},        {"atan", Function::Atan},             {"sinh", Function::Sinh},
        {"asinh", Function::Asinh},     {"cosh", Function::Cosh},      {"acosh", Function::Acosh},           {"tanh", Function::Tanh},
        {"atanh", Function::Atanh},     {"pwr", Function::Power}};
    if (quaternion) return name == "cube" ? Function::Cube : Function::Square;
    return kFunctions.at(name);
}

}  // namespace

bool make_julia(SceneBuilder& build, const scene::Statement& statement, scene::Object& object)
{
    csg::JuliaTerms terms;
    std::string_view name = "sqr";
    bool quaternion = true;
    for (const auto& item : statement.items) {
        const auto number = [&](std::size_t i) { return number_of(item.operands[i]); };
        if (item.name.empty()) terms.constant = std::get<glm::dvec4>(item.operands[0]);
        else if (item.name == "max_iteration") terms.iterations = static_cast<int>(std::clamp(number(0), 1.0, kMostIterations));
        else if (item.name == "precision") terms.precision = std::max(number(0), 1.0);
        else if (item.name == "quaternion") quaternion = true;
        else if (item.name == "hypercomplex") quaternion = false;
        else if (item.name == "slice") {
            terms.slice = std::get<glm::dvec4>(item.operands[0]);
            terms.slice_distance = number(1);
            if (std::abs(terms.slice.w) < kNoSlice)
                build.stream().fail(statement.source, "the slice's normal must have a fourth component that is not 0");
        } else {
            name = item.name;
            if (name == "pwr") terms.exponent = {number(0), number(1)};
        }
    }
    terms.function = function_of(name, quaternion);
    object.shape = scene::Freeform{csg::make_freeform<csg::Julia>(terms)};
    return true;
}

}  // namespace parser
