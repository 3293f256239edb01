#include "parser/grammar/core/rules.h"

#include <cmath>

/// Modifiers of a pattern: warps, turbulence, wave forms and the named parameters of single types.
namespace parser {
namespace {

struct ModifierState : BlockState {
    ModifierState(SceneBuilder& b, scene::Pattern& p) : BlockState(b), pattern(p) {}
    scene::Pattern& pattern;
    /// A named parameter counts only for the types that have it; others accept and ignore it, as POV-Ray does.
    void set(std::string_view type, std::size_t index, double value)
    {
        if (pattern.name == type && index < pattern.numbers.size()) pattern.numbers[index] = value;
    }
    scene::Turbulence& turbulence()
    {
        if (!pattern.turbulence) pattern.turbulence.emplace();
        return *pattern.turbulence;
    }
};
bool fractal(const scene::Pattern& p)
{
    return p.name == "mandel" || p.name == "julia" || p.name == "magnet_mandel" || p.name == "magnet_julia";
}

struct turbulence : item<Kind::Turbulence, a_vector> {
    static void act(ModifierState& s) { s.turbulence().amount = s.pop_vector(); }
};
struct octaves : item<Kind::Octaves, a_number> {
    static void act(ModifierState& s) { s.turbulence().octaves = s.pop_int(); }
};
struct omega : item<Kind::Omega, a_number> {
    static void act(ModifierState& s) { s.turbulence().omega = s.pop_float(); }
};
struct lambda : item<Kind::Lambda, a_number> {
    static void act(ModifierState& s) { s.turbulence().lambda = s.pop_float(); }
};
struct frequency : item<Kind::Frequency, a_number> {
    static void act(ModifierState& s) { s.pattern.frequency = s.pop_float(); }
};
struct phase : item<Kind::Phase, a_number> {
    static void act(ModifierState& s) { s.pattern.phase = s.pop_float(); }
};
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
        if (s.pattern.noise_generator < 1 || s.pattern.noise_generator > 3)
            s.stream().fail(s.stream().last(), "noise_generator must be 1, 2 or 3");
    }
};
struct agate_turb : item<Kind::AgateTurb, a_number> {
    static void act(ModifierState& s) { s.set("agate", 0, s.pop_float()); }
};
struct brick_size : item<Kind::BrickSize, a_vector> {
    static void act(ModifierState& s)
    {
        const glm::dvec3 size = s.pop_vector();
        if (s.pattern.name == "brick") s.pattern.vector = size;
    }
};
struct mortar : item<Kind::Mortar, a_number> {
    static void act(ModifierState& s) { s.set("brick", 0, s.pop_float()); }
};
struct control0 : item<Kind::Control0, a_number> {
    static void act(ModifierState& s) { s.set("quilted", 0, s.pop_float()); }
};
struct control1 : item<Kind::Control1, a_number> {
    static void act(ModifierState& s) { s.set("quilted", 1, s.pop_float()); }
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
struct offset : item<Kind::Offset, a_number> {
    static void act(ModifierState& s) { s.set("crackle", 1, s.pop_float()); }
};
struct solid : item<Kind::Solid> {
    static void act(ModifierState& s) { s.set("crackle", 2, 1); }
};
struct size : item<Kind::Size, a_number> {
    static void act(ModifierState& s) { s.set("facets", 0, s.pop_float()); }
};
struct coords : item<Kind::Coords, a_number> {
    static void act(ModifierState& s) { s.set("facets", 1, s.pop_float()); }
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
struct side : item<kind, a_number> {
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
struct number_of_sides : item<Kind::NumberOfSides, a_number> {
    static void act(ModifierState& s) { s.set("pavement", 0, s.pop_float()); }
};
struct number_of_tiles : item<Kind::NumberOfTiles, a_number> {
    static void act(ModifierState& s) { s.set("pavement", 1, s.pop_float()); }
};
struct pavement_pattern : item<Kind::Pattern, a_number> {
    static void act(ModifierState& s) { s.set("pavement", 2, s.pop_float()); }
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
struct RepeatState : BlockState {
    RepeatState(SceneBuilder& b, scene::RepeatWarp& w) : BlockState(b), warp(w) {}
    scene::RepeatWarp& warp;
};
struct repeat_offset : item<Kind::Offset, a_vector> {
    static void act(RepeatState& s) { s.warp.offset = s.pop_vector(); }
};
struct repeat_flip : item<Kind::Flip, a_vector> {
    static void act(RepeatState& s) { s.warp.flip = s.pop_vector(); }
};
struct repeat : item<Kind::Repeat, a_vector> {
    static void act(WarpState& s)
    {
        scene::RepeatWarp warp;
        warp.width = s.pop_vector();
        RepeatState inner(s.build, warp);
        while (table<RepeatState, repeat_offset, repeat_flip>::match(s.build, inner)) {}
        s.step = warp;
    }
};
struct HoleState : BlockState {
    HoleState(SceneBuilder& b, scene::BlackHoleWarp& w) : BlockState(b), warp(w) {}
    scene::BlackHoleWarp& warp;
};
struct hole_strength : item<Kind::Strength, a_number> {
    static void act(HoleState& s) { s.warp.strength = s.pop_float(); }
};
struct hole_falloff : item<Kind::Falloff, a_number> {
    static void act(HoleState& s) { s.warp.falloff = s.pop_float(); }
};
struct hole_inverse : item<Kind::Inverse> {
    static void act(HoleState& s) { s.warp.inverse = true; }
};
struct hole_repeat : item<Kind::Repeat, a_vector> {
    static void act(HoleState& s) { s.warp.repeat = s.pop_vector(); }
};
struct hole_turbulence : item<Kind::Turbulence, a_vector> {
    static void act(HoleState& s) { s.warp.turbulence = s.pop_vector(); }
};
struct hole_radius : seq<opt_comma, a_number> {};
struct black_hole : item<Kind::BlackHole, a_vector, hole_radius> {
    static void act(WarpState& s)
    {
        scene::BlackHoleWarp warp;
        warp.radius = s.pop_float();
        warp.center = s.pop_vector();
        HoleState inner(s.build, warp);
        using Items = table<HoleState, hole_strength, hole_falloff, hole_inverse, hole_repeat, hole_turbulence>;
        while (Items::match(s.build, inner)) {}
        s.step = warp;
    }
};
struct TurbulenceState : BlockState {
    TurbulenceState(SceneBuilder& b, scene::Turbulence& t) : BlockState(b), turbulence(t) {}
    scene::Turbulence& turbulence;
};
struct warp_octaves : item<Kind::Octaves, a_number> {
    static void act(TurbulenceState& s) { s.turbulence.octaves = s.pop_int(); }
};
struct warp_omega : item<Kind::Omega, a_number> {
    static void act(TurbulenceState& s) { s.turbulence.omega = s.pop_float(); }
};
struct warp_lambda : item<Kind::Lambda, a_number> {
    static void act(TurbulenceState& s) { s.turbulence.lambda = s.pop_float(); }
};
struct warp_turbulence : item<Kind::Turbulence, a_vector> {
    static void act(WarpState& s)
    {
        scene::Turbulence warp;
        warp.amount = s.pop_vector();
        TurbulenceState inner(s.build, warp);
        while (table<TurbulenceState, warp_octaves, warp_omega, warp_lambda>::match(s.build, inner)) {}
        s.step = warp;
    }
};
struct MappingState : BlockState {
    MappingState(SceneBuilder& b, scene::MappingWarp& w) : BlockState(b), warp(w) {}
    scene::MappingWarp& warp;
};
struct orientation : item<Kind::Orientation, a_vector> {
    static void act(MappingState& s) { s.warp.orientation = glm::normalize(s.pop_vector()); }
};
struct dist_exp : item<Kind::DistExp, a_number> {
    static void act(MappingState& s) { s.warp.dist_exp = s.pop_float(); }
};
struct major_radius : item<Kind::MajorRadius, a_number> {
    static void act(MappingState& s) { s.warp.major_radius = s.pop_float(); }
};
using Mapping = scene::MappingWarp::Kind;
template <Kind kind, Mapping mapping>
struct mapping_warp : item<kind> {
    static void act(WarpState& s)
    {
        scene::MappingWarp warp;
        warp.kind = mapping;
        TokenStream& in = s.stream();
        if (mapping == Mapping::Planar && at_expression(in)) {
            warp.orientation = glm::normalize(parser::vector_expr(in));
            in.accept_comma();
            warp.distance = parser::float_expr(in);
        }
        MappingState inner(s.build, warp);
        if constexpr (mapping == Mapping::Toroidal)
            while (table<MappingState, orientation, dist_exp, major_radius>::match(s.build, inner)) {}
        else if constexpr (mapping != Mapping::Planar && mapping != Mapping::Cubic)
            while (table<MappingState, orientation, dist_exp>::match(s.build, inner)) {}
        s.step = warp;
    }
};
using Warps =
    table<WarpState, repeat, black_hole, warp_turbulence, mapping_warp<Kind::Planar, Mapping::Planar>,
          mapping_warp<Kind::Cylindrical, Mapping::Cylindrical>, mapping_warp<Kind::Spherical, Mapping::Spherical>,
          mapping_warp<Kind::Toroidal, Mapping::Toroidal>, mapping_warp<Kind::Cubic, Mapping::Cubic>>;
struct warp : item<Kind::Warp> {
    static void act(ModifierState& s)
    {
        WarpState inner(s.build, s.pattern);
        const auto opened = s.build.open_block("warp");
        if (const auto t = read_transformation(s.build)) inner.step = *t;
        else if (!Warps::match(s.build, inner))
            s.build.fail_unknown("a kind of warp (turbulence, repeat, black_hole, planar, ...)");
        s.build.close_block("warp", opened);
        s.pattern.warps.insert(s.pattern.warps.begin(), *inner.step);
    }
};

using scene::WaveForm;
using Modifiers =
    table<ModifierState, turbulence, octaves, omega, lambda, frequency, phase,
          wave_form<Kind::RampWave, WaveForm::Ramp>, wave_form<Kind::SineWave, WaveForm::Sine>,
          wave_form<Kind::TriangleWave, WaveForm::Triangle>, wave_form<Kind::ScallopWave, WaveForm::Scallop>,
          wave_form<Kind::CubicWave, WaveForm::Cubic>, poly_wave, noise_generator, agate_turb, brick_size, mortar,
          control0, control1, form, metric, offset, solid, size, coords, exponent, side<Kind::Exterior, 2, 3>,
          side<Kind::Interior, 4, 4>, number_of_sides, number_of_tiles, pavement_pattern, interpolate, warp>;

}  // namespace

template <>
inline constexpr auto expected<hole_radius> = "the black hole's radius (a number)";

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
