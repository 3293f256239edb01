#include "csg/freeform/freeform.h"
#include "parser/grammar/scene/effects.h"
#include "parser/grammar/core/rules.h"
#include "parser/grammar/core/solid_reader.h"

#include <fmt/format.h>

/// Modifiers of any object, in the order written: each acts on what is there (spec 1, 14.3; 5a, 10).
namespace parser {
namespace {

using Layers = std::vector<scene::Layer>;

struct ObjectState : BlockState {
    ObjectState(SceneBuilder& b, scene::Object& o) : BlockState(b), object(o) {}
    scene::Object& object;

    /// The top layer of the object's own texture; the default texture is copied if there is none.
    template <class Change>
    void change_top(const char* what, Change&& change)
    {
        const auto copy = std::make_shared<scene::Texture>(object.texture ? *object.texture : *build.default_texture());
        auto* layers = std::get_if<Layers>(&copy->kind);
        if (!layers) stream().fail(stream().last(), fmt::format("'{}' cannot change a patterned texture", what));
        change(layers->back());
        if (object.texture) object.texture = copy;
        else take_texture(copy);
    }
    /// What has moved the top layer of the object's texture since that was given.
    csg::Transform since_textured() const
    {
        if (!object.flags.textured_late) return *object.transform;
        const std::shared_ptr<const csg::Transform>& declared = object.details->textured_at;
        return *object.transform * (declared ? *declared : build.textured_at()).inverted();
    }
    /// A texture, or a layer of it, that the object's transformations so far do not move.
    void take_texture(scene::TexturePtr texture)
    {
        object.flags.textured_late |= !object.transform->identity();
        if (object.flags.textured_late) build.textured_at() = *object.transform;
        if (object.details->textured_at) object.details.edit().textured_at.reset();
        object.texture = std::move(texture);
    }
};

struct texture : item<Kind::Texture, reads<texture_block>> {
    static void act(ObjectState& s)
    {
        const scene::SourceRef at = s.stream().last();
        s.take_texture(layered(s.build, std::move(s.object.texture), read_texture(s.build), at));
    }
};
struct interior_texture : item<Kind::InteriorTexture, reads<texture_block>> {
    static void act(ObjectState& s)
    {
        const scene::SourceRef at = s.stream().last();
        scene::TexturePtr& inner = s.object.details.edit().interior_texture;
        inner = layered(s.build, std::move(inner), read_texture(s.build), at);
    }
};
struct pigment : item<Kind::Pigment, reads<pigment_block>> {
    static void act(ObjectState& s)
    {
        const bool moved = s.object.texture && !s.object.flags.uv_mapping;
        s.change_top("pigment", [&](scene::Layer& top) {
            if (!moved) return void(top.pigment = read_pigment(s.build, top.pigment));
            // What moves a plain colour is noted nowhere else, to spare time: before a pattern comes in its place.
            const csg::Transform since = s.since_textured();
            top.pigment.move_space(since);
            top.pigment = read_pigment(s.build, top.pigment);
            top.pigment.move_space(since.inverted());
        });
    }
};
struct normal : item<Kind::Normal, reads<normal_block>> {
    static void act(ObjectState& s)
    {
        s.change_top("normal", [&](scene::Layer& top) {
            top.normal = std::make_shared<const scene::Normal>(read_normal(s.build, top.normal));
        });
    }
};
struct finish : item<Kind::Finish, reads<finish_block>> {
    static void act(ObjectState& s)
    {
        s.change_top("finish", [&](scene::Layer& top) { top.finish = read_finish(s.build, *top.finish); });
    }
};
struct interior : item<Kind::Interior, reads<interior_block>> {
    static void act(ObjectState& s)
    {
        std::shared_ptr<const scene::Interior>& own = s.object.details.edit().interior;
        own = std::make_shared<scene::Interior>(read_interior(s.build, own ? *own : scene::Interior{}));
    }
};
struct material : item<Kind::Material, reads<material_block>> {
    static void act(ObjectState& s)
    {
        const scene::ObjectDetails& before = *s.object.details;
        Material m = read_material(s.build, {s.object.texture, before.interior_texture, before.interior});
        s.take_texture(std::move(m.texture));
        if (!m.interior_texture && !m.interior && !s.object.details.given()) return;
        scene::ObjectDetails& details = s.object.details.edit();
        details.interior_texture = std::move(m.interior_texture);
        details.interior = std::move(m.interior);
    }
};

// ---- clipped_by, bounded_by -----------------------------------------------------------------------------------
/// What bounds or clips is a solid without a texture.
void check_bare(ObjectState& s, const scene::Object& object, const char* what)
{
    const auto* freeform = std::get_if<scene::Freeform>(&object.shape);
    const bool patch = is_patch(object) && !(freeform && std::holds_alternative<csg::Polygon>(freeform->shape->kind));
    if (patch || scene::is_light(object) || object.texture)
        s.stream().fail(object.source, std::string("an object in ") + what + " must be a solid without a texture");
    if (const auto* csg = std::get_if<scene::Csg>(&object.shape); csg && csg->operands)
        for (const scene::Object& operand : *csg->operands) check_bare(s, operand, what);
}

std::vector<scene::Object> read_group(ObjectState& s, const char* what)
{
    std::vector<scene::Object> group;
    bool any = false;
    while (auto object = read_object(s.build)) {
        check_bare(s, *object, what);
        if (object->drawn()) group.push_back(std::move(*object));
        else s.build.set_aside(std::move(*object));
        any = true;
    }
    if (!any) s.build.fail_unknown((std::string("an object of ") + what).c_str());
    // Transformations after the objects move each of them.
    while (const auto t = read_transformation(s.build))
        for (scene::Object& object : group) object.transform_by(*t);
    return group;
}
void append(std::vector<scene::Object>& to, std::vector<scene::Object> more)
{
    for (scene::Object& object : more) to.push_back(std::move(object));
}
Production group_block(std::string_view name, Kind other)
{
    const Form group =
        Form::sequence({Form::repeated(Form::named(any_object), 1), Form::repeated(Form::named(transformation))});
    return {name, Form::braces({Form::choice({Form::token(other), group})})};
}
Production clipped_by_block() { return group_block("clipped_by_block", Kind::BoundedBy); }
Production bounded_by_block() { return group_block("bounded_by_block", Kind::ClippedBy); }
struct clipped_by : item<Kind::ClippedBy, reads<clipped_by_block>> {
    static void act(ObjectState& s)
    {
        const auto opened = s.build.open_block("clipped_by");
        scene::ObjectDetails& details = s.object.details.edit();
        if (s.stream().accept(Kind::BoundedBy)) {
            if (!details.clipped_by.empty())
                s.stream().fail(s.stream().last(), "clips cannot be linked to the bounds: there are clips already");
            details.clipped_by = std::move(details.bounded_by);
            details.bounded_by.clear();
            details.bounded_by_clip = !details.clipped_by.empty();  // none is no link (spec 5a, 9.3)
        } else {
            if (details.bounded_by_clip)
                s.stream().fail(s.stream().last(), "no clips can be added after they were linked with the bounds");
            append(details.clipped_by, read_group(s, "clipped_by"));
        }
        s.build.close_block("clipped_by", opened);
    }
};
struct bounded_by : item<Kind::BoundedBy, reads<bounded_by_block>> {
    static void act(ObjectState& s)
    {
        const auto opened = s.build.open_block("bounded_by");
        scene::ObjectDetails& details = s.object.details.edit();
        if (s.stream().accept(Kind::ClippedBy)) {
            if (details.bounded_by_clip)
                s.stream().fail(s.stream().last(), "the bounds are linked with the clips already");
            if (!details.bounded_by.empty())
                s.stream().fail(s.stream().last(), "bounds cannot be linked to the clips: there are bounds already");
            details.bounded_by_clip = !details.clipped_by.empty();
        } else {
            if (details.bounded_by_clip)
                s.stream().fail(s.stream().last(), "no bounds can be added after they were linked with the clips");
            append(details.bounded_by, read_group(s, "bounded_by"));
        }
        s.build.close_block("bounded_by", opened);
    }
};

// ---- flags ----------------------------------------------------------------------------------------------------
struct no_shadow : item<Kind::NoShadow> {
    static void act(ObjectState& s) { s.object.flags.no_shadow = true; }
};
template <Kind kind, auto set>
struct flag : item<kind, by_action<a_flag>> {
    static void act(ObjectState& s) { set(s.object.flags, optional_flag(s.stream())); }
};
using no_image = flag<Kind::NoImage, [](scene::Flags& f, bool on) { f.no_image = on; }>;
using no_reflection = flag<Kind::NoReflection, [](scene::Flags& f, bool on) { f.no_reflection = on; }>;
using no_radiosity = flag<Kind::NoRadiosity, [](scene::Flags& f, bool on) { f.no_radiosity = on; }>;
using double_illuminate = flag<Kind::DoubleIlluminate, [](scene::Flags& f, bool on) { f.double_illuminate = on; }>;
using hollow = flag<Kind::Hollow, [](scene::Flags& f, bool on) { f.hollow = on; }>;
struct inverse : item<Kind::Inverse> {
    static void act(ObjectState& s)
    {
        if (is_patch(s.object)) s.stream().warn(s.stream().last(), "what has no inside cannot be inverted");
        s.object.inverse = !s.object.inverse;
        // Turned twice it has lost its inner surfaces (spec 5a, 8.1).
        auto* csg = std::get_if<scene::Csg>(&s.object.shape);
        if (csg != nullptr && csg->op == scene::CsgOp::Union && !s.object.inverse) csg->op = scene::CsgOp::Merge;
    }
};
/// Choices of a root solver or a bounding method: ours need none, and only some objects may have them.
void read_choice(ObjectState& s, const char* name, bool allowed)
{
    if (!allowed) s.stream().fail(s.stream().last(), std::string("'") + name + "' means nothing for this object");
    optional_flag(s.stream());
}
struct sturm : item<Kind::Sturm, by_action<a_flag>> {
    static constexpr bool rare = true;  // means something for few solids
    static void act(ObjectState& s)
    {
        read_choice(s, "sturm", std::holds_alternative<scene::Torus>(s.object.shape) || takes_sturm(s.object));
    }
};
struct hierarchy : item<Kind::Hierarchy, by_action<a_flag>> {
    static constexpr bool rare = true;  // means something for few solids
    static void act(ObjectState& s)
    {
        read_choice(s, "hierarchy", std::holds_alternative<scene::Mesh>(s.object.shape) || takes_hierarchy(s.object));
    }
};
struct uv_mapping : item<Kind::UvMapping, by_action<a_flag>> {
    static void act(ObjectState& s)
    {
        s.object.flags.uv_mapping = optional_flag(s.stream());
        if (s.object.texture) s.stream().fail(s.stream().last(), "'uv_mapping' must stand before the texture");
    }
};
struct split_union : item<Kind::SplitUnion, a_number> {
    static constexpr bool rare = true;  // of unions alone
    static void act(ObjectState& s)
    {
        const bool split = s.pop_float() > 0;
        if (auto* csg = std::get_if<scene::Csg>(&s.object.shape)) csg->split_union = split;
        else s.stream().fail(s.stream().last(), "'split_union' needs a union or merge");
    }
};
struct cutaway_textures : item<Kind::CutawayTextures> {
    static void act(ObjectState& s)
    {
        auto* csg = std::get_if<scene::Csg>(&s.object.shape);
        if (csg && (csg->op == scene::CsgOp::Intersection || csg->op == scene::CsgOp::Difference))
            csg->cutaway_textures = true;
        else s.stream().fail(s.stream().last(), "'cutaway_textures' needs an intersection or difference");
    }
};
struct photons : item<Kind::Photons, reads<object_photons_block>> {
    static void act(ObjectState& s)
    {
        std::shared_ptr<const scene::PhotonFlags>& own = s.object.details.edit().photons;
        own = read_photon_flags(s.build, scene::is_light(s.object), own.get());
    }
};
struct radiosity : item<Kind::Radiosity, reads<object_radiosity_block>> {
    static void act(ObjectState& s) { s.object.details.edit().radiosity_importance = read_object_radiosity(s.build); }
};
struct dtag : item<Kind::Dtag, a_text> {
    static constexpr bool rare = true;
    static void act(ObjectState& s) { s.pop_string(); }
};

struct ModifierItems {
    using Items = table<ObjectState, texture, interior_texture, pigment, normal, finish, interior, material, clipped_by,
                        bounded_by, no_shadow, no_image, no_reflection, no_radiosity, double_illuminate, hollow,
                        inverse, sturm, hierarchy, uv_mapping, split_union, cutaway_textures, photons, radiosity, dtag>;
    static bool match(SceneBuilder& build, ObjectState& s)
    {
        if (const auto t = read_transformation(build)) {
            s.object.transform_by(*t);
            return true;
        }
        if (Items::match(build, s)) return true;
        if (lexical_class(build.stream().peek().kind) != LexicalClass::Color) return false;
        build.stream().warn(build.stream().here(), "a colour belongs in a pigment; this one is ignored");
        parser::color_expr(build.stream());
        return true;
    }
};

}  // namespace

bool read_modifier(SceneBuilder& build, scene::Object& object)
{
    ObjectState s(build, object);
    return ModifierItems::match(build, s);
}

Production object_modifier()
{
    return {"object_modifier", Form::choice({Form::named(transformation), ModifierItems::Items::form()})};
}

using ComponentItems = table<ObjectState, texture, pigment, normal, finish>;
Production component_modifier()
{
    return {"component_modifier", Form::choice({Form::named(transformation), ComponentItems::form()})};
}

void read_component_modifiers(SceneBuilder& build, scene::Object& object)
{
    ObjectState s(build, object);
    for (;;) {
        if (const auto t = read_transformation(build)) object.transform_by(*t);
        else if (!ComponentItems::match(build, s)) return;
    }
}

void read_modifiers(SceneBuilder& build, scene::Object& object)
{
    object.flags.unclipped_box = false;
    if (build.stream().peek().kind == Kind::RightBrace) return;
    ObjectState s(build, object);
    while (ModifierItems::match(build, s)) {}
    if (object.details->interior_texture && !object.texture)
        build.stream().fail(object.source, "an interior_texture needs a texture on the same object");
}

}  // namespace parser
