#include "parser/grammar/core/rules.h"

namespace parser {
namespace {

using scene::Fog;

struct FogState : StructState<Fog> {
    using StructState::StructState;
    void take(const std::shared_ptr<const Fog>& declared) { made = *declared; }
    /// Only the direction `up` can be turned; a fog has no place to move (spec 2, 16.1).
    void move(const csg::Transform& by) { made.up = by.vector(made.up); }
    scene::Turbulence& part(scene::Turbulence*) { return made.turbulence; }
};
struct fog_type : item<Kind::FogType, a_number> {
    static void act(FogState& s)
    {
        s.made.type = s.pop_int();
        if (s.made.type != 1 && s.made.type != 2) s.warn("this type of fog is unknown");
    }
};
/// A colour has a word before it or is an identifier that holds one: a number alone is the distance (spec 2, 16.1).
bool at_fog_color(TokenStream& in)
{
    if (!in.at_name()) return lexical_class(in.peek().kind) == LexicalClass::Color;
    const Value* value = in.named_ahead();
    const Tuple* tuple = value ? value->get_if<Tuple>() : nullptr;
    return at_color(in) && (!tuple || tuple->count == 5);
}

/// A colour, or a number alone: the distance.
struct fog_values {
    static bool match(SceneBuilder& build, FogState& s)
    {
        TokenStream& in = build.stream();
        if (at_fog_color(in)) s.made.color = parser::color_expr(in);
        else if (at_expression(in)) s.made.distance = float_expr(in);
        else return false;
        return true;
    }
    static std::vector<Kind> words() { return {}; }
    static Form form() { return Form::choice({form_of<a_color>(), form_of<a_number>()}); }
};
using scene::Turbulence;
using FogItems = either<table<FogState, fog_type, member<Kind::Distance, &Fog::distance>,
                              member<Kind::FogOffset, &Fog::offset>, member<Kind::FogAlt, &Fog::altitude>,
                              member<Kind::Up, &Fog::up>, member<Kind::Turbulence, &Turbulence::amount>,
                              member<Kind::Octaves, &Turbulence::octaves>, member<Kind::Omega, &Turbulence::omega>,
                              member<Kind::Lambda, &Turbulence::lambda>, member<Kind::TurbDepth, &Fog::turb_depth>>,
                        moves, fog_values>;
using FogBlock = block<Kind::Fog, FogItems, opt<declared<std::shared_ptr<const Fog>>>>;

struct SkyState : StructState<scene::SkySphere> {
    using StructState::StructState;
    void take(const std::shared_ptr<const scene::SkySphere>& declared) { made = *declared; }
    void move(const csg::Transform& by)
    {
        for (scene::Pigment& layer : made.layers) layer.transform(by);
        made.moved = by * made.moved;
    }
};
struct sky_pigment : item<Kind::Pigment, reads<pigment_block>> {
    static void act(SkyState& s)
    {
        s.made.layers.push_back(read_pigment(s.build, scene::Pigment{}));
        s.made.layers.back().transform(s.made.moved);
    }
};
using SkyBlock = block<Kind::SkySphere,
                       either<table<SkyState, sky_pigment, member<Kind::Emission, &scene::SkySphere::emission>>, moves>,
                       opt<declared<std::shared_ptr<const scene::SkySphere>>>>;

/// Black where no colour is given.
struct background_color : a_color, item_base {
    static void act(StructState<scene::Color>& s) { s.made = s.pop_color(); }
};
using BackgroundBlock = block<Kind::Background, no_items, opt<background_color>>;

}  // namespace

Production fog_block() { return {"fog_block", FogBlock::form()}; }
Production sky_sphere_block() { return {"sky_sphere_block", SkyBlock::form()}; }
Production background_block() { return {"background_block", BackgroundBlock::form()}; }

Fog read_fog(SceneBuilder& build)
{
    FogState s(build);
    const scene::SourceRef source = build.stream().last();
    FogBlock::read(build, s);
    s.made.source = source;
    if (glm::length(s.made.up) > 0) s.made.up = glm::normalize(s.made.up);
    return s.made;
}

scene::SkySphere read_sky_sphere(SceneBuilder& build)
{
    SkyState s(build);
    const scene::SourceRef source = build.stream().last();
    SkyBlock::read(build, s);
    s.made.source = source;
    if (s.made.layers.empty()) build.stream().fail(source, "this sky_sphere has no pigment");
    return s.made;
}

void read_background(SceneBuilder& build)
{
    StructState<scene::Color> s(build);
    BackgroundBlock::read(build, s);
    build.description.background = s.made;
    build.description.background_given = true;
    build.description.background_before_37 = build.stream().language().effective_version() < 370;
}

}  // namespace parser
