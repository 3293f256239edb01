#include "csg/freeform/freeform.h"
#include "csg/freeform/freeform_solid.h"
#include "parser/grammar/core/rules.h"
#include "parser/grammar/core/solid_reader.h"
#include "parser/grammar/objects/mesh_lists.h"
#include "parser/grammar/objects/solids.h"

#include <algorithm>

namespace parser {
namespace {

using Shared = std::shared_ptr<const scene::Object>;

/// object { NAME or any object statement, modifiers }.
void read_wrapper(SceneBuilder& build, Kind, scene::Object& object)
{
    const scene::SourceRef source = build.stream().last();
    const auto opened = build.open_block("object");
    if (!read_object(build, object)) build.fail_unknown("an object or the name of one");
    object.source = source;
    read_modifiers(build, object);
    build.close_block("object", opened);
}

/// Objects that are read one after the other, until they move to where they stay in an array of just their size.
/// Objects within objects use the same memory.
class Gathered {
public:
    explicit Gathered(SceneBuilder& build) : all_(build.gathered), below_(all_.size()) {}
    ~Gathered() { all_.erase(first(), all_.end()); }
    Gathered(const Gathered&) = delete;
    Gathered& operator=(const Gathered&) = delete;
    scene::Object& place() { return all_.emplace_back(); }
    void drop() { all_.pop_back(); }
    void add(scene::Object object) { all_.push_back(std::move(object)); }
    std::shared_ptr<const std::vector<scene::Object>> take()
    {
        return std::make_shared<const std::vector<scene::Object>>(std::make_move_iterator(first()),
                                                                  std::make_move_iterator(all_.end()));
    }

private:
    std::vector<scene::Object>::iterator first() { return all_.begin() + static_cast<std::ptrdiff_t>(below_); }
    std::vector<scene::Object>& all_;
    std::size_t below_;
};

/// Operands of CSG.
struct Operands final : ObjectReceiver {
    Operands(SceneBuilder& builder, bool cuts_inside) : build(builder), objects(builder), cuts(cuts_inside) {}
    scene::Object& place() override { return objects.place(); }
    bool keep() override
    {
        const bool inside = has_inside(build.gathered.back());
        if (cuts && !inside) return false;
        all_inside = all_inside && inside;
        ++written;
        return true;
    }
    void drop() override { objects.drop(); }

    SceneBuilder& build;
    Gathered objects;
    const bool cuts;  ///< each has to have an inside
    bool all_inside = true;
    std::size_t written = 0;
};

}  // namespace

std::optional<scene::CsgOp> csg_op(Kind keyword)
{
    switch (keyword) {
    case Kind::Composite:
    case Kind::Union: return scene::CsgOp::Union;
    case Kind::Intersection: return scene::CsgOp::Intersection;
    case Kind::Difference: return scene::CsgOp::Difference;
    case Kind::Merge: return scene::CsgOp::Merge;
    default: return std::nullopt;
    }
}

namespace {

/// Its own objects, then what comes of them.
template <class More>
Form csg_form()
{
    return Form::braces({Form::optional(Form::operand("identifier")), Form::repeated(Form::named(any_object)),
                         Form::repeated(Form::choice({form_of<More>(), Form::named(object_modifier)}))});
}
Production union_block() { return {"union_block", csg_form<seq<token<Kind::SplitUnion>, a_number>>()}; }
Production cut_block() { return {"cut_block", csg_form<token<Kind::CutawayTextures>>()}; }
Production object_block()
{
    return {"object_block", Form::braces({Form::named(any_object), Form::repeated(Form::named(object_modifier))})};
}
Production light_group_block()
{
    const Form lights = Form::sequence({Form::token(Kind::GlobalLights), form_of<a_flag>()});
    return {
        "light_group_block",
        Form::braces({Form::optional(Form::operand("identifier")),
                      Form::repeated(Form::choice({Form::named(any_object), lights, Form::named(transformation)}))})};
}

}  // namespace

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
    else {
        const bool inside = std::all_of(members->begin(), members->end(), has_inside);
        object.shape =
            scene::Csg{scene::CsgOp::Union, std::move(members), true, false, true, global_lights, inside, {}};
        object.forgets_inverse = some_forget_inverse(object);
    }
    build.close_block("light_group", opened);
    return object;
}

void read_written(SceneBuilder& build, Kind keyword, scene::Object& object)
{
    const std::string_view name = spelling(keyword);
    const scene::SourceRef source = build.stream().last();
    SolidReader reader(build, object);
    const auto opened = build.open_block(name);
    if (const auto declared = build.stream().accept_identifier<Shared>()) {
        object = **declared;
        object.source = source;
        read_modifiers(build, object);
    } else {
        object.source = source;
        if (!solid_head(keyword)(reader)) object.details.edit().unsupported = name;
        read_modifiers(build, object);
        object.flags.unclipped_box = keyword == Kind::Blob || keyword == Kind::JuliaFractal ||
                                     keyword == Kind::HeightField;
        if (kind_forgets_inverse(object) && build.stream().povray() == scene::PovRay::V37) {
            object.inverse = false;
            object.forgets_inverse = true;
        }
    }
    build.close_block(name, opened);
}

void read_csg(SceneBuilder& build, Kind keyword, scene::Object& object)
{
    TokenStream& in = build.stream();
    const scene::SourceRef source = in.last();
    const std::string_view name = spelling(keyword);
    const auto opened = build.open_block(name);
    // A name right after the brace is the whole object; further operands are an error (spec 1, 14.2).
    if (const auto declared = in.accept_identifier<Shared>()) {
        object = **declared;
        object.source = source;
    } else {
        object.source = source;
        if (keyword == Kind::Composite) in.warn(source, "'composite' is an old word for 'union'");
        Operands operands(build, keyword == Kind::Intersection || keyword == Kind::Difference);
        for (;; ++operands.written) {
            scene::Object operand;
            peek_for(in, build.receiver, operands);
            if (!read_object(build, operand)) break;
            const bool inside = has_inside(operand);
            if (operands.cuts && !inside)
                in.warn(operand.source, "what has no inside cannot be cut or cut with" + why_open(operand));
            if (operand.drawn()) {
                operands.all_inside = operands.all_inside && inside;
                operands.objects.add(std::move(operand));
            } else build.set_aside(std::move(operand));
        }
        if (operands.written < 2 && build.version() >= 150)
            in.warn_when_closed(source, std::string(name) + " should have at least two objects");
        object.shape =
            scene::Csg{*csg_op(keyword), operands.objects.take(), true, false, false, false, operands.all_inside, {}};
        object.forgets_inverse = some_forget_inverse(object);
    }
    read_modifiers(build, object);
    build.close_block(name, opened);
}

namespace {

/// What begins with a keyword of its own and is no solid with parameters.
template <scene::Object (*read)(SceneBuilder&, const scene::SourceRef&)>
void read_whole(SceneBuilder& build, Kind, scene::Object& object)
{
    object = read(build, build.stream().last());
}
constexpr struct {
    Kind keyword;
    Production (*block)();
    void (*read)(SceneBuilder&, Kind, scene::Object&);
} kBlocks[] = {
    {Kind::Union, union_block, read_csg},
    {Kind::Intersection, cut_block, read_csg},
    {Kind::Difference, cut_block, read_csg},
    {Kind::Merge, union_block, read_csg},
    {Kind::Composite, union_block, read_csg},
    {Kind::Object, object_block, read_wrapper},
    {Kind::LightGroup, light_group_block, read_whole<read_light_group>},
    {Kind::LightSource, light_source_block, read_whole<read_light>},
    {Kind::Mesh, mesh_block, read_whole<read_mesh>},
    {Kind::Mesh2, mesh2_block, read_whole<read_mesh2>},
};

}  // namespace

Production any_object()
{
    std::vector<Form> all{Form::operand("identifier"), Form::choice(solids_of_numbers()),
                          Form::choice(written_solids())};
    for (const auto& one : kBlocks) {
        all.push_back(Form::sequence({Form::token(one.keyword), Form::named(one.block)}));
        all.back().rare = one.keyword == Kind::Composite;
    }
    return {"object", Form::choice(std::move(all))};
}

bool read_object(SceneBuilder& build, scene::Object& object)
{
    TokenStream& in = build.stream();
    const auto guard = in.nest();
    const Kind keyword = in.peek().kind;
    if (is_solid(keyword)) {
        in.next();
        read_solid(build, keyword, object);
        return true;
    }
    if (const auto declared = in.accept_identifier<Shared>()) {
        object = **declared;
        object.source = in.last();
        return true;
    }
    if (is_written(keyword)) {
        in.next();
        read_written(build, keyword, object);
        return true;
    }
    for (const auto& one : kBlocks) {
        if (one.keyword != keyword) continue;
        in.next();
        one.read(build, keyword, object);
        return true;
    }
    return false;
}

}  // namespace parser
