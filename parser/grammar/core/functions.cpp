#include "parser/grammar/core/productions.h"
#include "parser/grammar/core/scene_builder.h"
#include "parser/base/queries.h"
#include "render/scene/last_bits.h"
#include "render/scene/function.h"

#include <algorithm>
#include <iterator>

/// The scene's things inside functions, and the questions that are passed on to whoever can answer them.
namespace parser {
namespace {

using ObjectPtr = std::shared_ptr<const scene::Object>;

constexpr Kind kOfSurfaces[] = {Kind::Aoi, Kind::Average, Kind::Slope, Kind::Square, Kind::Triangular};
bool of_surfaces(Kind pattern)
{
    return std::find(std::begin(kOfSurfaces), std::end(kOfSurfaces), pattern) != std::end(kOfSurfaces);
}

}  // namespace

Production function_pattern_type()
{
    Form form = pattern_type().form;
    std::erase_if(form.parts, [](const Form& part) {
        return of_surfaces(part.is == Form::Is::Word ? part.word : part.parts.front().word);
    });
    return {"function_pattern_type", std::move(form)};
}

std::optional<function::SceneReference> SceneBuilder::parse_function_thing(TokenStream& stream)
{
    using Use = function::SceneUse;
    const Kind kind = stream.next().kind;
    if (kind == Kind::Transform) return read_transform(*this);
    if (kind == Kind::Pigment)
        return Use{Use::Kind::Pigment,
                   std::make_shared<scene::PigmentFunction>(read_pigment(*this, default_layer().pigment))};
    const scene::SourceRef opened = open_block("pattern");
    scene::Pattern pattern;
    pattern.source = opened;
    const Kind type = stream.peek().kind;
    const bool newer = type == Kind::Pavement || type == Kind::Tiling;  // in 3.7 patterns of surfaces (spec 7b, 11)
    if (of_surfaces(type) || (newer && stream.strictly_37()))
        stream.fail_expected("a pattern that a function can have");
    if (!read_pattern_type(*this, pattern)) stream.fail_expected("a pattern");
    close_list(*this, pattern);
    while (read_pattern_modifier(*this, pattern)) {}
    close_block("pattern", opened);
    return Use{Use::Kind::Pattern, std::make_shared<scene::PatternFunction>(std::move(pattern))};
}

/// An object that cannot be drawn yet is answered for as if it were nothing, and that is said.
bool SceneBuilder::is_unsupported(const ObjectPtr& object, const char* question)
{
    if (object->drawn()) return false;
    guessed = true;
    unsupported(std::string(question) + " of " + object->details->unsupported, stream_->last());
    return true;
}

bool SceneBuilder::solid(const ObjectPtr& object)
{
    if (object != solid_ && has_inside(*object)) solid_ = object;
    return object == solid_;
}

SceneQueries* SceneBuilder::queries()
{
    description.global.assumed_gamma = stream_->language().assumed_gamma;
    description.effective_version = stream_->language().effective_version();
    description.povray = stream_->povray();
    return stream_->options().queries;
}

std::optional<ObjectHit> SceneBuilder::trace(const ObjectPtr& object, const glm::dvec3& origin,
                                             const glm::dvec3& direction)
{
    if (is_unsupported(object, "trace()")) return ObjectHit{};
    SceneQueries* asked = queries();
    if (!asked) return std::nullopt;
    return asked->trace(object, origin, scene::unit(direction, stream_->povray()), description);
}

std::optional<bool> SceneBuilder::inside(const ObjectPtr& object, const glm::dvec3& point)
{
    if (is_unsupported(object, "inside()")) return false;
    SceneQueries* asked = queries();
    return asked && solid(object) ? std::optional(asked->inside(object, point, description)) : std::nullopt;
}

std::optional<csg::Aabb> SceneBuilder::extent(const ObjectPtr& object)
{
    // A unit box: programs divide by what they get.
    if (is_unsupported(object, "the extent")) return csg::Aabb{glm::dvec3(0.0), glm::dvec3(1.0)};
    SceneQueries* asked = queries();
    return asked ? std::optional(asked->extent(object)) : std::nullopt;
}

std::optional<glm::dvec3> SceneBuilder::turbulence(const glm::dvec3& point, int octaves, double lambda, double omega)
{
    SceneQueries* asked = queries();
    return asked ? std::optional(asked->turbulence(point, octaves, lambda, omega)) : std::nullopt;
}

std::optional<function::Values> SceneBuilder::evaluate(const function::FunctionPtr& called, const double* arguments)
{
    SceneQueries* asked = queries();
    return asked ? std::optional(asked->evaluate(called, arguments, description)) : std::nullopt;
}

bool SceneBuilder::evaluate(const function::FunctionPtr& called, std::span<const glm::dvec3> points,
                            std::span<function::Values> values)
{
    if (SceneQueries* asked = queries()) asked->evaluate(called, points, values, description);
    else if (called->asks_scene) return false;
    else
        for (std::size_t i = 0; i < points.size(); ++i)
            values[i] = function::evaluate_all(*called, &points[i].x, function::no_host());
    return true;
}

}  // namespace parser
