#include "parser/grammar/scene/effects.h"
#include "parser/grammar/core/rules.h"

namespace parser {
namespace {

struct GlobalState : BlockState {
    using BlockState::BlockState;
    scene::GlobalSettings& subject() { return build.description.global; }
};

/// The first one counts; `srgb` colours are read by it from here on.
struct assumed_gamma : item<Kind::AssumedGamma, gamma_curve> {
    static void act(GlobalState& s)
    {
        const scene::GammaCurve gamma = s.pop_curve();
        if (!(gamma.exponent > 0)) s.fail("assumed_gamma must be above 0");
        scene::AssumedGamma& current = s.stream().language().assumed_gamma;
        if (!current) current = gamma;
        else s.warn("assumed_gamma was set before; the first one stays");
    }
};
using charset_name = any_token<Kind::Ascii, Kind::Utf8, Kind::Sys>;
struct charset : item<Kind::Charset, charset_name> {
    static void act(GlobalState& s)
    {
        const Kind name = s.stream().taken_last().kind;
        s.stream().language().charset = name == Kind::Utf8    ? Charset::Utf8
                                        : name == Kind::Ascii ? Charset::Ascii
                                                              : Charset::System;
    }
};
struct hf_gray_16 : item<Kind::HfGray16, by_action<a_flag>> {
    static void act(GlobalState& s)
    {
        s.warn("hf_gray_16 has no effect");
        optional_flag(s.stream());
    }
};
struct max_intersections : item<Kind::MaxIntersections, a_number> {
    static void act(GlobalState& s)
    {
        s.pop_float();
        if (s.build.version() >= 370) s.warn("'max_intersections' has no effect");
    }
};
constexpr int kMostLevels = 256;
struct max_trace_level : item<Kind::MaxTraceLevel, a_number> {
    static void act(GlobalState& s)
    {
        int level = s.pop_int();
        if (level < 1) level = 1;
        if (level > kMostLevels) {
            s.warn("max_trace_level is limited to 256");
            level = kMostLevels;
        }
        s.subject().max_trace_level = level;
    }
};
struct noise_generator : item<Kind::NoiseGenerator, a_number> {
    static void act(GlobalState& s)
    {
        const int generator = s.pop_int();
        if (generator < 1 || generator > 3) s.fail("noise_generator must be 1, 2 or 3");
        s.subject().noise_generator = generator;
        s.build.noise_generator_given = true;
    }
};
struct number_of_waves : item<Kind::NumberOfWaves, a_number> {
    static void act(GlobalState& s)
    {
        const int waves = s.pop_int();
        if (waves < 1) s.warn("number_of_waves must be above 0; 1 is used");
        s.subject().number_of_waves = waves < 1 ? 1 : waves;
    }
};
/// Takes the place of an earlier block, which stays the one that is told of.
template <class Settings>
void replace(std::optional<Settings>& present, Settings settings)
{
    if (present) settings.source = present->source;
    present = std::move(settings);
}
struct global_radiosity : item<Kind::Radiosity, reads<global_radiosity_block>> {
    static void act(GlobalState& s) { replace(s.subject().radiosity, read_global_radiosity(s.build)); }
};
struct global_photons : item<Kind::Photons, reads<global_photons_block>> {
    static void act(GlobalState& s)
    {
        replace(s.subject().photons,
                read_global_photons(s.build, s.subject().photons.value_or(scene::PhotonSettings{})));
    }
};
struct global_subsurface : item<Kind::Subsurface, reads<global_subsurface_block>> {
    static void act(GlobalState& s) { replace(s.subject().subsurface, read_global_subsurface(s.build)); }
};

using scene::GlobalSettings;
using OldSettings = table<GlobalState, max_trace_level, max_intersections>;
using GlobalItems =
    either<table<GlobalState, assumed_gamma, charset, hf_gray_16, noise_generator, number_of_waves, global_radiosity,
                 global_photons, global_subsurface, member<Kind::AdcBailout, &GlobalSettings::adc_bailout>,
                 member<Kind::AmbientLight, &GlobalSettings::ambient_light>,
                 member<Kind::IridWavelength, &GlobalSettings::irid_wavelength>,
                 member<Kind::MmPerUnit, &GlobalSettings::mm_per_unit>>,
           OldSettings>;
using GlobalBlock = block<Kind::GlobalSettings, GlobalItems>;

}  // namespace

template <>
inline constexpr auto expected<charset_name> = "'ascii', 'utf8' or 'sys'";

Production global_settings_block() { return {"global_settings_block", GlobalBlock::form()}; }

void read_global_settings(SceneBuilder& build)
{
    GlobalState s(build);
    GlobalBlock::read(build, s);
}

Production old_setting() { return {"old_setting", OldSettings::form()}; }

bool read_old_setting(SceneBuilder& build)
{
    TokenStream& in = build.stream();
    const Kind kind = in.peek().kind;
    if (kind != Kind::MaxTraceLevel && kind != Kind::MaxIntersections) return false;
    GlobalState s(build);
    if (kind == Kind::MaxTraceLevel && build.version() >= 350)
        in.warn(in.here(), "'max_trace_level' belongs in global_settings");
    return OldSettings::match(build, s);
}

}  // namespace parser
