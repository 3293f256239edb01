#include "parser/grammar/textures/images.h"
#include "parser/grammar/textures/old_words.h"
#include "parser/grammar/core/rules.h"

namespace parser {
namespace {

using Layers = std::vector<scene::Layer>;
using Patterned = scene::Shared<scene::PatternedTexture>;

struct TextureState : BlockState {
    using BlockState::BlockState;
    scene::Texture texture;
    bool no_bump_scale = false;

    bool patterned() const { return std::holds_alternative<Patterned>(texture.kind); }
    scene::PatternedTexture& pattern() { return std::get<Patterned>(texture.kind).edit(); }
    scene::Layer& top(const char* what)
    {
        if (patterned())
            stream().fail(stream().last(), std::string("'") + what + "' cannot change a patterned texture");
        return std::get<Layers>(texture.kind).back();
    }
};

struct pigment : item<Kind::Pigment, reads<pigment_block>> {
    static void act(TextureState& s)
    {
        scene::Layer& top = s.top("pigment");
        top.pigment = read_pigment(s.build, top.pigment);
    }
};
struct normal : item<Kind::Normal, reads<normal_block>> {
    static void act(TextureState& s)
    {
        scene::Layer& top = s.top("normal");
        top.normal = std::make_shared<const scene::Normal>(read_normal(s.build, top.normal));
    }
};
struct finish : item<Kind::Finish, reads<finish_block>> {
    static void act(TextureState& s)
    {
        scene::Layer& top = s.top("finish");
        top.finish = read_finish(s.build, *top.finish);
    }
};
struct no_bump_scale : item<Kind::NoBumpScale, a_flag> {
    static void act(TextureState& s) { s.no_bump_scale = s.pop_flag(); }
};
struct texture_map : item<Kind::TextureMap, reads<texture_map_block>> {
    static void act(TextureState& s)
    {
        if (!s.patterned()) s.fail("a texture_map needs a pattern before it, as in 'gradient y'");
        if (list_size(s.pattern().pattern) > 0)
            s.fail("'" + s.pattern().pattern.name + "' takes a list of textures, not a map");
        s.pattern().map = read_texture_map(s.build, s.pattern().pattern.name == "average");
    }
};
using TextureItems = table<TextureState, pigment, normal, finish, no_bump_scale, texture_map>;

void become(TextureState& s, scene::Pattern pattern) { s.texture.kind = Patterned({std::move(pattern), {}}); }

/// tiles { texture { A } tile2 texture { B } }: a checker whose odd cells show A (spec 4, 14).
void read_tiles(TextureState& s)
{
    TokenStream& in = s.stream();
    scene::Pattern checker;
    checker.name = "checker";
    checker.frequency = 0;
    checker.source = in.last();
    become(s, checker);
    const auto opened = s.build.open_block("tiles");
    in.expect(Kind::Texture, "'texture' and the first tile");
    const scene::TexturePtr odd = read_textures(s.build);
    in.expect(Kind::Tile2, "'tile2' and the second tile");
    in.expect(Kind::Texture, "'texture' and the second tile");
    s.pattern().map = {{0, read_textures(s.build)}, {1, odd}};
    s.build.close_block("tiles", opened);
}

void read_list(TextureState& s, int count)
{
    TextureMap map;
    while (static_cast<int>(map.size()) < count && s.stream().accept(Kind::Texture)) {
        map.push_back({static_cast<double>(map.size()), read_texture(s.build)});
        s.stream().accept_comma();
    }
    while (static_cast<int>(map.size()) < count)
        map.push_back({static_cast<double>(map.size()), s.build.default_texture()});
    s.pattern().map = std::move(map);
}

void read_head(TextureState& s)
{
    TokenStream& in = s.stream();
    if (in.accept(Kind::Tiles)) return read_tiles(s);
    if (in.accept(Kind::MaterialMap)) {
        scene::Pattern pattern;
        pattern.name = "material_map";
        pattern.source = in.last();
        TextureMap map;
        pattern.data = read_material_map(s.build, map);
        become(s, std::move(pattern));
        s.pattern().map = std::move(map);
        return;
    }
    if (in.accept(Kind::UvMapping)) {
        scene::Pattern pattern;
        pattern.name = "uv_mapping";
        pattern.source = in.last();
        const scene::TexturePtr inner = read_texture_body(s.build);
        become(s, pattern);
        s.pattern().map = {{0, inner}};
        return;
    }
    // A number of keywords begin both a pattern and something else; in a texture's body only patterns can stand here.
    scene::Pattern pattern;
    if (s.patterned()) pattern = s.pattern().pattern;
    if (!read_pattern_type(s.build, pattern)) return;
    const int count = list_size(pattern);
    const scene::Pattern list = pattern;
    TextureMap kept = s.patterned() && count == 0 ? s.pattern().map : TextureMap{};
    become(s, std::move(pattern));
    s.pattern().map = std::move(kept);
    if (count > 0) read_list(s, count);
    close_list(s.build, list);
}

/// no_bump_scale of a whole texture reaches all normals in it and the patterns on the way to them.
void keep_bump_size(scene::Texture& texture)
{
    if (auto* layers = std::get_if<Layers>(&texture.kind)) {
        for (scene::Layer& layer : *layers)
            if (layer.normal) {
                const auto copy = std::make_shared<scene::Normal>(*layer.normal);
                copy->no_bump_scale = true;
                layer.normal = copy;
            }
        return;
    }
    scene::PatternedTexture& patterned = std::get<Patterned>(texture.kind).edit();
    patterned.no_bump_scale = true;
    for (auto& entry : patterned.map) {
        const auto copy = std::make_shared<scene::Texture>(*entry.value);
        keep_bump_size(*copy);
        entry.value = copy;
    }
}

/// A declared pigment, normal or finish stands for a texture that has it.
void accept_part(TextureState& s)
{
    TokenStream& in = s.stream();
    scene::Layer& top = std::get<Layers>(s.texture.kind).back();
    if (const auto pigment = in.accept_identifier<scene::PigmentPtr>()) top.pigment = **pigment;
    else if (const auto normal = in.accept_identifier<scene::NormalPtr>()) top.normal = *normal;
    else if (const auto finish = in.accept_identifier<std::shared_ptr<const scene::Finish>>()) top.finish = **finish;
}

std::optional<csg::Transform> read_texture_transformation(TextureState& s)
{
    const auto t = read_transformation(s.build);
    if (t) s.texture.transform_in_text(*t);
    return t;
}

bool read_texture_modifier(TextureState& s)
{
    if (s.patterned()) return read_pattern_modifier(s.build, s.pattern().pattern);
    return read_texture_transformation(s).has_value();
}

/// All of a texture of version 1 or 2 (spec 4, 14.1).
void read_old_items(TextureState& s)
{
    OldPigment pigment(s.build);
    for (;;) {
        scene::Layer& top = std::get<Layers>(s.texture.kind).back();
        if (pigment.read(top.pigment) || read_old_normal(s.build, top.normal)) continue;
        scene::Finish finish = *top.finish;
        if (read_old_finish(s.build, finish)) {
            top.finish = finish;
            continue;
        }
        pigment.put(top.pigment);
        if (!TextureItems::match(s.build, s) && !read_texture_transformation(s)) return;
    }
}

}  // namespace

Production texture_block() { return {"texture_block", Form::braces({Form::named(texture_body)})}; }

Production texture_body()
{
    const Form texture = Form::sequence({Form::token(Kind::Texture), Form::named(texture_block)});
    const Form tiles =
        Form::sequence({Form::token(Kind::Tiles), Form::braces({texture, Form::token(Kind::Tile2), texture})});
    const Form head = Form::choice({Form::named(pattern_type), tiles, Form::token(Kind::UvMapping),
                                    Form::sequence({Form::token(Kind::MaterialMap), Form::named(material_map_block)})});
    const Form items = Form::choice({TextureItems::form(), Form::named(pattern_modifier)});
    return {"texture_body",
            Form::choice({Form::repeated(texture, 1),
                          Form::sequence({Form::optional(Form::operand("identifier")), Form::optional(head),
                                          Form::repeated(texture), Form::repeated(items)})})};
}

scene::TexturePtr read_texture_body(SceneBuilder& build)
{
    TokenStream& in = build.stream();
    const auto guard = in.nest();
    if (in.accept(Kind::Texture)) return read_textures(build);
    TextureState s(build);
    s.texture = *build.default_texture();
    if (const auto declared = in.accept_identifier<scene::TexturePtr>()) s.texture = **declared;
    else accept_part(s);
    s.texture.source = in.here();
    const bool old = build.version() < kFirstWithoutOldTextures;
    if (!old || is_one_of(in.peek().kind, {Kind::Tiles, Kind::MaterialMap})) read_head(s);
    if (old && !s.patterned()) read_old_items(s);
    else
        while (TextureItems::match(build, s) || read_texture_modifier(s)) {}
    if (s.patterned()) check_pavement(build, s.pattern().pattern);
    if (s.patterned() && s.pattern().map.empty())
        in.fail(s.texture.source, "this patterned texture has no texture_map");
    if (s.no_bump_scale) keep_bump_size(s.texture);
    return std::make_shared<scene::Texture>(std::move(s.texture));
}

scene::TexturePtr read_texture(SceneBuilder& build)
{
    const scene::SourceRef opened = build.open_block("texture");
    scene::TexturePtr texture = read_texture_body(build);
    build.close_block("texture", opened);
    return texture;
}

scene::TexturePtr read_textures(SceneBuilder& build)
{
    scene::TexturePtr all = read_texture(build);
    // Looked for without running directives: in a declaration the next `#declare` may already use this value.
    while (build.stream().peek_raw().kind == Kind::Texture) {
        build.stream().next();
        const scene::SourceRef at = build.stream().last();
        all = layered(build, std::move(all), read_texture(build), at);
    }
    return all;
}

namespace {

/// Up to version 3.1 only the bottom layer filters: the filter of the others lets all light through (spec 3, 18).
void filter_to_transmit(scene::Color& color)
{
    color.transmit += color.filter;
    color.filter = 0;
}
void filter_to_transmit(scene::Pigment& pigment)
{
    if (auto* plain = std::get_if<scene::Color>(&pigment.kind)) return filter_to_transmit(*plain);
    auto& map = std::get<scene::Shared<scene::PatternedPigment>>(pigment.kind).edit().map;
    if (auto* colors = std::get_if<scene::ColorMap>(&map)) {
        for (auto& entry : *colors) filter_to_transmit(entry.value);
        return;
    }
    for (auto& entry : std::get<scene::PigmentMap>(map)) {
        const auto copy = std::make_shared<scene::Pigment>(*entry.value);
        filter_to_transmit(*copy);
        entry.value = copy;
    }
}

constexpr int kLastOldLayers = 310;

}  // namespace

scene::TexturePtr layered(SceneBuilder& build, scene::TexturePtr below, const scene::TexturePtr& top,
                          const scene::SourceRef& at)
{
    if (!below) return top;
    const auto* lower = std::get_if<Layers>(&below->kind);
    const auto* upper = std::get_if<Layers>(&top->kind);
    if (!lower) build.stream().fail(at, "a texture cannot be layered over a patterned texture");
    if (!upper) build.stream().fail(at, "a patterned texture cannot be layered over another texture");
    // What nobody else holds needs no copy: many layers would make one each, of all below.
    const bool own = below.use_count() == 1;
    auto both = own ? std::const_pointer_cast<scene::Texture>(std::move(below))
                    : std::make_shared<scene::Texture>(*below);
    auto& layers = std::get<Layers>(both->kind);
    const std::size_t first = layers.size();
    layers.insert(layers.end(), upper->begin(), upper->end());
    if (build.version() <= kLastOldLayers)
        for (std::size_t i = first; i < layers.size(); ++i) filter_to_transmit(layers[i].pigment);
    return both;
}

}  // namespace parser
