#include "parser/grammar/core/rules.h"

#include <cmath>

/// Modifiers of a pattern: warps, turbulence, wave forms and the named parameters of single types.
namespace parser {
namespace {

struct ModifierState : BlockState {
    ModifierState(SceneBuilder& b, scene::Pattern& p) : BlockState(b), pattern(p) {}
    scene::Pattern& pattern;
    scene::Pattern& subject() { return pattern; }
    /// A named parameter counts only for the types that have it; others accept and ignore it, as POV-Ray does.
    void set(std::string_view type, std::size_t index, double value)
    {
        if (pattern.name == type && index < pattern.numbers.size()) pattern.numbers[index] = value;
    }
    scene::Turbulence& part(scene::Turbulence*)
    {
        if (!pattern.turbulence) pattern.turbulence.emplace();
        return *pattern.turbulence;
    }
};
bool fractal(const scene::Pattern& p)
{
    return p.name == "mandel" || p.name == "julia" || p.name == "magnet_mandel" || p.name == "magnet_julia";
}

template <Kind kind, scene::WaveForm wave>
struct wave_form : item<kind> {
    static void act(ModifierState& s) { s.pattern.wave = wave; }
};
struct poly_wave : item<Kind::PolyWave, opt<a_number>> {
    static void act(ModifierState& s)
    {
        s.pattern.wave = scene::WaveForm::Poly;
        if (s.operands() != 0) s.pattern.poly_exponent = s.pop_float();
    }
};
struct noise_generator : item<Kind::NoiseGenerator, a_number> {
    static void act(ModifierState& s)
    {
        s.pattern.noise_generator = s.pop_int();
        if (s.pattern.noise_generator < 1 || s.pattern.noise_generator > 3) s.fail("noise_generator must be 1, 2 or 3");
    }
};
template <Kind kind, Kind pattern, std::size_t at>
struct parameter : item<kind, a_number> {
    static void act(ModifierState& s) { s.set(spelling(pattern), at, s.pop_float()); }
};
struct brick_size : item<Kind::BrickSize, a_vector> {
    static void act(ModifierState& s)
    {
        const glm::dvec3 size = s.pop_vector();
        if (s.pattern.name == "brick") s.pattern.vector = size;
    }
};
struct form : item<Kind::Form, a_vector> {
    static void act(ModifierState& s)
    {
        const glm::dvec3 v = s.pop_vector();
        s.set("pavement", 5, v.x);
        if (s.pattern.name == "crackle") s.pattern.vector = v;
    }
};
struct metric : item<Kind::Metric, a_number> {
    static void act(ModifierState& s)
    {
        const double v = s.pop_float();
        s.set("crackle", 0, v);
        s.set("facets", 2, v);
    }
};
struct solid : item<Kind::Solid> {
    static void act(ModifierState& s) { s.set("crackle", 2, 1); }
};
/// Whole numbers of cells, cut off; other types do not take it (POV-Ray 3.8).
struct crackle_repeat : item<Kind::Repeat, a_vector> {
    static void act(ModifierState& s)
    {
        constexpr double kMost = 1 << 30;
        const glm::dvec3 cells = glm::trunc(s.pop_vector());
        for (int i = 0; i < 3; ++i)
            if (!(cells[i] >= 0.0 && cells[i] <= kMost)) s.fail("a pattern repeats after 0 or more cells, not fewer");
        if (s.pattern.name != "crackle") s.fail("only crackle takes 'repeat'");
        s.pattern.numbers.resize(6);
        for (std::size_t i = 0; i < 3; ++i) s.pattern.numbers[3 + i] = cells[static_cast<int>(i)];
    }
};
struct exponent : item<Kind::Exponent, a_number> {
    static void act(ModifierState& s)
    {
        const double v = s.pop_float();
        if (fractal(s.pattern)) s.pattern.numbers[1] = v;
    }
};
/// `exterior type, factor` of a fractal; one number for a pavement.
template <Kind kind, std::size_t at, std::size_t pavement_at>
struct side : item<kind, a_number, by_action<another_number>> {
    static void act(ModifierState& s)
    {
        const double type = s.pop_float();
        s.set("pavement", pavement_at, type);
        if (!fractal(s.pattern)) return;
        s.pattern.numbers[at] = type;
        s.stream().accept_comma();
        if (at_expression(s.stream())) s.pattern.numbers[at + 1] = parser::float_expr(s.stream());
    }
};
/// Of a density_file, whose block has it too; behind a normal's amount it can stand here only.
struct interpolate : item<Kind::Interpolate, a_number> {
    static void act(ModifierState& s)
    {
        const double method = std::trunc(s.pop_float());
        if (s.pattern.name == "density_file") s.pattern.numbers = {method};
    }
};

// ---- warp { } -------------------------------------------------------------------------------------------------
struct WarpState : BlockState {
    WarpState(SceneBuilder& b, scene::Pattern& p) : BlockState(b), pattern(p) {}
    scene::Pattern& pattern;
    std::optional<scene::WarpStep> step;
    template <class T>
    T& as()
    {
        return std::get<T>(*step);
    }
};
/// The items of one kind of warp, without braces of their own.
template <class Struct, class... Items>
struct WarpItems : table<StructState<Struct>, Items...> {
    static void read(SceneBuilder& build, Struct& warp)
    {
        StructState<Struct> s(build);
        s.made = warp;
        while (WarpItems::match(build, s)) {}
        warp = s.made;
    }
    static Form form() { return Form::repeated(table<StructState<Struct>, Items...>::form()); }
};
using scene::BlackHoleWarp;
using scene::MappingWarp;
using scene::RepeatWarp;
using scene::Turbulence;
using RepeatItems =
    WarpItems<RepeatWarp, member<Kind::Offset, &RepeatWarp::offset>, member<Kind::Flip, &RepeatWarp::flip>>;
struct repeat : item<Kind::Repeat, a_vector, by_action<RepeatItems>> {
    static void act(WarpState& s)
    {
        scene::RepeatWarp warp;
        warp.width = s.pop_vector();
        RepeatItems::read(s.build, warp);
        s.step = warp;
    }
};
struct hole_radius : seq<opt_comma, a_number> {};
using HoleItems =
    WarpItems<BlackHoleWarp, member<Kind::Strength, &BlackHoleWarp::strength>,
              member<Kind::Falloff, &BlackHoleWarp::falloff>, word<Kind::Inverse, &BlackHoleWarp::inverse>,
              member<Kind::Repeat, &BlackHoleWarp::repeat>, member<Kind::Turbulence, &BlackHoleWarp::turbulence>>;
struct black_hole : item<Kind::BlackHole, a_vector, hole_radius, by_action<HoleItems>> {
    static void act(WarpState& s)
    {
        scene::BlackHoleWarp warp;
        warp.radius = s.pop_float();
        warp.center = s.pop_vector();
        HoleItems::read(s.build, warp);
        s.step = warp;
    }
};
using TurbulenceItems = WarpItems<Turbulence, member<Kind::Octaves, &Turbulence::octaves>,
                                  member<Kind::Omega, &Turbulence::omega>, member<Kind::Lambda, &Turbulence::lambda>>;
struct warp_turbulence : item<Kind::Turbulence, a_vector, by_action<TurbulenceItems>> {
    static void act(WarpState& s)
    {
        scene::Turbulence warp;
        warp.amount = s.pop_vector();
        TurbulenceItems::read(s.build, warp);
        s.step = warp;
    }
};
struct orientation : item<Kind::Orientation, a_vector> {
    static void act(StructState<MappingWarp>& s) { s.made.orientation = glm::normalize(s.pop_vector()); }
};
using Mapping = scene::MappingWarp::Kind;
using NoItems = WarpItems<MappingWarp>;
using RoundItems = WarpItems<MappingWarp, orientation, member<Kind::DistExp, &MappingWarp::dist_exp>>;
using ToroidalItems = WarpItems<MappingWarp, orientation, member<Kind::DistExp, &MappingWarp::dist_exp>,
                                member<Kind::MajorRadius, &MappingWarp::major_radius>>;
template <Kind kind, Mapping mapping, class Items, class... Values>
struct mapping_warp : item<kind, Values..., by_action<Items>> {
    static void act(WarpState& s)
    {
        MappingWarp warp;
        warp.kind = mapping;
        if (s.operands() == 2) {
            warp.distance = s.pop_float();
            warp.orientation = glm::normalize(s.pop_vector());
        }
        Items::read(s.build, warp);
        s.step = warp;
    }
};
using Warps = table<WarpState, repeat, black_hole, warp_turbulence,
                    mapping_warp<Kind::Planar, Mapping::Planar, NoItems, opt<a_vector, opt_comma, must<a_number>>>,
                    mapping_warp<Kind::Cylindrical, Mapping::Cylindrical, RoundItems>,
                    mapping_warp<Kind::Spherical, Mapping::Spherical, RoundItems>,
                    mapping_warp<Kind::Toroidal, Mapping::Toroidal, ToroidalItems>,
                    mapping_warp<Kind::Cubic, Mapping::Cubic, NoItems>>;
Production warp_block()
{
    return {"warp_block", Form::braces({Form::choice({Form::named(transformation), Warps::form()})})};
}
struct warp : item<Kind::Warp, reads<warp_block>> {
    static void act(ModifierState& s)
    {
        WarpState inner(s.build, s.pattern);
        const auto opened = s.build.open_block("warp");
        if (const auto t = read_transformation(s.build)) inner.step = *t;
        else if (!Warps::match(s.build, inner))
            s.build.fail_unknown("a kind of warp (turbulence, repeat, black_hole, planar, ...)");
        s.build.close_block("warp", opened);
        s.pattern.warps.push_back(*inner.step);
    }
};

using scene::WaveForm;
using Modifiers =
    table<ModifierState, member<Kind::Turbulence, &Turbulence::amount>, member<Kind::Octaves, &Turbulence::octaves>,
          member<Kind::Omega, &Turbulence::omega>, member<Kind::Lambda, &Turbulence::lambda>,
          member<Kind::Frequency, &scene::Pattern::frequency>, member<Kind::Phase, &scene::Pattern::phase>,
          wave_form<Kind::RampWave, WaveForm::Ramp>, wave_form<Kind::SineWave, WaveForm::Sine>,
          wave_form<Kind::TriangleWave, WaveForm::Triangle>, wave_form<Kind::ScallopWave, WaveForm::Scallop>,
          wave_form<Kind::CubicWave, WaveForm::Cubic>, poly_wave, noise_generator,
          parameter<Kind::AgateTurb, Kind::Agate, 0>, brick_size, parameter<Kind::Mortar, Kind::Brick, 0>,
          parameter<Kind::Control0, Kind::Quilted, 0>, parameter<Kind::Control1, Kind::Quilted, 1>, form, metric,
          parameter<Kind::Offset, Kind::Crackle, 1>, solid, crackle_repeat, parameter<Kind::Size, Kind::Facets, 0>,
          parameter<Kind::Coords, Kind::Facets, 1>, exponent, side<Kind::Exterior, 2, 3>, side<Kind::Interior, 4, 4>,
          parameter<Kind::NumberOfSides, Kind::Pavement, 0>, parameter<Kind::NumberOfTiles, Kind::Pavement, 1>,
          parameter<Kind::Pattern, Kind::Pavement, 2>, interpolate, warp>;

}  // namespace

template <>
inline constexpr auto expected<hole_radius> = "the black hole's radius (a number)";

Production pattern_modifier()
{
    return {"pattern_modifier", Form::choice({Form::named(transformation), Modifiers::form()})};
}

bool read_pattern_modifier(SceneBuilder& build, scene::Pattern& pattern)
{
    if (const auto t = read_transformation(build)) {
        pattern.transform(*t);
        return true;
    }
    ModifierState state(build, pattern);
    return Modifiers::match(build, state);
}

}  // namespace parser
