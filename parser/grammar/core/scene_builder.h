#pragma once

#include "parser/grammar/core/receiver.h"
#include "parser/stream/token_input.h"
#include "parser/stream/token_stream.h"
#include "render/font/font.h"
#include "render/image/pixels/picture.h"
#include "render/scene/inside.h"
#include "render/scene/description.h"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>

namespace parser {

/// Gathers the description while the text is read, and answers the stream's questions about scene constructs.
class SceneBuilder final : public GrammarHooks {
public:
    SceneBuilder();

    void attach(TokenStream& stream);
    TokenStream& stream() { return *stream_; }
    int version() { return stream_->language().version; }

    /// Reads the whole scene. Afterwards take() gives the description.
    void read_scene();
    scene::Description take();

    std::optional<Value> parse_declared_value(TokenStream& stream) override;
    void parse_default(TokenStream& stream) override;
    std::unique_ptr<ReadyStatement> prepare(StatementReader& tokens) override;
    void version_changed(int version, const Options& options) override;
    std::optional<function::SceneReference> parse_function_thing(TokenStream& stream) override;
    std::optional<ObjectHit> trace(const std::shared_ptr<const scene::Object>& object, const glm::dvec3& origin,
                                   const glm::dvec3& direction) override;
    bool solid(const std::shared_ptr<const scene::Object>& object) override;
    std::optional<bool> inside(const std::shared_ptr<const scene::Object>& object, const glm::dvec3& point) override;
    std::optional<csg::Aabb> extent(const std::shared_ptr<const scene::Object>& object) override;
    std::optional<glm::dvec3> turbulence(const glm::dvec3& point, int octaves, double lambda, double omega) override;
    std::optional<function::Values> evaluate(const function::FunctionPtr& called, const double* arguments) override;
    /// At many points; false: nobody answers.
    bool evaluate(const function::FunctionPtr& called, std::span<const glm::dvec3> points,
                  std::span<function::Values> values);

    /// The texture that `#default` has made so far: one layer.
    const scene::TexturePtr& default_texture() const { return default_texture_; }
    /// The transformation of the object that a texture was given last after it had moved.
    csg::Transform& textured_at() { return textured_at_; }
    const scene::Layer& default_layer() const;
    void set_default_layer(scene::Layer layer);

    /// An object statement at top level is complete.
    void add(scene::Object object);
    /// An object of a kind that is not drawn yet: kept in the description.
    void set_aside(scene::Object object);

    /// The content of a picture file, read once.
    std::shared_ptr<const image::Picture> picture(const std::string& path, const scene::SourceRef& at);

    /// '{' of a block whose keyword has been taken; its place. close_block() tells what is wrong if '}' does not
    /// follow.
    scene::SourceRef open_block(std::string_view what)
    {
        const scene::SourceRef at = stream_->here();
        if (!stream_->accept(Kind::LeftBrace)) fail_open(what);
        stream_->block_opened(at);
        return at;
    }
    void close_block(std::string_view what, const scene::SourceRef& opened)
    {
        close_block(what, opened, [] { return std::vector<Kind>(); });
    }
    /// \param items gives the words of the block's items, for messages
    template <class Items>
    void close_block(std::string_view what, const scene::SourceRef& opened, const Items& items)
    {
        if (!stream_->accept(Kind::RightBrace)) fail_close(what, opened, items());
        stream_->block_closed();
    }
    /// The next token belongs to nothing known here.
    [[noreturn]] void fail_unknown(const char* expected, const std::string& more = "");

    scene::Description description;
    scene::Camera default_camera;
    bool camera_given = false, noise_generator_given = false;
    /// A question to an unsupported object was answered as if it were not there: what follows may be degenerate.
    bool guessed = false;
    bool default_given = false;
    std::optional<scene::SourceRef> global_settings;  ///< the first such block
    font::Fonts fonts;
    std::map<std::string, std::string> font_files;  ///< paths by what the text calls them
    OperandStack::Memory operand_memory;
    Receiver* receiver = nullptr;                      ///< of statements that need no tokens, where some may stand
    std::unordered_set<const Token*> changing_blocks;  ///< of textures, not worth keeping
    std::vector<scene::Object> gathered;  ///< operands of the CSG objects that are being read: see objects.cpp

private:
    /// Objects of the scene.
    class TopLevel final : public ObjectReceiver {
    public:
        explicit TopLevel(SceneBuilder& build) : build_(build) {}
        scene::Object& place() override { return build_.description.objects.emplace_back(); }
        bool keep() override
        {
            build_.complete(build_.description.objects.back());
            return true;
        }
        void drop() override { build_.description.objects.pop_back(); }

    private:
        SceneBuilder& build_;
    };
    /// What an object statement at top level gets.
    void complete(scene::Object& object);
    /// Notes the default texture of the moment.
    void keep_default(scene::Object& object);
    [[noreturn]] void fail_open(std::string_view what);
    [[noreturn]] void fail_close(std::string_view what, const scene::SourceRef& opened, const std::vector<Kind>& items);
    /// One statement of the scene; false at the end of the text.
    bool read_statement();
    bool is_unsupported(const std::shared_ptr<const scene::Object>& object, const char* question);
    /// A question that was answered without what cannot be drawn: kept once for each `what`.
    void unsupported(const std::string& what, const scene::SourceRef& source);
    /// A warning for each thing that the scene asks for and the picture will not have.
    void tell_unsupported();
    /// Warnings of POV-Ray for a scene that leaves #version or assumed_gamma to chance.
    void tell_missing_settings();
    /// Who answers questions to what is described so far; null: nobody. Pictures are decoded by the language's
    /// settings.
    SceneQueries* queries();
    int default_noise_generator() const;  ///< of the language version
    void take_defaults(int version, const Options& options);
    TokenStream* stream_ = nullptr;
    TopLevel top_level_{*this};
    scene::TexturePtr default_texture_;
    scene::TexturePtr
        other_default_;          ///< of version 3.8 or of those before it, whichever is not in force; null: unmade
    bool new_defaults_ = false;  ///< the one in force is that of version 3.8
    csg::Transform textured_at_;
    std::set<std::string> told_;
    std::shared_ptr<const scene::Object> solid_;  ///< the last that was found to have an inside
    std::map<std::string, std::shared_ptr<const image::Picture>> pictures_;
};

/// At the first token of an object statement (or at an object identifier): reads it. Nothing taken: no object.
/// `object` must be new.
bool read_object(SceneBuilder& build, scene::Object& object);
inline std::optional<scene::Object> read_object(SceneBuilder& build)
{
    std::optional<scene::Object> object(std::in_place);
    if (!read_object(build, *object)) object.reset();
    return object;
}
/// A block of the shape that `keyword` (already taken) names, modifiers included.
void read_solid(SceneBuilder& build, Kind keyword, scene::Object& object);
bool is_solid(Kind keyword);
scene::Object read_mesh(SceneBuilder& build, const scene::SourceRef& source);
scene::Object read_mesh2(SceneBuilder& build, const scene::SourceRef& source);
void read_csg(SceneBuilder& build, Kind keyword, scene::Object& object);
scene::Object read_light(SceneBuilder& build, const scene::SourceRef& source);
void read_written(SceneBuilder& build, Kind keyword, scene::Object& object);
bool is_written(Kind keyword);
using scene::has_inside;
using scene::some_forget_inverse;
using scene::is_patch;
/// Modifiers of any object until something else stands there.
void read_modifiers(SceneBuilder& build, scene::Object& object);
/// One of them, if it is next.
bool read_modifier(SceneBuilder& build, scene::Object& object);
/// texture, pigment, normal, finish and transformations of a blob's component.
void read_component_modifiers(SceneBuilder& build, scene::Object& object);

// Blocks: the keyword has been taken, braces included. `base` is what the block starts from.
csg::Transform read_transform(SceneBuilder& build);  ///< `transform N` or `transform { ... }`
/// One of translate, rotate, scale, matrix, transform if it is next.
std::optional<csg::Transform> read_transformation(SceneBuilder& build);
scene::Pigment read_pigment(SceneBuilder& build, const scene::Pigment& base);
scene::Pigment read_pigment_body(SceneBuilder& build, const scene::Pigment& base);  ///< without braces
/// The same for `density`: density_map for pigment_map, lists of densities.
scene::Pigment read_density_body(SceneBuilder& build, const scene::Pigment& base);
scene::Normal read_normal(SceneBuilder& build, const scene::NormalPtr& base);
scene::Normal read_normal_body(SceneBuilder& build, const scene::NormalPtr& base);
/// Items change what `before` holds; a declared finish takes its place.
scene::Finish read_finish(SceneBuilder& build, const scene::Finish& before);
scene::TexturePtr read_texture(SceneBuilder& build);
scene::TexturePtr read_texture_body(SceneBuilder& build);  ///< without braces
/// texture { } texture { } ...: layers; the first keyword has been taken.
scene::TexturePtr read_textures(SceneBuilder& build);
/// `top` over `below` (may be null; what only the caller had is changed); fails at `at` where one of them is patterned.
scene::TexturePtr layered(SceneBuilder& build, scene::TexturePtr below, const scene::TexturePtr& top,
                          const scene::SourceRef& at);
scene::Interior read_interior(SceneBuilder& build, const scene::Interior& base);
/// `current`: what the object has already.
Material read_material(SceneBuilder& build, Material current);
scene::ColorMap read_color_map(SceneBuilder& build);
scene::PigmentMap read_pigment_map(SceneBuilder& build, bool weights);
scene::PigmentMap read_density_map(SceneBuilder& build, bool weights);
NormalMap read_normal_map(SceneBuilder& build, bool weights);
SlopeMap read_slope_map(SceneBuilder& build);
TextureMap read_texture_map(SceneBuilder& build, bool weights);
scene::Camera read_camera(SceneBuilder& build, const scene::Camera& base);
scene::Fog read_fog(SceneBuilder& build);
scene::SkySphere read_sky_sphere(SceneBuilder& build);
void read_background(SceneBuilder& build);
void read_global_settings(SceneBuilder& build);
/// max_trace_level or max_intersections outside of global_settings, if it is next.
bool read_old_setting(SceneBuilder& build);

/// The pattern keyword at the front, with its parameters, if there is one: replaces the type in `pattern`.
/// Colours or blocks of list patterns are left to the caller. `of_normal`: facets, which only a normal can have, may
/// come.
bool read_pattern_type(SceneBuilder& build, scene::Pattern& pattern, bool of_normal = false);
/// To be called when the list that follows a pattern's type has been read: the list of `object` ends with a brace.
void close_list(SceneBuilder& build, const scene::Pattern& pattern);
/// One pattern modifier (warp, turbulence, frequency, wave form, transformation, ...) if it is next.
bool read_pattern_modifier(SceneBuilder& build, scene::Pattern& pattern);
/// Fails if the pattern is a pavement that does not exist; to be called behind its modifiers, which come in any order.
void check_pavement(SceneBuilder& build, const scene::Pattern& pattern);
/// Number of entries of a list pattern (checker 2, ...); 0 for all others.
int list_size(const scene::Pattern& pattern);
/// Colours of a list pattern where the text gives none, and colour maps of other patterns (spec 4, 10).
scene::ColorMap default_colors(const scene::Pattern& pattern);

}  // namespace parser
