#include "parser/grammar/core/rules.h"

namespace parser {
namespace {

struct FogState : BlockState {
    using BlockState::BlockState;
    scene::Fog fog;
};
struct fog_type : item<Kind::FogType, a_number> {
    static void act(FogState& s)
    {
        s.fog.type = s.pop_int();
        if (s.fog.type != 1 && s.fog.type != 2) s.stream().warn(s.stream().last(), "this type of fog is unknown");
    }
};
struct distance : item<Kind::Distance, a_number> {
    static void act(FogState& s) { s.fog.distance = s.pop_float(); }
};
struct fog_offset : item<Kind::FogOffset, a_number> {
    static void act(FogState& s) { s.fog.offset = s.pop_float(); }
};
struct fog_alt : item<Kind::FogAlt, a_number> {
    static void act(FogState& s) { s.fog.altitude = s.pop_float(); }
};
struct fog_up : item<Kind::Up, a_vector> {
    static void act(FogState& s) { s.fog.up = s.pop_vector(); }
};
struct turbulence : item<Kind::Turbulence, a_vector> {
    static void act(FogState& s) { s.fog.turbulence.amount = s.pop_vector(); }
};
struct octaves : item<Kind::Octaves, a_number> {
    static void act(FogState& s) { s.fog.turbulence.octaves = s.pop_int(); }
};
struct omega : item<Kind::Omega, a_number> {
    static void act(FogState& s) { s.fog.turbulence.omega = s.pop_float(); }
};
struct lambda : item<Kind::Lambda, a_number> {
    static void act(FogState& s) { s.fog.turbulence.lambda = s.pop_float(); }
};
struct turb_depth : item<Kind::TurbDepth, a_number> {
    static void act(FogState& s) { s.fog.turb_depth = s.pop_float(); }
};
/// A colour has a word before it or is an identifier that holds one: a number alone is the distance (spec 2, 16.1).
bool at_fog_color(TokenStream& in)
{
    const Token& token = in.peek();
    if (token.kind != Kind::Identifier) return lexical_class(token.kind) == LexicalClass::Color;
    const Value* value = in.value_of(token);
    const Tuple* tuple = value ? value->get_if<Tuple>() : nullptr;
    return at_color(in) && (!tuple || tuple->count == 5);
}

struct FogItems {
    static bool match(SceneBuilder& build, FogState& s)
    {
        using Items = table<FogState, fog_type, distance, fog_offset, fog_alt, fog_up, turbulence, octaves, omega,
                            lambda, turb_depth>;
        if (Items::match(build, s)) return true;
        // Only the direction `up` can be turned; a fog has no place to move (spec 2, 16.1).
        if (const auto t = read_transformation(build)) {
            s.fog.up = t->vector(s.fog.up);
            return true;
        }
        TokenStream& in = build.stream();
        if (at_fog_color(in)) s.fog.color = parser::color_expr(in);
        else if (at_expression(in)) s.fog.distance = float_expr(in);
        else return false;
        return true;
    }
};

struct SkyState : BlockState {
    using BlockState::BlockState;
    scene::SkySphere sky;
};
struct pigment : item<Kind::Pigment> {
    static void act(SkyState& s) { s.sky.layers.push_back(read_pigment(s.build, scene::Pigment{})); }
};
struct sky_emission : item<Kind::Emission> {
    static void act(SkyState& s) { s.sky.emission = parser::rgb_expr(s.stream()).rgb(); }
};
struct SkyItems {
    static bool match(SceneBuilder& build, SkyState& s)
    {
        if (table<SkyState, pigment, sky_emission>::match(build, s)) return true;
        const auto t = read_transformation(build);
        if (!t) return false;
        for (scene::Pigment& layer : s.sky.layers) layer.transform(*t);
        return true;
    }
};

}  // namespace

scene::Fog read_fog(SceneBuilder& build)
{
    FogState s(build);
    const scene::SourceRef source = build.stream().last();
    read_block<FogItems>(build, s, "fog", [&] {
        if (const auto declared = build.stream().accept_identifier<std::shared_ptr<const scene::Fog>>())
            s.fog = **declared;
    });
    s.fog.source = source;
    if (glm::length(s.fog.up) > 0) s.fog.up = glm::normalize(s.fog.up);
    return s.fog;
}

scene::SkySphere read_sky_sphere(SceneBuilder& build)
{
    SkyState s(build);
    const scene::SourceRef source = build.stream().last();
    read_block<SkyItems>(build, s, "sky_sphere", [&] {
        if (const auto declared = build.stream().accept_identifier<std::shared_ptr<const scene::SkySphere>>())
            s.sky = **declared;
    });
    s.sky.source = source;
    if (s.sky.layers.empty()) build.stream().fail(source, "this sky_sphere has no pigment");
    return s.sky;
}

void read_background(SceneBuilder& build)
{
    const auto opened = build.open_block("background");
    build.description.background = {};  // black where no colour is given
    if (at_color(build.stream())) build.description.background = parser::color_expr(build.stream());
    build.description.background_given = true;
    build.close_block("background", opened);
}

}  // namespace parser
