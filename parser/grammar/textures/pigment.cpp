#include "parser/grammar/textures/images.h"
#include "parser/grammar/textures/old_words.h"
#include "parser/grammar/core/rules.h"
#include "parser/stream/functions/function.h"
#include "render/scene/media.h"
#include "render/scene/textures/color_functions.h"

namespace parser {
namespace {

/// What a plain colour keeps of a pattern for one that may follow.
void keep_space(scene::Pattern& pattern)
{
    scene::Pattern kept;
    kept.warps = std::move(pattern.warps);
    kept.turbulence = pattern.turbulence;
    kept.noise_generator = pattern.noise_generator;
    kept.frequency = pattern.frequency;
    kept.phase = pattern.phase;
    kept.wave = pattern.wave;
    kept.poly_exponent = pattern.poly_exponent;
    pattern = std::move(kept);
}

/// Whether keep_space() leaves more than of a pattern that nothing was written for.
bool has_space(const scene::Pattern& pattern)
{
    return !pattern.warps.empty() || pattern.turbulence || pattern.noise_generator != 0 || pattern.frequency != 1.0 ||
           pattern.phase != 0.0 || pattern.wave != scene::WaveForm::Ramp || pattern.poly_exponent != 1.0;
}

bool same(const scene::ColorMap& a, const scene::ColorMap& b)
{
    return a.blending == b.blending &&
           std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& x, const auto& y) { return x.key == y.key && x.value == y.value; });
}

}  // namespace

struct PigmentState : BlockState {
    PigmentState(SceneBuilder& b, const scene::Pigment& base, bool density_block)
        : BlockState(b), density(density_block)
    {
        start_from(base);
    }

    bool density;  // `density`: its own maps and lists
    std::optional<scene::Color> quick_color;
    scene::Color color;
    scene::Pattern pattern;  // a name: the pigment is patterned
    scene::ColorMap colors;
    bool mapless = false;                              // a colour or an image_map stood first
    scene::PigmentMap pigments;                        // at most one of the two maps has entries
    std::shared_ptr<const scene::Pigment> on_surface;  // uv_mapping: the pigment in uv space

    void start_from(const scene::Pigment& base)
    {
        quick_color = base.quick_color;
        if (const auto* plain = std::get_if<scene::Color>(&base.kind)) {
            color = *plain;
            if (base.space.given()) take(*base.space);
            return;
        }
        take(*std::get<scene::Shared<scene::PatternedPigment>>(base.kind));
    }
    void take(const scene::PatternedPigment& patterned)
    {
        pattern = patterned.pattern;
        if (const auto* c = std::get_if<scene::ColorMap>(&patterned.map)) colors = *c;
        else pigments = std::get<scene::PigmentMap>(patterned.map);
    }
    /// The colours of a pattern without a map are those of its kind, and no map for another; finished() has them again.
    void forget_usual()
    {
        if (pattern.name.empty() || list_size(pattern) > 0) return;
        if (same(colors, default_colors(pattern))) colors.clear();
    }
    void set_plain(const scene::Color& c)
    {
        keep_space(pattern);
        color = c;
    }
    /// A pattern that has colours of its own; its keyword has just been read.
    void set_mapless(Kind keyword)
    {
        set_plain({});
        colors.clear();
        pigments.clear();
        if (stream().povray() == scene::PovRay::V38) pattern = {};  // spec 7b, 12
        pattern.name = spelling(keyword);
        pattern.source = stream().last();
        mapless = true;
    }
};

namespace {

void reject_map(PigmentState& s)
{
    if (s.mapless) s.fail("a plain colour, an image_map and user_defined take no map");
    if (list_size(s.pattern) > 0) s.fail("'" + s.pattern.name + "' takes a list of colours or pigments, not a map");
}
struct color_map : item<Kind::ColorMap, reads<color_map_block>> {
    static void act(PigmentState& s)
    {
        reject_map(s);
        s.colors = read_color_map(s.build);
        s.pigments.clear();
    }
};
struct pigment_map : item<Kind::PigmentMap, reads<pigment_map_block>> {
    static void act(PigmentState& s)
    {
        reject_map(s);
        if (s.density) s.fail("'pigment_map' belongs in a pigment; a density has a density_map");
        s.pigments = read_pigment_map(s.build, s.pattern.name == "average");
        s.colors.clear();
    }
};
struct density_map : item<Kind::DensityMap, reads<density_map_block>> {
    static void act(PigmentState& s)
    {
        reject_map(s);
        if (!s.density) s.fail("'density_map' belongs in a density; a pigment has a pigment_map");
        s.pigments = read_density_map(s.build, s.pattern.name == "average");
        s.colors.clear();
    }
};
struct quick_color : item<Kind::QuickColor, a_color> {
    static void act(PigmentState& s) { s.quick_color = s.pop_color(); }
};
using PigmentItems = table<PigmentState, color_map, pigment_map, density_map, quick_color>;

/// Colours or pigments of checker, brick, ...: the first one decides which.
void read_list(PigmentState& s, int count)
{
    TokenStream& in = s.stream();
    s.colors.clear();
    s.pigments.clear();
    const Kind keyword = s.density ? Kind::Density : Kind::Pigment;
    if (in.peek().kind == keyword) {
        while (static_cast<int>(s.pigments.size()) < count && in.accept(keyword)) {
            const scene::SourceRef opened = s.build.open_block(s.density ? "density" : "pigment");
            const scene::Pigment& base = s.build.default_layer().pigment;
            auto one = std::make_shared<scene::Pigment>(s.density ? read_density_body(s.build, scene::Pigment{})
                                                                  : read_pigment_body(s.build, base));
            s.build.close_block(s.density ? "density" : "pigment", opened);
            s.pigments.push_back({static_cast<double>(s.pigments.size()), std::move(one)});
            in.accept_comma();
        }
        while (static_cast<int>(s.pigments.size()) < count)
            s.pigments.push_back({static_cast<double>(s.pigments.size()),
                                  std::make_shared<scene::Pigment>(s.build.default_layer().pigment)});
        return;
    }
    s.colors = default_colors(s.pattern);
    for (int i = 0; i < count && !s.density && at_color(in); ++i) {
        s.colors[static_cast<std::size_t>(i)].value = parser::color_expr(in);
        in.accept_comma();
    }
}

/// A pigment may begin with a colour word or a declared colour, not with a bare vector.
bool at_plain_color(TokenStream& in)
{
    if (!in.at_name()) return lexical_class(in.peek().kind) == LexicalClass::Color;
    const Value* value = in.named_ahead();
    return value && !value->get_if<std::shared_ptr<const scene::Object>>() && at_color(in);
}

/// Functions of a place that are a pigment's components, in their order; any may be left out (spec 7b, 2).
std::shared_ptr<const scene::ColorFunctions> read_color_functions(SceneBuilder& build)
{
    TokenStream& in = build.stream();
    auto functions = std::make_shared<scene::ColorFunctions>();
    const scene::SourceRef opened = build.open_block("user_defined");
    for (function::FunctionPtr& part : functions->parts) {
        if (in.accept(Kind::Function)) {
            const scene::SourceRef place = in.last();
            in.expect(Kind::LeftBrace, "'{' and the function's body");
            part = read_function_body(in, {});
            if (part->parameters != 3) in.fail(place, "the function of a component must take x, y and z alone");
        }
        const bool more = in.accept_comma() || in.peek().kind == Kind::Function;
        if (!more) break;
    }
    build.close_block("user_defined", opened);
    return functions;
}

void read_head(PigmentState& s)
{
    TokenStream& in = s.stream();
    s.forget_usual();
    if (at_plain_color(in)) {
        s.set_plain(parser::color_expr(in));
        s.mapless = true;
    } else if (in.accept(Kind::ImageMap)) {
        s.set_mapless(Kind::ImageMap);
        s.pattern.data = read_image_block(s.build, true);
    } else if (in.accept(Kind::UserDefined)) {
        s.set_mapless(Kind::UserDefined);
        s.pattern.data = read_color_functions(s.build);
    } else if (in.accept(Kind::UvMapping)) {
        s.pattern = {};
        s.pattern.name = "uv_mapping";
        s.pattern.source = in.last();
        s.on_surface = std::make_shared<scene::Pigment>(read_pigment_body(s.build, scene::Pigment{}));
    } else {
        if (!read_pattern_type(s.build, s.pattern)) return;
        const int count = list_size(s.pattern);
        if (count > 0) read_list(s, count);
        close_list(s.build, s.pattern);
    }
}

scene::Pigment finished(PigmentState& s, const scene::SourceRef& source)
{
    scene::Pigment result;
    result.source = source;
    result.quick_color = s.quick_color;
    if (s.pattern.name.empty()) {
        result.kind = s.color;
        if (!has_space(s.pattern) && s.colors.empty() && s.pigments.empty()) return result;
        keep_space(s.pattern);
        scene::PatternedPigment& space = result.space.edit();
        space.pattern = std::move(s.pattern);
        if (s.pigments.empty()) space.map = std::move(s.colors);
        else space.map = std::move(s.pigments);
        return result;
    }
    scene::PatternedPigment patterned;
    patterned.pattern = std::move(s.pattern);
    if (s.on_surface) {
        patterned.map = scene::PigmentMap{{0, s.on_surface}};
    } else if (patterned.pattern.name == "image_map" || patterned.pattern.name == "user_defined") {
        patterned.map = scene::ColorMap{};
    } else if (!s.pigments.empty()) {
        patterned.map = std::move(s.pigments);
    } else {
        if (patterned.pattern.name == "average" && s.colors.empty())
            s.stream().fail(source, "'average' needs a pigment_map");
        patterned.map = s.colors.empty() ? default_colors(patterned.pattern) : std::move(s.colors);
    }
    result.kind = std::move(patterned);
    return result;
}

}  // namespace

namespace {

scene::Pigment read_body(SceneBuilder& build, const scene::Pigment& base, bool density)
{
    TokenStream& in = build.stream();
    const auto guard = in.nest();
    PigmentState s(build, base, density);
    const scene::SourceRef source = in.here();
    const auto start_from = [&s](const scene::Pigment& declared) {
        s.pattern = {};
        s.start_from(declared);
    };
    if (density) {
        if (const auto found = in.accept_identifier<std::shared_ptr<const scene::Density>>())
            start_from((*found)->pigment);
    } else if (const auto found = in.accept_identifier<scene::PigmentPtr>()) {
        start_from(**found);
    }
    read_head(s);
    while (PigmentItems::match(build, s) || read_pattern_modifier(build, s.pattern)) {}
    check_pavement(build, s.pattern);
    return finished(s, source);
}

}  // namespace

/// A list of colours or blocks, or the block of an object, follows some patterns.
template <Production (*body)()>
Form paint_form(Kind keyword, Kind map, Production (*map_block)())
{
    const Form picture = Form::sequence({Form::token(Kind::ImageMap), Form::named(image_map_block)});
    const Form part = Form::sequence({Form::token(Kind::Function), Form::named(function_block)});
    const Form parts = Form::repeated(Form::choice({part, form_of<comma>()}));
    const Form functions = Form::sequence({Form::token(Kind::UserDefined), Form::braces({parts})});
    const Form block = Form::sequence({Form::token(keyword), Form::braces({Form::named(body)})});
    const Form list = Form::choice({Form::repeated(form_of<a_color>()), Form::repeated(block)});
    const Form pattern = Form::sequence({Form::named(pattern_type), Form::optional(list)});
    const Form items = Form::choice({form_of<color_map>(), Form::sequence({Form::token(map), Form::named(map_block)}),
                                     form_of<quick_color>(), Form::named(pattern_modifier)});
    const Form head = Form::choice({form_of<a_color>(), picture, functions, Form::token(Kind::UvMapping), pattern});
    return Form::sequence({Form::optional(Form::operand("identifier")), Form::optional(head), Form::repeated(items)});
}
Production pigment_body()
{
    return {"pigment_body", paint_form<pigment_body>(Kind::Pigment, Kind::PigmentMap, pigment_map_block)};
}
Production pigment_block() { return {"pigment_block", Form::braces({Form::named(pigment_body)})}; }
Production density_body()
{
    return {"density_body", paint_form<density_body>(Kind::Density, Kind::DensityMap, density_map_block)};
}

scene::Pigment read_pigment_body(SceneBuilder& build, const scene::Pigment& base)
{
    return read_body(build, base, false);
}

scene::Pigment read_density_body(SceneBuilder& build, const scene::Pigment& base)
{
    return read_body(build, base, true);
}

scene::Pigment read_pigment(SceneBuilder& build, const scene::Pigment& base)
{
    const scene::SourceRef opened = build.open_block("pigment");
    scene::Pigment pigment = read_pigment_body(build, base);
    build.close_block("pigment", opened);
    return pigment;
}

bool OldPigment::read(const scene::Pigment& base)
{
    TokenStream& in = build_.stream();
    const Kind kind = in.peek().kind;
    const bool pattern = is_one_of(kind, {Kind::Agate, Kind::Bozo, Kind::Checker, Kind::Gradient, Kind::Granite,
                                          Kind::Hexagon, Kind::Leopard, Kind::Mandel, Kind::Marble, Kind::Onion,
                                          Kind::Spotted, Kind::Wood}),
               head = pattern || kind == Kind::ImageMap || at_plain_color(in),
               modifier = is_one_of(kind, {Kind::Turbulence, Kind::Octaves, Kind::Omega, Kind::Lambda});
    if (!head && !modifier && kind != Kind::ColorMap && kind != Kind::QuickColor) return false;
    if (!state_) {
        state_ = std::make_shared<PigmentState>(build_, base, false);
        source_ = in.here();
    }
    PigmentState& s = *state_;
    if (!head) return modifier ? read_pattern_modifier(build_, s.pattern) : PigmentItems::match(build_, s);
    s.mapless = false;
    read_head(s);
    s.mapless = false;                                    // a map without effect may follow
    if (pattern) s.pattern.wave = scene::WaveForm::Ramp;  // of marble and wood too (spec 4, 14.1)
    return true;
}

void OldPigment::put(scene::Pigment& pigment)
{
    if (state_) pigment = finished(*state_, source_);
    state_.reset();
}

}  // namespace parser
