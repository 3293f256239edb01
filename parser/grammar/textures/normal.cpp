#include "parser/grammar/textures/images.h"
#include "parser/grammar/textures/old_words.h"
#include "parser/grammar/core/rules.h"

namespace parser {
namespace {

struct NormalState : BlockState {
    using BlockState::BlockState;
    scene::Normal& subject() { return normal; }
    scene::Normal normal;
};
struct normal_map : item<Kind::NormalMap, reads<normal_map_block>> {
    static void act(NormalState& s) { s.normal.map = read_normal_map(s.build, s.normal.pattern.name == "average"); }
};
struct slope_map : item<Kind::SlopeMap, reads<slope_map_block>> {
    static void act(NormalState& s) { s.normal.map = read_slope_map(s.build); }
};
using NormalItems =
    table<NormalState, normal_map, slope_map, member<Kind::BumpSize, &scene::Normal::amount>,
          member<Kind::Accuracy, &scene::Normal::accuracy>, member<Kind::NoBumpScale, &scene::Normal::no_bump_scale>>;

void read_list(NormalState& s, int count)
{
    TokenStream& in = s.stream();
    s.normal.accuracy = 0.02;
    s.normal.map = std::monostate{};
    if (in.peek().kind != Kind::Normal) return;
    NormalMap map;
    while (static_cast<int>(map.size()) < count && in.accept(Kind::Normal)) {
        map.push_back({static_cast<double>(map.size()),
                       std::make_shared<scene::Normal>(read_normal(s.build, s.build.default_layer().normal))});
        in.accept_comma();
    }
    const scene::NormalPtr usual = s.build.default_layer().normal;
    while (static_cast<int>(map.size()) < count)
        map.push_back(
            {static_cast<double>(map.size()), std::make_shared<scene::Normal>(usual ? *usual : scene::Normal{})});
    s.normal.map = std::move(map);
}

void read_head(NormalState& s)
{
    TokenStream& in = s.stream();
    if (in.accept(Kind::BumpMap)) {
        s.normal.pattern = {};
        s.normal.pattern.name = "bump_map";
        s.normal.pattern.source = in.last();
        const auto bumps = read_image_block(s.build, false);
        s.normal.pattern.data = bumps;
        s.normal.map = std::monostate{};
        if (bumps->bump_size) s.normal.amount = *bumps->bump_size;
        in.accept_comma();
        // In a texture of version 1 the colour may follow.
        if (at_expression(in) && lexical_class(in.peek().kind) != LexicalClass::Color)
            s.normal.amount = parser::float_expr(in);
        return;
    }
    if (in.accept(Kind::UvMapping)) {
        s.normal = {};
        s.normal.source = s.normal.pattern.source = in.last();
        s.normal.pattern.name = "uv_mapping";
        s.normal.map = NormalMap{{0, std::make_shared<scene::Normal>(read_normal_body(s.build, nullptr))}};
        return;
    }
    if (!read_pattern_type(s.build, s.normal.pattern, true)) {
        if (!s.normal.pattern.name.empty() && at_expression(in))
            s.normal.amount = parser::float_expr(in);  // normal { N 0.9 }
        return;
    }
    if (const int count = list_size(s.normal.pattern)) read_list(s, count);
    close_list(s.build, s.normal.pattern);
    const bool comma = in.accept_comma();
    if (at_expression(in)) s.normal.amount = parser::float_expr(in);
    else if (comma) s.build.fail_unknown("the normal's amount (a number)");
}

}  // namespace

Production normal_block() { return {"normal_block", Form::braces({Form::named(normal_body)})}; }

Production normal_body()
{
    const Form amount = Form::optional(form_of<a_number>());
    const Form map = Form::sequence({Form::token(Kind::BumpMap), Form::named(image_block), amount});
    const Form list = Form::repeated(Form::sequence({Form::token(Kind::Normal), Form::named(normal_block)}));
    const Form pattern =
        Form::sequence({Form::choice({Form::named(pattern_type), Form::token(Kind::Facets)}), list, amount});
    const Form head = Form::choice({map, Form::token(Kind::UvMapping), pattern, form_of<a_number>()});
    const Form items = Form::choice({NormalItems::form(), Form::named(pattern_modifier)});
    return {"normal_body",
            Form::sequence({Form::optional(Form::operand("identifier")), Form::optional(head), Form::repeated(items)})};
}

scene::Normal read_normal_body(SceneBuilder& build, const scene::NormalPtr& base)
{
    TokenStream& in = build.stream();
    const auto guard = in.nest();
    NormalState s(build);
    if (base) s.normal = *base;
    s.normal.source = in.here();
    if (const auto declared = in.accept_identifier<scene::NormalPtr>()) s.normal = **declared;
    read_head(s);
    while (NormalItems::match(build, s) || read_pattern_modifier(build, s.normal.pattern)) {}
    check_pavement(build, s.normal.pattern);
    if (s.normal.pattern.name == "average" && std::holds_alternative<std::monostate>(s.normal.map))
        in.fail(s.normal.source, "'average' needs a normal_map");
    if (s.normal.pattern.name.empty() && !std::holds_alternative<std::monostate>(s.normal.map))
        in.fail(s.normal.source, "this normal has a map, but no pattern");
    return s.normal;
}

scene::Normal read_normal(SceneBuilder& build, const scene::NormalPtr& base)
{
    const scene::SourceRef opened = build.open_block("normal");
    scene::Normal normal = read_normal_body(build, base);
    build.close_block("normal", opened);
    return normal;
}

bool read_old_normal(SceneBuilder& build, scene::NormalPtr& normal)
{
    const Kind kind = build.stream().peek().kind;
    const bool modifier = is_one_of(kind, {Kind::Frequency, Kind::Phase});
    if (!modifier &&
        !is_one_of(kind, {Kind::Bumps, Kind::Dents, Kind::Ripples, Kind::Waves, Kind::Wrinkles, Kind::BumpMap}))
        return false;
    NormalState s(build);
    if (normal) s.normal = *normal;
    if (modifier) {
        if (!normal)
            build.stream().fail(build.stream().last(), "there is no normal whose frequency or phase this could be");
        read_pattern_modifier(build, s.normal.pattern);
    } else {
        s.normal.source = build.stream().here();
        read_head(s);
    }
    normal = std::make_shared<const scene::Normal>(std::move(s.normal));
    return true;
}

}  // namespace parser
