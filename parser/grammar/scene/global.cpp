#include "parser/grammar/scene/effects.h"
#include "parser/grammar/core/rules.h"

namespace parser {
namespace {

struct GlobalState : BlockState {
    using BlockState::BlockState;
    scene::GlobalSettings& global() { return build.description.global; }
};

struct adc_bailout : item<Kind::AdcBailout, a_number> {
    static void act(GlobalState& s) { s.global().adc_bailout = s.pop_float(); }
};
struct ambient_light : item<Kind::AmbientLight> {
    static void act(GlobalState& s) { s.global().ambient_light = parser::rgb_expr(s.stream()).rgb(); }
};
/// The first one counts; `srgb` colours are read by it from here on.
struct assumed_gamma : item<Kind::AssumedGamma> {
    static void act(GlobalState& s)
    {
        scene::AssumedGamma gamma;
        if (s.stream().accept(Kind::Srgb)) {
            gamma.kind = scene::AssumedGamma::Kind::Srgb;
        } else {
            read_rule<a_number>(s.build, s);
            gamma = {scene::AssumedGamma::Kind::Power, s.pop_float()};
            if (!(gamma.exponent > 0)) s.stream().fail(s.stream().last(), "assumed_gamma must be above 0");
        }
        scene::AssumedGamma& current = s.stream().language().assumed_gamma;
        if (current.kind == scene::AssumedGamma::Kind::Unset) current = gamma;
        else s.stream().warn(s.stream().last(), "assumed_gamma was set before; the first one stays");
    }
};
struct charset : item<Kind::Charset> {
    static void act(GlobalState& s)
    {
        TokenStream& in = s.stream();
        Charset& charset = in.language().charset;
        if (in.accept(Kind::Utf8)) charset = Charset::Utf8;
        else if (in.accept(Kind::Ascii)) charset = Charset::Ascii;
        else if (in.accept(Kind::Sys)) charset = Charset::System;
        else in.fail_expected("'ascii', 'utf8' or 'sys'");
    }
};
struct hf_gray_16 : item<Kind::HfGray16> {
    static void act(GlobalState& s)
    {
        s.stream().warn(s.stream().last(), "hf_gray_16 has no effect");
        optional_flag(s.stream());
    }
};
struct irid_wavelength : item<Kind::IridWavelength> {
    static void act(GlobalState& s) { s.global().irid_wavelength = parser::rgb_expr(s.stream()).rgb(); }
};
struct max_intersections : item<Kind::MaxIntersections, a_number> {
    static void act(GlobalState& s)
    {
        s.pop_float();
        if (s.build.version() >= 370) s.stream().warn(s.stream().last(), "'max_intersections' has no effect");
    }
};
constexpr int kMostLevels = 256;
struct max_trace_level : item<Kind::MaxTraceLevel, a_number> {
    static void act(GlobalState& s)
    {
        int level = s.pop_int();
        if (level < 1) level = 1;
        if (level > kMostLevels) {
            s.stream().warn(s.stream().last(), "max_trace_level is limited to 256");
            level = kMostLevels;
        }
        s.global().max_trace_level = level;
    }
};
struct mm_per_unit : item<Kind::MmPerUnit, a_number> {
    static void act(GlobalState& s) { s.global().mm_per_unit = s.pop_float(); }
};
struct noise_generator : item<Kind::NoiseGenerator, a_number> {
    static void act(GlobalState& s)
    {
        const int generator = s.pop_int();
        if (generator < 1 || generator > 3) s.stream().fail(s.stream().last(), "noise_generator must be 1, 2 or 3");
        s.global().noise_generator = generator;
        s.build.noise_generator_given = true;
    }
};
struct number_of_waves : item<Kind::NumberOfWaves, a_number> {
    static void act(GlobalState& s)
    {
        const int waves = s.pop_int();
        if (waves < 1) s.stream().warn(s.stream().last(), "number_of_waves must be above 0; 1 is used");
        s.global().number_of_waves = waves < 1 ? 1 : waves;
    }
};
/// Takes the place of an earlier block, which stays the one that is told of.
template <class Settings>
void replace(std::optional<Settings>& present, Settings settings)
{
    if (present) settings.source = present->source;
    present = std::move(settings);
}
struct global_radiosity : item<Kind::Radiosity> {
    static void act(GlobalState& s) { replace(s.global().radiosity, read_global_radiosity(s.build)); }
};
struct global_photons : item<Kind::Photons> {
    static void act(GlobalState& s)
    {
        replace(s.global().photons, read_global_photons(s.build, s.global().photons.value_or(scene::PhotonSettings{})));
    }
};
struct global_subsurface : item<Kind::Subsurface> {
    static void act(GlobalState& s) { replace(s.global().subsurface, read_global_subsurface(s.build)); }
};

using GlobalItems = table<GlobalState, adc_bailout, ambient_light, assumed_gamma, charset, hf_gray_16, irid_wavelength,
                          max_intersections, max_trace_level, mm_per_unit, noise_generator, number_of_waves,
                          global_radiosity, global_photons, global_subsurface>;

}  // namespace

void read_global_settings(SceneBuilder& build)
{
    GlobalState s(build);
    read_block<GlobalItems>(build, s, "global_settings");
}

bool read_old_setting(SceneBuilder& build)
{
    TokenStream& in = build.stream();
    const Kind kind = in.peek().kind;
    if (kind != Kind::MaxTraceLevel && kind != Kind::MaxIntersections) return false;
    GlobalState s(build);
    if (kind == Kind::MaxTraceLevel && build.version() >= 350)
        in.warn(in.here(), "'max_trace_level' belongs in global_settings");
    return table<GlobalState, max_trace_level, max_intersections>::match(build, s);
}

}  // namespace parser
