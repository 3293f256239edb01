#include "parser/grammar/scene/effects.h"
#include "parser/grammar/core/rules.h"
#include "render/scene/base/passing_error.h"
#include "render/scene/unsupported_features.h"

/// The top level of a scene, the values that a declaration can hold, and `#default`.
namespace parser {
namespace {

struct SceneState : BlockState {
    using BlockState::BlockState;
};

struct camera : item<Kind::Camera, reads<camera_block>> {
    static void act(SceneState& s)
    {
        SceneBuilder& build = s.build;
        if (build.camera_given && build.version() >= 350) s.warn("more than one camera: the last one counts");
        // Before version 3.5 every statement changes the same camera (spec 2, 3.7).
        const bool goes_on = build.version() < 350 && build.camera_given;
        build.description.camera = read_camera(build, goes_on ? build.description.camera : build.default_camera);
        build.camera_given = true;
    }
};
struct background : item<Kind::Background, reads<background_block>> {
    static void act(SceneState& s) { read_background(s.build); }
};
struct fog : item<Kind::Fog, reads<fog_block>> {
    static void act(SceneState& s) { s.build.description.fogs.push_back(read_fog(s.build)); }
};
struct sky_sphere : item<Kind::SkySphere, reads<sky_sphere_block>> {
    static void act(SceneState& s)
    {
        if (s.build.description.sky_sphere) s.warn("more than one sky_sphere: the last one counts");
        s.build.description.sky_sphere = read_sky_sphere(s.build);
    }
};
struct global_settings : item<Kind::GlobalSettings, reads<global_settings_block>> {
    static void act(SceneState& s)
    {
        if (!s.build.global_settings) s.build.global_settings = s.stream().last();
        read_global_settings(s.build);
    }
};
struct default_settings : item<Kind::Default, reads<default_block>> {
    static void act(SceneState& s) { s.build.parse_default(s.stream()); }
};
struct scene_media : item<Kind::Media, reads<media_block>> {
    static void act(SceneState& s) { s.build.description.media.push_back(read_media(s.build)); }
};
struct rainbow : item<Kind::Rainbow, reads<rainbow_block>> {
    static void act(SceneState& s) { s.build.description.rainbows.push_back(read_rainbow(s.build)); }
};
/// `declare`, `include` and `version` without their '#' are old, and still understood.
template <Kind kind>
struct bare : item<kind, reads<rest_of_directive>> {
    static constexpr bool rare = true;
    static void act(SceneState& s) { s.stream().bare_directive(s.stream().taken_last()); }
};
struct dtag : item<Kind::Dtag, a_text> {
    static constexpr bool rare = true;
    static void act(SceneState& s) { s.pop_string(); }
};

using SceneItems = table<SceneState, camera, background, fog, sky_sphere, global_settings, default_settings, rainbow,
                         scene_media, bare<Kind::Declare>, bare<Kind::Include>, bare<Kind::Version>, dtag>;

// ---- #default -------------------------------------------------------------------------------------------------
scene::Layer changed(SceneState& s) { return s.build.default_layer(); }
struct default_texture : item<Kind::Texture, reads<texture_block>> {
    static void act(SceneState& s)
    {
        const scene::SourceRef at = s.stream().last();
        const scene::TexturePtr texture = read_texture(s.build);
        const auto* layers = std::get_if<std::vector<scene::Layer>>(&texture->kind);
        if (!layers || layers->size() != 1)
            s.stream().fail(at, "the default texture must be plain, not patterned or layered");
        s.build.set_default_layer(layers->front());
    }
};
struct default_pigment : item<Kind::Pigment, reads<pigment_block>> {
    static void act(SceneState& s)
    {
        scene::Layer layer = changed(s);
        layer.pigment = read_pigment(s.build, layer.pigment);
        s.build.set_default_layer(std::move(layer));
    }
};
struct default_normal : item<Kind::Normal, reads<normal_block>> {
    static void act(SceneState& s)
    {
        scene::Layer layer = changed(s);
        layer.normal = std::make_shared<const scene::Normal>(read_normal(s.build, layer.normal));
        s.build.set_default_layer(std::move(layer));
    }
};
struct default_finish : item<Kind::Finish, reads<finish_block>> {
    static void act(SceneState& s)
    {
        scene::Layer layer = changed(s);
        layer.finish = read_finish(s.build, *layer.finish);
        s.build.set_default_layer(std::move(layer));
    }
};
struct default_camera : item<Kind::Camera, reads<camera_block>> {
    static void act(SceneState& s) { s.build.default_camera = read_camera(s.build, s.build.default_camera); }
};
struct default_radiosity : item<Kind::Radiosity, reads<object_radiosity_block>> {
    static void act(SceneState& s)
    {
        s.build.description.default_importance = read_object_radiosity(s.build).value_or(1.0);
    }
};
using DefaultItems = table<SceneState, default_texture, default_pigment, default_normal, default_finish, default_camera,
                           default_radiosity>;
using DefaultBlock = block<Kind::Default, DefaultItems>;

// ---- declared values ------------------------------------------------------------------------------------------
template <class T>
Value shared(T value)
{
    return std::make_shared<const T>(std::move(value));
}
using ValueReader = Value (*)(SceneBuilder&);
struct ValueEntry {
    Kind keyword;
    Production (*block)();
    ValueReader read;
};
const ValueEntry kValues[] = {
    {Kind::Texture, texture_block, [](SceneBuilder& b) -> Value { return read_textures(b); }},
    {Kind::Pigment, pigment_block,
     [](SceneBuilder& b) -> Value {
         return scene::PigmentPtr(std::make_shared<scene::Pigment>(read_pigment(b, b.default_layer().pigment)));
     }},
    {Kind::Normal, normal_block,
     [](SceneBuilder& b) -> Value {
         return scene::NormalPtr(std::make_shared<scene::Normal>(read_normal(b, b.default_layer().normal)));
     }},
    {Kind::Finish, finish_block,
     [](SceneBuilder& b) -> Value { return shared(read_finish(b, *b.default_layer().finish)); }},
    {Kind::Interior, interior_block,
     [](SceneBuilder& b) -> Value { return shared(read_interior(b, scene::Interior{})); }},
    {Kind::Material, material_block, [](SceneBuilder& b) -> Value { return shared(read_material(b, Material{})); }},
    {Kind::ColorMap, color_map_block, [](SceneBuilder& b) -> Value { return shared(read_color_map(b)); }},
    {Kind::PigmentMap, pigment_map_block, [](SceneBuilder& b) -> Value { return shared(read_pigment_map(b, false)); }},
    {Kind::NormalMap, normal_map_block, [](SceneBuilder& b) -> Value { return shared(read_normal_map(b, false)); }},
    {Kind::SlopeMap, slope_map_block, [](SceneBuilder& b) -> Value { return shared(read_slope_map(b)); }},
    {Kind::TextureMap, texture_map_block, [](SceneBuilder& b) -> Value { return shared(read_texture_map(b, false)); }},
    {Kind::Transform, transform_block, [](SceneBuilder& b) -> Value { return shared(read_transform(b)); }},
    {Kind::Camera, camera_block, [](SceneBuilder& b) -> Value { return shared(read_camera(b, b.default_camera)); }},
    {Kind::Fog, fog_block, [](SceneBuilder& b) -> Value { return shared(read_fog(b)); }},
    {Kind::SkySphere, sky_sphere_block, [](SceneBuilder& b) -> Value { return shared(read_sky_sphere(b)); }},
    {Kind::Media, media_block, [](SceneBuilder& b) -> Value { return shared(read_media(b)); }},
    {Kind::Density, density_block, [](SceneBuilder& b) -> Value { return shared(read_density(b)); }},
    {Kind::DensityMap, density_map_block, [](SceneBuilder& b) -> Value { return shared(read_density_map(b, false)); }},
    {Kind::Rainbow, rainbow_block, [](SceneBuilder& b) -> Value { return shared(read_rainbow(b)); }},
};

}  // namespace

Production default_block() { return {"default_block", DefaultBlock::form()}; }

Production declared_value()
{
    std::vector<Form> all;
    for (const ValueEntry& one : kValues)
        all.push_back(Form::sequence({Form::token(one.keyword), Form::named(one.block)}));
    all.push_back(Form::named(any_object));
    return {"declared_value", Form::choice(std::move(all))};
}

Production scene_text()
{
    return {"scene", Form::repeated(Form::choice({Form::named(directive), SceneItems::form(), Form::named(old_setting),
                                                  Form::named(any_object)}))};
}

bool SceneBuilder::read_statement()
{
    SceneState s(*this);
    stream_->begin_statement();
    if (peek_for(*stream_, receiver, top_level_).kind == Kind::EndOfText) return false;
    stream_->begin_statement();
    if (SceneItems::match(*this, s) || read_old_setting(*this)) return true;
    scene::Object object;
    if (read_object(*this, object)) add(std::move(object));
    else fail_unknown("an object, a camera, a light_source or another statement");
    return true;
}

void SceneBuilder::read_scene()
{
    constexpr std::size_t kMostErrors = 20;
    std::vector<scene::Message> errors;
    for (;;) {
        try {
            if (!read_statement()) break;
        } catch (const scene::PassingError&) {
            if (errors.empty()) throw;  // what follows may be wrong because of it, and it may be right another time
            throw Error(std::move(errors));
        } catch (const Error& error) {
            errors.insert(errors.end(), error.messages().begin(), error.messages().end());
            if (errors.size() >= kMostErrors || !stream_->skip_statement()) throw Error(std::move(errors));
        }
    }
    if (!errors.empty()) throw Error(std::move(errors));
    tell_unsupported();
    if (description.objects.empty() && description.unsupported_objects.empty())
        stream_->warn(stream_->end_of_scene(), "the scene has no objects");
    tell_missing_settings();
}

void SceneBuilder::tell_missing_settings()
{
    constexpr int kGamma = 370;
    const LanguageState& language = stream_->language();
    if (!language.assumed_gamma)
        stream_->warn(global_settings.value_or(stream_->start()),
                      language.effective_version() >= kGamma
                          ? "assumed_gamma is not given: it is 1.0 (global_settings { assumed_gamma 1.0 } says so)"
                          : "assumed_gamma is not given: colours are not corrected for it, as before version 3.7");
    if (stream_->options().version_given) return;
    if (!language.version_directive)
        stream_->warn(
            stream_->start(),
            "the scene has no #version: some settings are those of versions before 3.7 (begin with #version 3.7;)");
    else if (language.late_version)
        stream_->warn(
            *language.late_version,
            "the first #version is not the first statement: until here some settings are those of versions before 3.7");
}

void SceneBuilder::tell_unsupported()
{
    for (scene::Unsupported& feature : scene::unsupported_features(description))
        description.unsupported.push_back(std::move(feature));
    for (const scene::Unsupported& feature : description.unsupported)
        stream_->warn(feature.source, feature.what + ": not rendered yet, the picture is made without it");
}

void SceneBuilder::parse_default(TokenStream&)
{
    SceneState s(*this);
    default_given = true;
    DefaultBlock::read(*this, s);
}

std::optional<Value> SceneBuilder::parse_declared_value(TokenStream& stream)
{
    const Kind keyword = stream.peek().kind;
    for (const ValueEntry& entry : kValues) {
        if (entry.keyword != keyword) continue;
        stream.next();
        return entry.read(*this);
    }
    if (auto object = read_object(*this)) {
        if (object->flags.textured_late && !object->details->textured_at)
            object->details.edit().textured_at = std::make_shared<const csg::Transform>(textured_at_);
        return Value(std::make_shared<const scene::Object>(std::move(*object)));
    }
    return std::nullopt;
}

}  // namespace parser
