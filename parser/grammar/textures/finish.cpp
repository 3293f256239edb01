#include "parser/grammar/scene/effects.h"
#include "parser/grammar/textures/old_words.h"
#include "parser/grammar/core/rules.h"
#include "render/scene/base/albedo.h"

#include <utility>

namespace parser {
namespace {

struct FinishState : BlockState {
    using BlockState::BlockState;
    scene::Finish& subject() { return finish; }
    scene::Reflection& part(scene::Reflection*) { return finish.reflection; }
    scene::Finish finish;
    bool wrote_diffuse = false;
    bool from_zero =
        false;  ///< `fresnel` stands in this block of a reflection: without a second colour the first is the most
    bool two_colors = false;
    /// POV-Ray 3.8 looks when the finish ends: a mirror with `fresnel` whose two colours are one, however they were
    /// written, has none head-on (spec 7b, 1). 3.7 goes by how many were written.
    bool even_mirrors() { return stream().povray() == scene::PovRay::V38 || finish.fresnel != 0; }
    float old_brilliance = 0;  ///< where the block begins
    void take(const std::shared_ptr<const scene::Finish>& declared) { finish = *declared; }
};

struct diffuse : item<Kind::Diffuse, given<Kind::Albedo>, a_number, next_number_or<0>> {
    static void act(FinishState& s)
    {
        s.finish.diffuse_back = s.pop_single();
        s.finish.diffuse = s.pop_single();
        s.finish.diffuse_albedo = s.pop_flag() || (s.wrote_diffuse && s.finish.diffuse_albedo);
        s.wrote_diffuse = true;
    }
};
template <Kind kind, float scene::Finish::*size, bool scene::Finish::*albedo>
struct highlight : item<kind, given<Kind::Albedo>, a_number> {
    static void act(FinishState& s)
    {
        s.finish.*size = s.pop_single();
        s.finish.*albedo = s.pop_flag() || s.finish.*albedo;
    }
};
template <Kind kind, auto member>
struct one_or_number : item<kind, number_or<1>> {
    static void act(FinishState& s) { member_of<member>(s) = s.pop_single(); }
};
struct roughness : item<Kind::Roughness, a_number> {
    static void act(FinishState& s)
    {
        s.finish.roughness = s.pop_single();
        if (s.finish.roughness == 0.0f) s.warn("a roughness of zero");
    }
};

/// Of a mirror.
struct fresnel : item<Kind::Fresnel, number_or<1>> {
    static void act(FinishState& s)
    {
        s.finish.reflection.fresnel = s.pop_int() != 0;
        s.from_zero = s.finish.reflection.fresnel;
    }
};
/// Of all light of the surface, and of its mirror unless what follows says otherwise (spec 7b, 1).
struct finish_fresnel : item<Kind::Fresnel, number_or<1>> {
    static void act(FinishState& s)
    {
        if (s.stream().strictly_37()) s.fail("'fresnel' of a whole finish is a word of POV-Ray 3.8");
        s.finish.fresnel = s.pop_single();
        s.finish.reflection.fresnel = s.finish.fresnel != 0;
    }
};
struct use_alpha : item<Kind::UseAlpha, number_or<1>> {
    static void act(FinishState& s)
    {
        if (s.stream().strictly_37()) s.fail("'use_alpha' of a finish is a word of POV-Ray 3.8");
        s.finish.use_alpha = s.pop_int() != 0;
    }
};
/// Stored as the power that the reflected colour is raised to: 1/e (spec 3, 7.9).
float exponent_of(FinishState& s)
{
    const float e = s.pop_single();
    if (e == 0) s.fail("the reflection's exponent must not be 0");
    return e;
}
struct exponent : item<Kind::Exponent, a_number> {
    static void act(FinishState& s) { s.finish.reflection.exponent = exponent_of(s); }
};
/// Words of Whittle's own: docs/extensions.md.
struct schlick : item<Kind::WhittleSchlick> {
    static void act(FinishState& s) { s.finish.reflection.fresnel = s.finish.reflection.schlick = s.from_zero = true; }
};
struct gloss : item<Kind::WhittleGloss, a_number, opt<comma, must<a_number>>> {
    static void act(FinishState& s)
    {
        constexpr double kMostSamples = 4096;
        scene::Reflection& r = s.finish.reflection;
        const double samples = s.operands() == 2 ? s.pop_float() : r.gloss_samples;
        r.gloss = s.pop_single();
        if (!(r.gloss >= 0)) s.fail("the roughness of a mirror must not be below 0");
        if (!(samples >= 1 && samples <= kMostSamples)) s.fail("a glossy mirror takes 1 to 4096 rays");
        r.gloss_samples = static_cast<int>(samples);
    }
};
using scene::Finish;
using scene::Reflection;
using ReflectionItems = table<FinishState, fresnel, member<Kind::Falloff, &Reflection::falloff>, exponent,
                              one_or_number<Kind::Metallic, &Reflection::metallic>, schlick, gloss>;

/// The colour seen straight on and at grazing angles; one alone is both.
struct reflection_colors : seq<a_rgb, opt_comma, opt<a_rgb>>, item_base {
    static void act(FinishState& s)
    {
        Reflection& r = s.finish.reflection;
        s.two_colors = s.operands() == 2;
        r.max = s.pop_rgb();
        r.min = s.two_colors ? s.pop_rgb() : r.max;
    }
};
using ReflectionBlock = block<Kind::Reflection, ReflectionItems, opt<reflection_colors>>;
struct reflection : item<Kind::Reflection, by_action<pegtl::sor<ReflectionBlock, a_rgb>>> {
    static void act(FinishState& s)
    {
        Reflection& r = s.finish.reflection;
        const bool of_finish = s.finish.fresnel != 0;  // a mirror has it too where nothing else is said
        if (s.stream().peek().kind != Kind::LeftBrace) {
            r.min = r.max = parser::rgb_expr(s.stream()).rgb();
            r.falloff = 1;
            r.fresnel = of_finish;
            return;
        }
        r.min = r.max = glm::vec3(0);
        s.from_zero = s.two_colors = false;
        ReflectionBlock::read(s.build, s);
        if (s.from_zero && !s.two_colors && !s.even_mirrors()) r.min = glm::vec3(0);
    }
};
struct polished : item<Kind::WhittlePolished, a_number> {
    static void act(FinishState& s)
    {
        s.finish.polished = s.pop_single();
        if (!(s.finish.polished > 0 && s.finish.polished < 1))
            s.fail("the reflectance of a polished surface must lie between 0 and 1");
    }
};
struct cool_warm : item<Kind::WhittleCoolWarm, a_rgb, opt_comma, a_rgb> {
    static void act(FinishState& s)
    {
        s.finish.cool_warm = true;
        s.finish.warm = s.pop_rgb();
        s.finish.cool = s.pop_rgb();
    }
};
struct ink : item<Kind::WhittleInk, a_number, opt<comma, must<a_number>>> {
    static void act(FinishState& s)
    {
        if (s.operands() == 2) s.finish.ink_crease_deg = s.pop_single();
        s.finish.ink = s.pop_single();
        if (!(s.finish.ink >= 0 && s.finish.ink < 45))
            s.fail("the width of ink lines is an angle of view in degrees, 0 to 45");
    }
};
struct reflection_exponent : item<Kind::ReflectionExponent, a_number> {
    static void act(FinishState& s) { s.finish.reflection.exponent = exponent_of(s); }
};

struct irid_turbulence : item<Kind::Turbulence, a_vector> {
    static void act(FinishState& s) { s.finish.irid_turbulence = static_cast<float>(s.pop_vector().x); }
};
struct irid_amount : a_number, item_base {
    static void act(FinishState& s) { s.finish.irid = s.pop_single(); }
};
using IridBlock =
    block<Kind::Irid, table<FinishState, member<Kind::Thickness, &Finish::irid_thickness>, irid_turbulence>,
          irid_amount>;
struct irid : item<Kind::Irid, by_action<IridBlock>> {
    static void act(FinishState& s) { IridBlock::read(s.build, s); }
};
struct subsurface : item<Kind::Subsurface, reads<finish_subsurface_block>> {
    static void act(FinishState& s) { s.finish.subsurface = read_finish_subsurface(s.build); }
};
/// Keywords that moved to the interior in version 3.1.
template <Kind kind, float scene::Finish::*member>
struct moved : item<kind, a_number> {
    static constexpr bool rare = true;
    static void act(FinishState& s)
    {
        s.warn(std::string(spelling(kind)) + " belongs in an interior");
        s.finish.*member = s.pop_single();
    }
};
using ior = moved<Kind::Ior, &scene::Finish::legacy_ior>;
using caustics = moved<Kind::Caustics, &scene::Finish::legacy_caustics>;
using refraction = moved<Kind::Refraction, &scene::Finish::legacy_refraction>;

using FinishItems = table<FinishState, diffuse, highlight<Kind::Phong, &Finish::phong, &Finish::phong_albedo>,
                          highlight<Kind::Specular, &Finish::specular, &Finish::specular_albedo>, roughness,
                          one_or_number<Kind::Metallic, &Finish::metallic>, reflection, reflection_exponent, irid,
                          subsurface, ior, caustics, refraction, finish_fresnel, use_alpha, polished, cool_warm, ink,
                          word<Kind::ConserveEnergy, &Finish::conserve_energy>, member<Kind::Ambient, &Finish::ambient>,
                          member<Kind::Emission, &Finish::emission>, member<Kind::Brilliance, &Finish::brilliance>,
                          member<Kind::Crand, &Finish::crand>, member<Kind::PhongSize, &Finish::phong_size>>;
struct finish_name : opt<declared<std::shared_ptr<const Finish>>>, item_base {
    /// What earlier statements made of `albedo` stays, whatever sizes are written here (spec 3, 7.1).
    static void act(FinishState& s)
    {
        if (std::exchange(s.finish.phong_albedo, false)) s.finish.phong *= scene::phong_of_albedo(s.finish.phong_size);
        if (std::exchange(s.finish.specular_albedo, false))
            s.finish.specular *= scene::specular_of_albedo(s.finish.roughness);
        s.old_brilliance = s.finish.brilliance;
    }
};
using FinishBlock = block<Kind::Finish, FinishItems, finish_name>;

}  // namespace

template <>
inline constexpr auto expected<finish_name> = "";
template <>
inline constexpr auto expected<irid_amount> = "a number";

Production finish_block() { return {"finish_block", FinishBlock::form()}; }

Finish read_finish(SceneBuilder& build, const Finish& before)
{
    FinishState s(build);
    const scene::SourceRef source = build.stream().last();
    s.finish = before;
    FinishBlock::read(build, s);
    // Where nothing changes it, it stays as written too: what radiosity gathers goes by that.
    if (s.finish.diffuse_albedo && !s.wrote_diffuse && s.finish.brilliance != s.old_brilliance) {
        s.finish.diffuse_albedo = false;
        s.finish.diffuse *= scene::diffuse_of_albedo(s.old_brilliance);
        s.finish.diffuse_back *= scene::diffuse_of_albedo(s.old_brilliance);
    }
    scene::Reflection& mirror = s.finish.reflection;
    if (mirror.fresnel && mirror.min == mirror.max && s.even_mirrors()) mirror.min = glm::vec3(0);
    s.finish.source = source;
    return s.finish;
}

bool read_old_finish(SceneBuilder& build, scene::Finish& finish)
{
    TokenStream& in = build.stream();
    const Kind kind = in.peek().kind;
    if (kind == Kind::Number) {
        finish.crand = static_cast<float>(float_expr(in));
        return true;
    }
    if (!is_one_of(kind,
                   {Kind::Ambient, Kind::Brilliance, Kind::Crand, Kind::Diffuse, Kind::Ior, Kind::Metallic, Kind::Phong,
                    Kind::PhongSize, Kind::Reflection, Kind::Refraction, Kind::Roughness, Kind::Specular}))
        return false;
    FinishState s(build);
    s.finish = finish;
    FinishItems::match(build, s);
    finish = s.finish;
    return true;
}

}  // namespace parser
