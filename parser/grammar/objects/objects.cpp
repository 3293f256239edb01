#include "csg/freeform/freeform.h"
#include "csg/solids/freeform.h"
#include "parser/grammar/core/rules.h"
#include "parser/grammar/core/solid_reader.h"

#include <algorithm>

namespace parser {
namespace {

using Shared = std::shared_ptr<const scene::Object>;

scene::CsgOp op_of(Kind keyword)
{
    switch (keyword) {
    case Kind::Intersection: return scene::CsgOp::Intersection;
    case Kind::Difference: return scene::CsgOp::Difference;
    case Kind::Merge: return scene::CsgOp::Merge;
    default: return scene::CsgOp::Union;
    }
}

/// object { NAME or any object statement, modifiers }.
scene::Object read_wrapper(SceneBuilder& build, const scene::SourceRef& source)
{
    const auto opened = build.open_block("object");
    auto object = read_object(build);
    if (!object) build.fail_unknown("an object or the name of one");
    object->source = source;
    read_modifiers(build, *object);
    build.close_block("object", opened);
    return *object;
}

}  // namespace

bool is_patch(const scene::Object& object)
{
    const auto* mesh = std::get_if<scene::Mesh>(&object.shape);
    const auto* freeform = std::get_if<scene::Freeform>(&object.shape);
    return std::holds_alternative<scene::Triangle>(object.shape) ||
           (mesh && mesh->data && !mesh->data->has_inside_vector) ||
           (freeform && csg::Freeform{freeform->shape, {}}.surface());
}

bool has_inside(const scene::Object& object)
{
    if (scene::is_light(object)) return false;
    const auto* freeform = std::get_if<scene::Freeform>(&object.shape);
    if (freeform && std::holds_alternative<csg::Polygon>(freeform->shape->kind)) return true;
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    return csg && csg->operands ? std::all_of(csg->operands->begin(), csg->operands->end(), has_inside)
                                : !is_patch(object);
}

/// Objects, `global_lights` and transformations: it takes no other modifier.
scene::Object read_light_group(SceneBuilder& build, const scene::SourceRef& source)
{
    const auto opened = build.open_block("light_group");
    scene::Object object;
    auto members = std::make_shared<std::vector<scene::Object>>();
    bool whole = false, global_lights = false;
    if (const auto declared = build.stream().accept_identifier<Shared>()) {
        // A copy of a group takes no further objects, and says anew whether it goes by global lights.
        const auto* csg = std::get_if<scene::Csg>(&(*declared)->shape);
        whole = csg != nullptr && csg->light_group;
        if (whole) object = **declared;
        else if ((*declared)->drawn()) members->push_back(**declared);
        else build.set_aside(**declared);
    }
    object.source = source;
    for (;;) {
        if (auto member = whole ? std::nullopt : read_object(build)) {
            if (member->drawn()) members->push_back(std::move(*member));
            else build.set_aside(std::move(*member));
        } else if (build.stream().accept(Kind::GlobalLights)) {
            global_lights = optional_flag(build.stream());
        } else if (const auto transform = read_transformation(build)) {
            object.transform_by(*transform);
        } else {
            break;
        }
    }
    if (whole) std::get<scene::Csg>(object.shape).global_lights = global_lights;
    else object.shape = scene::Csg{scene::CsgOp::Union, std::move(members), true, false, true, global_lights, {}};
    build.close_block("light_group", opened);
    return object;
}

scene::Object read_written(SceneBuilder& build, Kind keyword, const scene::SourceRef& source)
{
    const std::string name(spelling(keyword));
    scene::Object object;
    SolidReader reader(build, object);
    const auto opened = build.open_block(name.c_str());
    if (const auto declared = build.stream().accept_identifier<Shared>()) {
        object = **declared;
        object.source = source;
        read_modifiers(build, object);
    } else {
        object.source = source;
        if (!solid_head(keyword)(reader)) object.details.edit().unsupported = name;
        read_modifiers(build, object);
        if (forgets_inverse(object)) object.inverse = false;
    }
    build.close_block(name.c_str(), opened);
    return object;
}

scene::Object read_csg(SceneBuilder& build, Kind keyword, const scene::SourceRef& source)
{
    TokenStream& in = build.stream();
    const std::string name(spelling(keyword));
    const auto opened = build.open_block(name.c_str());
    scene::Object object;
    // A name right after the brace is the whole object; further operands are an error (spec 1, 14.2).
    if (const auto declared = in.accept_identifier<Shared>()) {
        object = **declared;
        object.source = source;
    } else {
        object.source = source;
        if (keyword == Kind::Composite) in.warn(source, "'composite' is an old word for 'union'");
        auto operands = std::make_shared<std::vector<scene::Object>>();
        std::size_t written = 0;
        while (auto operand = read_object(build)) {
            ++written;
            if ((keyword == Kind::Intersection || keyword == Kind::Difference) && !has_inside(*operand))
                in.warn(operand->source, "what has no inside cannot be cut or cut with");
            if (operand->drawn()) operands->push_back(std::move(*operand));
            else build.set_aside(std::move(*operand));
        }
        if (written < 2 && build.version() >= 150) in.warn(source, name + " should have at least two objects");
        operands->shrink_to_fit();  // a scene may have a hundred thousand of these
        object.shape = scene::Csg{op_of(keyword), std::move(operands), true, false, false, false, {}};
    }
    read_modifiers(build, object);
    build.close_block(name.c_str(), opened);
    return object;
}

std::optional<scene::Object> read_object(SceneBuilder& build)
{
    TokenStream& in = build.stream();
    const auto guard = in.nest();
    if (const auto declared = in.accept_identifier<Shared>()) {
        scene::Object copy = **declared;
        copy.source = in.last();
        return copy;
    }
    const Kind keyword = in.peek().kind;
    if (is_solid(keyword)) {
        in.next();
        return read_solid(build, keyword);
    }
    if (is_written(keyword)) {
        in.next();
        return read_written(build, keyword, in.last());
    }
    switch (keyword) {
    case Kind::Union:
    case Kind::Intersection:
    case Kind::Difference:
    case Kind::Merge:
    case Kind::Composite: in.next(); return read_csg(build, keyword, in.last());
    case Kind::LightGroup: in.next(); return read_light_group(build, in.last());
    case Kind::Object: in.next(); return read_wrapper(build, in.last());
    case Kind::LightSource: in.next(); return read_light(build, in.last());
    case Kind::Mesh: in.next(); return read_mesh(build, in.last());
    case Kind::Mesh2: in.next(); return read_mesh2(build, in.last());
    default: return std::nullopt;
    }
}

}  // namespace parser
