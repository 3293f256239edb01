#include "parser/grammar/scene/effects.h"
#include "parser/grammar/textures/old_words.h"
#include "parser/grammar/core/rules.h"
#include "render/scene/base/albedo.h"

#include <utility>

namespace parser {
namespace {

struct FinishState : BlockState {
    using BlockState::BlockState;
    scene::Finish finish;
    bool wrote_diffuse = false;
    bool from_zero =
        false;  ///< `fresnel` stands in this block of a reflection: without a second colour the first is the most
    glm::vec3 read_rgb() { return parser::rgb_expr(stream()).rgb(); }
    bool albedo() { return stream().accept(Kind::Albedo); }
    float number()
    {
        read_rule<a_number>(build, *this);
        return pop_single();
    }
    float number_or(float otherwise) { return at_expression(stream()) ? number() : otherwise; }
};

/// A keyword with a number that a member takes as it is.
template <Kind kind, float scene::Finish::*member>
struct number_of : item<kind, a_number> {
    static void act(FinishState& s) { s.finish.*member = s.pop_single(); }
};
struct ambient : item<Kind::Ambient> {
    static void act(FinishState& s) { s.finish.ambient = s.read_rgb(); }
};
struct emission : item<Kind::Emission> {
    static void act(FinishState& s) { s.finish.emission = s.read_rgb(); }
};
struct diffuse : item<Kind::Diffuse> {
    static void act(FinishState& s)
    {
        s.finish.diffuse_albedo = s.albedo() || (s.wrote_diffuse && s.finish.diffuse_albedo);
        s.wrote_diffuse = true;
        s.finish.diffuse = s.number();
        s.stream().accept_comma();
        s.finish.diffuse_back = s.number_or(0);
    }
};
struct phong : item<Kind::Phong> {
    static void act(FinishState& s)
    {
        s.finish.phong_albedo = s.albedo() || s.finish.phong_albedo;
        s.finish.phong = s.number();
    }
};
struct specular : item<Kind::Specular> {
    static void act(FinishState& s)
    {
        s.finish.specular_albedo = s.albedo() || s.finish.specular_albedo;
        s.finish.specular = s.number();
    }
};
struct roughness : item<Kind::Roughness, a_number> {
    static void act(FinishState& s)
    {
        s.finish.roughness = s.pop_single();
        if (s.finish.roughness == 0.0f) s.stream().warn(s.stream().last(), "a roughness of zero");
    }
};
struct metallic : item<Kind::Metallic> {
    static void act(FinishState& s) { s.finish.metallic = s.number_or(1); }
};
struct conserve_energy : item<Kind::ConserveEnergy> {
    static void act(FinishState& s) { s.finish.conserve_energy = true; }
};

struct fresnel : item<Kind::Fresnel> {
    static void act(FinishState& s)
    {
        s.finish.reflection.fresnel = static_cast<int>(s.number_or(1)) != 0;
        s.from_zero = s.finish.reflection.fresnel;
    }
};
struct falloff : item<Kind::Falloff, a_number> {
    static void act(FinishState& s) { s.finish.reflection.falloff = s.pop_single(); }
};
/// Stored as the power that the reflected colour is raised to: 1/e (spec 3, 7.9).
float exponent_of(FinishState& s)
{
    const float e = s.pop_single();
    if (e == 0) s.stream().fail(s.stream().last(), "the reflection's exponent must not be 0");
    return e;
}
struct exponent : item<Kind::Exponent, a_number> {
    static void act(FinishState& s) { s.finish.reflection.exponent = exponent_of(s); }
};
struct reflection_metallic : item<Kind::Metallic> {
    static void act(FinishState& s) { s.finish.reflection.metallic = s.number_or(1); }
};
/// Words of Whittle's own: docs/extensions.md.
struct schlick : item<Kind::WhittleSchlick> {
    static void act(FinishState& s) { s.finish.reflection.fresnel = s.finish.reflection.schlick = s.from_zero = true; }
};
struct gloss : item<Kind::WhittleGloss, a_number> {
    static void act(FinishState& s)
    {
        constexpr float kMostSamples = 4096;
        scene::Reflection& r = s.finish.reflection;
        r.gloss = s.pop_single();
        if (!(r.gloss >= 0)) s.stream().fail(s.stream().last(), "the roughness of a mirror must not be below 0");
        if (!s.stream().accept_comma()) return;
        const float samples = s.number();
        if (!(samples >= 1 && samples <= kMostSamples))
            s.stream().fail(s.stream().last(), "a glossy mirror takes 1 to 4096 rays");
        r.gloss_samples = static_cast<int>(samples);
    }
};
using ReflectionItems = table<FinishState, fresnel, falloff, exponent, reflection_metallic, schlick, gloss>;

struct reflection : item<Kind::Reflection> {
    static void act(FinishState& s)
    {
        scene::Reflection& r = s.finish.reflection;
        if (s.stream().peek().kind != Kind::LeftBrace) {
            r.min = r.max = s.read_rgb();
            r.falloff = 1;
            r.fresnel = false;
            return;
        }
        bool range = false;
        const auto opened = s.build.open_block("reflection");
        if (at_color(s.stream())) {
            r.min = r.max = s.read_rgb();
            s.stream().accept_comma();
            range = at_color(s.stream());
            if (range) r.max = s.read_rgb();
        } else {
            r.min = r.max = glm::vec3(0);
        }
        s.from_zero = false;
        while (ReflectionItems::match(s.build, s)) {}
        if (s.from_zero && !range) r.min = glm::vec3(0);
        s.build.close_block("reflection", opened, [] { return ReflectionItems::words(); });
    }
};
struct polished : item<Kind::WhittlePolished, a_number> {
    static void act(FinishState& s)
    {
        s.finish.polished = s.pop_single();
        if (!(s.finish.polished > 0 && s.finish.polished < 1))
            s.stream().fail(s.stream().last(), "the reflectance of a polished surface must lie between 0 and 1");
    }
};
struct cool_warm : item<Kind::WhittleCoolWarm> {
    static void act(FinishState& s)
    {
        s.finish.cool_warm = true;
        s.finish.cool = s.read_rgb();
        s.stream().accept_comma();
        s.finish.warm = s.read_rgb();
    }
};
struct ink : item<Kind::WhittleInk, a_number> {
    static void act(FinishState& s)
    {
        s.finish.ink = s.pop_single();
        if (!(s.finish.ink >= 0 && s.finish.ink < 45))
            s.stream().fail(s.stream().last(), "the width of ink lines is an angle of view in degrees, 0 to 45");
        if (s.stream().accept_comma()) s.finish.ink_crease_deg = s.number();
    }
};
struct reflection_exponent : item<Kind::ReflectionExponent, a_number> {
    static void act(FinishState& s) { s.finish.reflection.exponent = exponent_of(s); }
};

struct thickness : item<Kind::Thickness, a_number> {
    static void act(FinishState& s) { s.finish.irid_thickness = s.pop_single(); }
};
struct irid_turbulence : item<Kind::Turbulence, a_vector> {
    static void act(FinishState& s) { s.finish.irid_turbulence = static_cast<float>(s.pop_vector().x); }
};
struct irid : item<Kind::Irid> {
    static void act(FinishState& s)
    {
        read_block<table<FinishState, thickness, irid_turbulence>>(s.build, s, "irid",
                                                                   [&] { s.finish.irid = s.number(); });
    }
};
struct subsurface : item<Kind::Subsurface> {
    static void act(FinishState& s) { s.finish.subsurface = read_finish_subsurface(s.build); }
};
/// Keywords that moved to the interior in version 3.1.
template <Kind kind, float scene::Finish::*member>
struct moved : item<kind, a_number> {
    static void act(FinishState& s)
    {
        s.stream().warn(s.stream().last(), std::string(spelling(kind)) + " belongs in an interior");
        s.finish.*member = s.pop_single();
    }
};
using ior = moved<Kind::Ior, &scene::Finish::legacy_ior>;
using caustics = moved<Kind::Caustics, &scene::Finish::legacy_caustics>;
using refraction = moved<Kind::Refraction, &scene::Finish::legacy_refraction>;

using FinishItems =
    table<FinishState, ambient, emission, diffuse, phong, specular, roughness, metallic, conserve_energy, reflection,
          reflection_exponent, irid, subsurface, ior, caustics, refraction, polished, cool_warm, ink,
          number_of<Kind::Brilliance, &scene::Finish::brilliance>, number_of<Kind::Crand, &scene::Finish::crand>,
          number_of<Kind::PhongSize, &scene::Finish::phong_size>>;

}  // namespace

scene::Finish read_finish(SceneBuilder& build, const scene::Finish& before)
{
    FinishState s(build);
    const scene::SourceRef source = build.stream().last();
    float brilliance = 0;
    read_block<FinishItems>(build, s, "finish", [&] {
        const auto declared = build.stream().accept_identifier<std::shared_ptr<const scene::Finish>>();
        s.finish = declared ? **declared : before;
        // What earlier statements made of `albedo` stays, whatever sizes are written here (spec 3, 7.1).
        brilliance = s.finish.brilliance;
        if (std::exchange(s.finish.phong_albedo, false)) s.finish.phong *= scene::phong_of_albedo(s.finish.phong_size);
        if (std::exchange(s.finish.specular_albedo, false))
            s.finish.specular *= scene::specular_of_albedo(s.finish.roughness);
    });
    // Where nothing changes it, it stays as written too: what radiosity gathers goes by that.
    if (s.finish.diffuse_albedo && !s.wrote_diffuse && s.finish.brilliance != brilliance) {
        s.finish.diffuse_albedo = false;
        s.finish.diffuse *= scene::diffuse_of_albedo(brilliance);
        s.finish.diffuse_back *= scene::diffuse_of_albedo(brilliance);
    }
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
