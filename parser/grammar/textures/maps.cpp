#include "parser/grammar/core/rules.h"

/// color_map, pigment_map, normal_map, slope_map, texture_map: keys in the order written, never sorted (spec 4, 9.1).
namespace parser {
namespace {

constexpr std::size_t kMostEntries = 256;

/// How the entries blend: before the first one.
scene::Blending read_blending(SceneBuilder& build)
{
    constexpr int kModes = 4;
    TokenStream& in = build.stream();
    scene::Blending out;
    for (;;) {
        if (in.accept(Kind::BlendMode)) {
            const scene::SourceRef at = in.last();
            const double mode = parser::float_expr(in);
            if (!(mode >= 0 && mode < kModes)) in.fail(at, "blend_mode must be 0, 1, 2 or 3");
            out.mode = static_cast<scene::Blending::Mode>(mode);
        } else if (in.accept(Kind::BlendGamma)) {
            const scene::SourceRef at = in.last();
            out.gamma = static_cast<float>(parser::float_expr(in));
            if (!(out.gamma > 0)) in.fail(at, "blend_gamma must be above 0");
        } else {
            return out;
        }
    }
}

/// `{ NAME }` or `{ [...] [...] }`; `entry` reads what stands between the brackets and appends to the map.
/// blends: the text may say how.
template <class Map, bool blends = false, class Entry>
Map read_map(SceneBuilder& build, const char* what, Entry&& entry)
{
    TokenStream& in = build.stream();
    const auto guard = in.nest();
    const scene::SourceRef opened = build.open_block(what);
    Map map;
    if constexpr (blends) map.blending = read_blending(build);
    if (const auto declared = in.accept_identifier<std::shared_ptr<const Map>>()) {
        build.close_block(what, opened);
        return **declared;
    }
    while (in.accept(Kind::LeftSquare)) {
        entry(map);
        in.expect(Kind::RightSquare, "']' at the end of the map's entry");
        in.accept_comma();
        if (map.size() > kMostEntries && in.strictly_37()) in.fail(in.last(), "a map has at most 256 entries");
    }
    if (map.empty()) build.fail_unknown("'[' and the first entry of the map");
    build.close_block(what, opened);
    return map;
}

/// Keys are kept in single precision.
double read_key(SceneBuilder& build)
{
    if (!at_expression(build.stream())) build.fail_unknown("the entry's key (a number)");
    const double key = static_cast<float>(parser::float_expr(build.stream()));
    build.stream().accept_comma();
    return key;
}

/// A colour in a map begins with a colour word or a declared colour.
bool at_map_color(TokenStream& in)
{
    if (!in.at_name()) return lexical_class(in.peek().kind) == LexicalClass::Color;
    const Value* value = in.named_ahead();
    const Tuple* tuple = value ? value->get_if<Tuple>() : nullptr;
    return tuple ? tuple->count == 5 : at_expression(in);
}

/// Of `average`: the weight may be left out.
double read_weight(SceneBuilder& build, bool weights)
{
    TokenStream& in = build.stream();
    if (!weights) return read_key(build);
    const Value* value = in.named_ahead();
    const bool number = in.at_name() ? value && value->get_if<Tuple>() : at_expression(in);
    return number ? read_key(build) : 1.0;
}

Form blending_form()
{
    const auto number = [](Kind keyword) { return Form::sequence({Form::token(keyword), form_of<a_number>()}); };
    return Form::repeated(Form::choice({number(Kind::BlendMode), number(Kind::BlendGamma)}));
}

/// `{ NAME }` or entries with a key each, behind what `head` says.
Form map_form(Form value, Form head = {})
{
    const Form entry = Form::sequence({Form::token(Kind::LeftSquare), form_of<a_number>(), form_of<opt_comma>(),
                                       std::move(value), Form::token(Kind::RightSquare), form_of<opt_comma>()});
    return Form::braces({std::move(head), Form::choice({Form::operand("identifier"), Form::repeated(entry, 1)})});
}

}  // namespace

Production color_map_block()
{
    const Form old = Form::sequence({form_of<a_number>(), form_of<a_color>(), form_of<a_color>()});
    return {"color_map_block", map_form(Form::choice({form_of<a_color>(), old}), blending_form())};
}
Production density_map_block() { return {"density_map_block", map_form(Form::named(density_body))}; }
Production pigment_map_block() { return {"pigment_map_block", map_form(Form::named(pigment_body), blending_form())}; }
Production normal_map_block() { return {"normal_map_block", map_form(Form::named(normal_body))}; }
Production texture_map_block() { return {"texture_map_block", map_form(Form::named(texture_body))}; }
Production slope_map_block() { return {"slope_map_block", map_form(form_of<a_pair>())}; }

scene::ColorMap read_color_map(SceneBuilder& build)
{
    TokenStream& in = build.stream();
    return read_map<scene::ColorMap, true>(build, "color_map", [&](scene::ColorMap& map) {
        const double key = read_key(build);
        if (at_map_color(in)) {
            map.push_back({key, parser::color_expr(in)});
            return;
        }
        // Old form [k1, k2 color A color B]; POV-Ray asks the second colour alone for its word.
        if (!at_expression(in)) build.fail_unknown("the entry's colour, as in rgb <1, 0.5, 0>");
        const double second = static_cast<float>(parser::float_expr(in));
        if (!at_expression(in)) build.fail_unknown("the entry's first colour, as in color rgb <1, 0.5, 0>");
        map.push_back({key, parser::color_expr(in)});
        if (in.peek().kind != Kind::Color)
            in.fail_expected("'color' and the entry's second colour, as in color rgb <1, 0.5, 0>");
        map.push_back({second, parser::color_expr(in)});
    });
}

scene::PigmentMap read_density_map(SceneBuilder& build, bool weights)
{
    return read_map<scene::PigmentMap>(build, "density_map", [&](scene::PigmentMap& map) {
        const double key = read_weight(build, weights);
        scene::Pigment white;
        white.kind = scene::Color{1, 1, 1, 0, 0};
        map.push_back({key, std::make_shared<scene::Pigment>(read_density_body(build, white))});
    });
}

scene::PigmentMap read_pigment_map(SceneBuilder& build, bool weights)
{
    return read_map<scene::PigmentMap, true>(build, "pigment_map", [&](scene::PigmentMap& map) {
        const double key = read_weight(build, weights);
        map.push_back({key, std::make_shared<scene::Pigment>(read_pigment_body(build, build.default_layer().pigment))});
    });
}

NormalMap read_normal_map(SceneBuilder& build, bool weights)
{
    return read_map<NormalMap>(build, "normal_map", [&](NormalMap& map) {
        const double key = read_weight(build, weights);
        map.push_back({key, std::make_shared<scene::Normal>(read_normal_body(build, build.default_layer().normal))});
    });
}

SlopeMap read_slope_map(SceneBuilder& build)
{
    return read_map<SlopeMap>(build, "slope_map", [&](SlopeMap& map) {
        const double key = read_key(build);
        map.push_back({key, parser::vector2_expr(build.stream())});
    });
}

TextureMap read_texture_map(SceneBuilder& build, bool weights)
{
    return read_map<TextureMap>(build, "texture_map", [&](TextureMap& map) {
        const double key = read_weight(build, weights);
        map.push_back({key, read_texture_body(build)});
    });
}

}  // namespace parser
