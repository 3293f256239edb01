#include "parser/grammar/textures/images.h"
#include "parser/grammar/core/rules.h"
#include "parser/stream/functions/function.h"

#include <algorithm>
#include <array>
#include <cmath>

/// Pattern keywords with their parameters; what each number means is written in docs/patterns.md.
namespace parser {
namespace {

struct PatternState : BlockState {
    PatternState(SceneBuilder& b, scene::Pattern& p) : BlockState(b), pattern(p) {}
    scene::Pattern& pattern;
};

/// A new type keeps what the block had: warps, frequency, wave form. In POV-Ray 3.8 it begins anew (spec 7b, 12).
void set_type(PatternState& s, std::string_view name)
{
    scene::Pattern fresh;
    if (s.stream().povray() != scene::PovRay::V38) {
        fresh = std::move(s.pattern);
        fresh.vector = glm::dvec3(0);
        fresh.numbers.clear();
        fresh.pigment.reset();
        fresh.function.reset();
        fresh.data = std::monostate{};
    }
    fresh.name = name;
    fresh.source = s.stream().last();
    s.pattern = std::move(fresh);
}

/// Patterns without parameters, by their own names. Cells of one value each have no frequency unless it is written
/// afterwards (spec 4, 4).
struct PlainPattern {
    Kind keyword;
    double frequency = 1.0;
};
constexpr PlainPattern kPlain[] = {
    {Kind::Aoi},         {Kind::Average},         {Kind::Boxed},      {Kind::Bozo},         {Kind::Bumps},
    {Kind::Cells},       {Kind::Cylindrical},     {Kind::Dents},      {Kind::Granite},      {Kind::Leopard},
    {Kind::Onion},       {Kind::Planar},          {Kind::Radial},     {Kind::Ripples},      {Kind::Spherical},
    {Kind::Spotted},     {Kind::Waves},           {Kind::Wrinkles},   {Kind::Checker, 0.0}, {Kind::Hexagon, 0.0},
    {Kind::Square, 0.0}, {Kind::Triangular, 0.0}, {Kind::Cubic, 0.0},
};

/// The same with numbers that modifiers change.
constexpr struct NumberedPattern {
    Kind keyword;
    double frequency;
    glm::dvec3 vector;
    std::size_t count;
    std::array<double, 6> numbers;
} kNumbered[] = {
    {Kind::Brick, 0.0, {8, 3, 4.5}, 1, {0.5}},      {Kind::Quilted, 0.0, {}, 2, {1, 1}},
    {Kind::Crackle, 1.0, {-1, 1, 0}, 3, {2, 0, 0}}, {Kind::Facets, 1.0, {}, 3, {0.1, 0, 2}},
    {Kind::Pavement, 1.0, {}, 6, {3, 1, 1}},
};

bool read_plain(PatternState& s)
{
    const Kind kind = s.stream().peek().kind;
    const auto begin = [&](double frequency) {
        s.stream().next();
        set_type(s, spelling(kind));
        if (frequency != 1.0) s.pattern.frequency = frequency;
        return true;
    };
    for (const PlainPattern& plain : kPlain)
        if (plain.keyword == kind) return begin(plain.frequency);
    for (const NumberedPattern& one : kNumbered) {
        if (one.keyword != kind) continue;
        begin(one.frequency);
        s.pattern.vector = one.vector;
        s.pattern.numbers.assign(one.numbers.begin(), one.numbers.begin() + static_cast<std::ptrdiff_t>(one.count));
        return true;
    }
    return false;
}

template <Kind kind>
struct triangle_wave : item<kind> {
    static void act(PatternState& s)
    {
        set_type(s, spelling(kind));
        s.pattern.wave = scene::WaveForm::Triangle;
    }
};
struct agate : item<Kind::Agate> {
    static void act(PatternState& s)
    {
        set_type(s, "agate");
        s.pattern.numbers = {1};
        // Always owns a classic turbulence, of amount 0 (spec 4, 5.1).
        if (!s.pattern.turbulence) s.pattern.turbulence.emplace();
    }
};
struct gradient_axis : seq<a_vector> {};
struct gradient : item<Kind::Gradient, gradient_axis> {
    static void act(PatternState& s)
    {
        set_type(s, "gradient");
        s.pattern.vector = s.pop_vector();
    }
};
struct spiral_arms : seq<a_number> {};
template <Kind kind>
struct spiral : item<kind, spiral_arms> {
    static void act(PatternState& s)
    {
        set_type(s, kind == Kind::Spiral1 ? "spiral1" : "spiral2");
        s.pattern.wave = scene::WaveForm::Triangle;
        s.pattern.numbers = {s.pop_float()};
    }
};
struct tiling_kind : seq<a_number> {};
struct tiling : item<Kind::Tiling, tiling_kind> {
    static void act(PatternState& s)
    {
        set_type(s, "tiling");
        const double kind = std::trunc(s.pop_float());
        if (!(kind >= 1 && kind <= 27)) s.fail("the kind of tiling must be between 1 and 27");
        s.pattern.numbers = {kind};
    }
};

struct iterations : seq<opt_comma, a_number> {};
struct julia_constant : seq<a_pair> {};

void mandel_parameters(PatternState& s, const char* name)
{
    set_type(s, name);
    read_rule<iterations>(s.build, s);
    s.pattern.numbers = {s.pop_float(), 2, 1, 1, 0, 1};
}
void julia_parameters(PatternState& s, const char* name)
{
    set_type(s, name);
    read_rule<julia_constant>(s.build, s);
    const glm::dvec2 c = s.pop_vector2();
    read_rule<iterations>(s.build, s);
    s.pattern.vector = {c.x, c.y, 0};
    s.pattern.numbers = {s.pop_float(), 2, 1, 1, 0, 1};
}
struct mandel : item<Kind::Mandel, by_action<iterations>> {
    static void act(PatternState& s) { mandel_parameters(s, "mandel"); }
};
struct julia : item<Kind::Julia, by_action<julia_constant, iterations>> {
    static void act(PatternState& s) { julia_parameters(s, "julia"); }
};
struct magnet_type : seq<a_number> {};
struct magnet : item<Kind::Magnet, magnet_type, by_action<pegtl::sor<mandel, julia>>> {
    static void act(PatternState& s)
    {
        const double type = s.pop_float();
        if (static_cast<int>(type) != 1 && static_cast<int>(type) != 2) s.fail("the magnet's type must be 1 or 2");
        if (s.stream().accept(Kind::Mandel)) mandel_parameters(s, "magnet_mandel");
        else if (s.stream().accept(Kind::Julia)) julia_parameters(s, "magnet_julia");
        else s.stream().fail_expected("'mandel' or 'julia' after the magnet's type");
        s.pattern.numbers.push_back(type);
    }
};

/// One more number behind an optional comma; the default where none stands.
double optional_number(PatternState& s, double otherwise)
{
    s.stream().accept_comma();
    return at_expression(s.stream()) ? parser::float_expr(s.stream()) : otherwise;
}
void slope_parameters(PatternState& s)
{
    TokenStream& in = s.stream();
    s.pattern.numbers.assign(8, 0.0);
    if (in.accept(Kind::PointAt)) s.pattern.numbers[2] = 1;
    s.pattern.vector = parser::vector_expr(in);
    s.pattern.numbers[0] = optional_number(s, 0);
    s.pattern.numbers[1] = optional_number(s, 0);
    if (!in.accept(Kind::Altitude)) return;
    const glm::dvec3 altitude = parser::vector_expr(in);
    for (int i = 0; i < 3; ++i) s.pattern.numbers[static_cast<std::size_t>(3 + i)] = altitude[i];
    s.pattern.numbers[6] = optional_number(s, 0);
    s.pattern.numbers[7] = optional_number(s, 0);
}
/// In braces or without.
struct slope_values : seq<opt<token<Kind::PointAt>>, a_vector, next_number_or<0>, next_number_or<0>,
                          opt<token<Kind::Altitude>, a_vector, next_number_or<0>, next_number_or<0>>> {};
struct slope : item<Kind::Slope, by_action<pegtl::sor<slope_values, seq<open_brace, slope_values, close_brace>>>> {
    static void act(PatternState& s)
    {
        set_type(s, "slope");
        if (s.stream().peek().kind != Kind::LeftBrace) return slope_parameters(s);
        const auto opened = s.build.open_block("slope");
        slope_parameters(s);
        s.build.close_block("slope", opened);
    }
};
struct pigment_pattern : item<Kind::PigmentPattern, reads<pigment_block>> {
    static void act(PatternState& s)
    {
        set_type(s, "pigment_pattern");
        s.pattern.pigment = std::make_shared<scene::Pigment>(read_pigment(s.build, s.build.default_layer().pigment));
    }
};

struct function_pattern : item<Kind::Function, reads<function_block>> {
    static void act(PatternState& s)
    {
        set_type(s, "function");
        s.stream().expect(Kind::LeftBrace, "'{' and the function's body");
        s.pattern.function = read_function_body(s.stream(), {});
        if (s.pattern.function->parameters != 3)
            s.stream().fail(s.pattern.source, "a pattern's function must take x, y and z alone");
    }
};
struct image_pattern : item<Kind::ImagePattern, reads<image_block>> {
    static void act(PatternState& s)
    {
        set_type(s, "image_pattern");
        s.pattern.data = read_image_block(s.build, false);
        s.pattern.frequency = 0;
    }
};
/// What its outside and inside have stands behind the object.
Production object_list()
{
    const Form texture = Form::sequence({Form::token(Kind::Texture), Form::named(texture_block)});
    const Form pigment = Form::sequence({Form::token(Kind::Pigment), Form::named(pigment_block)});
    const Form normal = Form::sequence({Form::token(Kind::Normal), Form::named(normal_block)});
    return {"object_list", Form::braces({Form::named(any_object), Form::repeated(form_of<a_color>()),
                                         Form::repeated(texture), Form::repeated(pigment), Form::repeated(normal)})};
}
struct object : item<Kind::Object, reads<object_list>> {
    static void act(PatternState& s)
    {
        set_type(s, "object");
        s.pattern.data = read_object_pattern(s.build);
        s.pattern.frequency = 0;
    }
};
/// Values of any size; frequency and phase count behind a wave's name only.
Production potential_block() { return {"potential_block", Form::braces({Form::named(any_object)})}; }
struct less_threshold : seq<a_number> {};
struct potential
    : item<Kind::Potential, reads<potential_block>, by_action<pegtl::star<token<Kind::Threshold>, less_threshold>>> {
    static void act(PatternState& s)
    {
        set_type(s, "potential");
        s.pattern.data = read_potential(s.build);
        s.pattern.numbers = {0};
        // Right behind the block, before a normal's amount; the last one counts (spec 7b, 3).
        while (s.stream().accept(Kind::Threshold)) {
            read_rule<less_threshold>(s.build, s);
            s.pattern.numbers[0] = s.pop_flag() ? 1.0 : 0.0;
        }
        s.pattern.wave = scene::WaveForm::Raw;
    }
};
struct density_file
    : item<Kind::DensityFile, by_action<token<Kind::Df3>, a_text, opt<token<Kind::Interpolate>, a_number>>> {
    static void act(PatternState& s)
    {
        set_type(s, "density_file");
        auto density = read_density_file(s.build);
        if (density->interpolation != 0) s.pattern.numbers = {static_cast<double>(density->interpolation)};
        s.pattern.data = std::move(density);
    }
};

using Types = table<PatternState, triangle_wave<Kind::Marble>, triangle_wave<Kind::Wood>, agate, gradient,
                    spiral<Kind::Spiral1>, spiral<Kind::Spiral2>, tiling, mandel, julia, magnet, slope, pigment_pattern,
                    function_pattern, image_pattern, object, potential, density_file>;

}  // namespace

template <>
inline constexpr auto expected<gradient_axis> = "the gradient's direction, as in x or <0, 1, 0>";
template <>
inline constexpr auto expected<spiral_arms> = "the spiral's number of arms";
template <>
inline constexpr auto expected<tiling_kind> = "the kind of tiling, 1 to 27";
template <>
inline constexpr auto expected<iterations> = "the number of iterations";
template <>
inline constexpr auto expected<julia_constant> = "the julia set's constant, as in <0.353, 0.288>";
template <>
inline constexpr auto expected<less_threshold> = "whether the object's threshold is taken off the potential";
template <>
inline constexpr auto expected<magnet_type> = "the magnet's type, 1 or 2";

Production pattern_type()
{
    std::vector<Form> all{Types::form()};
    for (const PlainPattern& plain : kPlain) all.push_back(Form::token(plain.keyword));
    for (const NumberedPattern& one : kNumbered) {
        all.push_back(Form::token(one.keyword));
        all.back().rare = one.keyword == Kind::Facets;  // of normals alone
    }
    return {"pattern_type", Form::choice(std::move(all))};
}

bool read_pattern_type(SceneBuilder& build, scene::Pattern& pattern, bool of_normal)
{
    if (!of_normal && build.stream().peek().kind == Kind::Facets)
        build.stream().fail(build.stream().here(), "'facets' is a pattern of normals alone");
    PatternState state(build, pattern);
    return Types::match(build, state) || read_plain(state);
}

void close_list(SceneBuilder& build, const scene::Pattern& pattern)
{
    if (pattern.name == "object") build.close_block("object", pattern.source);
}

int list_size(const scene::Pattern& p)
{
    if (p.name == "checker" || p.name == "brick" || p.name == "object") return 2;
    if (p.name == "hexagon") return 3;
    if (p.name == "square") return 4;
    return p.name == "triangular" || p.name == "cubic" ? 6 : 0;
}

}  // namespace parser
