#include "parser/grammar/core/scene_builder.h"

#include <fmt/format.h>

namespace parser {
namespace {

constexpr double kOldRight = 1.33;  // not 4/3 (spec 2, 3.1)

}  // namespace

SceneBuilder::SceneBuilder()
{
    auto texture = std::make_shared<scene::Texture>();
    texture->kind = std::vector<scene::Layer>{scene::Layer{}};
    default_texture_ = texture;
    default_camera.right = {kOldRight, 0, 0};
    default_camera.variance = 1.0 / 10000.0;
    default_camera.focal_distance = 1.0;
    description.camera = default_camera;
}

void SceneBuilder::attach(TokenStream& stream)
{
    stream_ = &stream;
    if (stream.options().version_given) take_defaults(stream.options().version, stream.options());
}

const scene::Layer& SceneBuilder::default_layer() const
{
    return std::get<std::vector<scene::Layer>>(default_texture_->kind).back();
}

void SceneBuilder::set_default_layer(scene::Layer layer)
{
    auto texture = std::make_shared<scene::Texture>();
    texture->kind = std::vector<scene::Layer>{std::move(layer)};
    default_texture_ = std::move(texture);
}

int SceneBuilder::default_noise_generator() const { return stream_->language().version < 350 ? 1 : 2; }

void SceneBuilder::version_changed(int version, const Options& options)
{
    // A version from the command line alone is too late for what is asked while the text is read (spec 4, 2.6).
    if (!noise_generator_given) description.global.noise_generator = default_noise_generator();
    take_defaults(version, options);
}

/// Defaults go with the version of the moment, until the first #default (spec 7, 1.2).
void SceneBuilder::take_defaults(int version, const Options& options)
{
    constexpr int kNewDefaults = 380;
    const bool wanted = version >= kNewDefaults;
    if (wanted == new_defaults_) return;
    if (default_given) {
        if (stream_->last().file == 0)
            stream_->warn(stream_->last(),
                          "the defaults of this version are not taken, for a #default stands before it");
        return;
    }
    new_defaults_ = wanted;
    std::swap(default_texture_, other_default_);
    if (!default_texture_) {
        scene::Layer layer;
        layer.pigment.kind = scene::Color{1, 1, 1, 0, 0};
        layer.finish.edit().ambient = glm::vec3(0);
        set_default_layer(std::move(layer));
    }
    default_camera.right.x = wanted ? static_cast<double>(options.image_width) / options.image_height : kOldRight;
    if (!camera_given) description.camera = default_camera;
}

void SceneBuilder::add(scene::Object object)
{
    if (!object.drawn()) {
        set_aside(std::move(object));
        return;
    }
    complete(object);
    description.objects.push_back(std::move(object));
}

void SceneBuilder::keep_default(scene::Object& object)
{
    auto& all = description.default_textures;
    if (all.empty() || all.back() != default_texture_) all.push_back(default_texture_);
    object.default_texture = static_cast<std::uint32_t>(all.size() - 1);
}

void SceneBuilder::complete(scene::Object& object)
{
    keep_default(object);
    if (description.default_importance != 1.0 && !object.details->radiosity_importance)
        object.details.edit().radiosity_importance = description.default_importance;
}

void SceneBuilder::set_aside(scene::Object object)
{
    if (object.default_texture == scene::Object::kNoDefault) keep_default(object);
    description.unsupported_objects.push_back(std::move(object));
}

void SceneBuilder::unsupported(const std::string& what, const scene::SourceRef& source)
{
    if (told_.insert(what).second) description.unsupported.push_back({what, source});
}

scene::Description SceneBuilder::take()
{
    const LanguageState& language = stream_->language();
    description.version = language.version < 350 ? 350 : language.version;
    description.povray = language.povray;
    description.effective_version = language.version_set ? description.version : 362;
    if (!noise_generator_given) description.global.noise_generator = default_noise_generator();
    description.global.assumed_gamma = language.assumed_gamma;
    description.default_texture = default_texture_;
    description.files = stream_->files();
    description.lines = stream_->lines();
    return std::move(description);
}

void SceneBuilder::fail_open(std::string_view what) { stream_->fail_expected(fmt::format("'{{' after {}", what)); }

void SceneBuilder::fail_close(std::string_view what, const scene::SourceRef& opened, const std::vector<Kind>& items)
{
    const Token token = stream_->peek();
    if (token.kind == Kind::EndOfText)
        stream_->fail(opened, fmt::format("this block of '{}' is not closed: the text ends before its '}}'", what));
    if (token.kind == Kind::Identifier && !stream_->value_of(token)) stream_->fail_undeclared(token, what, items);
    fail_unknown(fmt::format("an item of '{}' or '}}'", what).c_str(),
                 stream_->where_opened(fmt::format("'{}'", what), opened));
}

void SceneBuilder::fail_unknown(const char* expected, const std::string& more)
{
    const Token token = stream_->peek();
    if (token.kind == Kind::Identifier && !stream_->value_of(token)) stream_->fail_undeclared(token);
    stream_->fail_expected(expected, more);
}

}  // namespace parser
