#include "parser/grammar/core/rules.h"
#include "parser/grammar/scene/effects.h"

/// media, density and rainbow.
namespace parser {
namespace {

using scene::Media;
using scene::Rainbow;

struct ScatteringState : BlockState {
    ScatteringState(SceneBuilder& b, Media::Scattering& to) : BlockState(b), scattering(to) {}
    Media::Scattering& subject() { return scattering; }
    Media::Scattering& scattering;
    scene::SourceRef source = stream().last();
};
/// An unknown type scatters alike in all directions, as POV-Ray has it.
struct scattering_type : seq<a_number, opt_comma>, item_base {
    static void act(ScatteringState& s)
    {
        const int type = s.pop_int();
        const bool known = type >= static_cast<int>(Media::Phase::Isotropic) &&
                           type <= static_cast<int>(Media::Phase::HenyeyGreenstein);
        s.scattering.phase = known ? static_cast<Media::Phase>(type) : Media::Phase::Isotropic;
        if (!known) s.stream().warn(s.source, "this type of scattering is unknown");
    }
};
struct scattering_color : a_rgb, item_base {
    static void act(ScatteringState& s) { s.scattering.color = s.pop_rgb(); }
};
struct eccentricity : item<Kind::Eccentricity, a_number> {
    static void act(ScatteringState& s)
    {
        s.scattering.eccentricity = s.pop_float();
        if (s.scattering.phase != Media::Phase::HenyeyGreenstein) s.fail("'eccentricity' needs scattering of type 5");
    }
};
using ScatteringBlock =
    block<Kind::Scattering,
          table<ScatteringState, eccentricity, member<Kind::Extinction, &Media::Scattering::extinction>>,
          scattering_type, opt<scattering_color>>;
Production scattering_block() { return {"scattering_block", ScatteringBlock::form()}; }

struct MediaState : BlockState {
    using BlockState::BlockState;
    Media& subject() { return media; }
    void take(const std::shared_ptr<const Media>& declared) { media = *declared; }
    void move(const csg::Transform& by) { media.transform(by); }
    Media media = Media::of_version(build.version());
};
/// `scattering` after another keeps what it does not name.
struct scattering : item<Kind::Scattering, reads<scattering_block>> {
    static void act(MediaState& s)
    {
        ScatteringState inner(s.build, s.media.scattering);
        ScatteringBlock::read(s.build, inner);
    }
};
struct density : item<Kind::Density, reads<density_block>> {
    static void act(MediaState& s) { s.media.densities.push_back(read_density(s.build).pigment); }
};
struct method_number {
    static constexpr Range range{1, 3.999};
};
struct method : item<Kind::Method, ranged<Kind::Method, method_number>> {
    static void act(MediaState& s) { s.media.method = static_cast<Media::Method>(s.pop_int()); }
};
struct samples : item<Kind::Samples, a_number, another_number> {
    static void act(MediaState& s)
    {
        const bool two = s.operands() == 2;
        s.media.samples_most = s.pop_int();
        s.media.samples_least = two ? s.pop_int() : s.media.samples_most;
        if (s.media.samples_least < 1) s.fail("media need at least one sample in an interval");
        if (s.media.samples_most < s.media.samples_least)
            s.fail("the most samples in an interval are fewer than the least");
    }
};
struct below_one {
    static constexpr Range range{0, 0.9999999999999999};
};
using MediaItems =
    either<moves,
           table<MediaState, scattering, density, method, samples, member<Kind::Absorption, &Media::absorption>,
                 member<Kind::Emission, &Media::emission>, member<Kind::Intervals, &Media::intervals, at_least<1>>,
                 member<Kind::Confidence, &Media::confidence, below_one>, member<Kind::Variance, &Media::variance>,
                 member<Kind::Ratio, &Media::ratio>, member<Kind::AaLevel, &Media::aa_level, at_least<1>>,
                 member<Kind::AaThreshold, &Media::aa_threshold, above<0>>, member<Kind::Jitter, &Media::jitter>,
                 member<Kind::Collect, &Media::collect>>>;
using MediaBlock = block<Kind::Media, MediaItems, opt<declared<std::shared_ptr<const Media>>>>;

struct RainbowState : BlockState {
    using BlockState::BlockState;
    Rainbow& subject() { return rainbow; }
    void take(const std::shared_ptr<const Rainbow>& declared) { rainbow = *declared; }
    void check()
    {
        constexpr double kParallel = 1e-10;
        if (glm::length(rainbow.direction) == 0.0) fail("this rainbow's direction is zero or missing");
        if (glm::length(glm::cross(rainbow.direction, rainbow.up)) < kParallel)
            fail("this rainbow's up and direction are parallel");
        if (rainbow.arc() < rainbow.falloff()) fail("this rainbow's arc_angle is smaller than its falloff_angle");
    }
    Rainbow rainbow;
};
struct rainbow_colors : item<Kind::ColorMap, reads<color_map_block>> {
    static void act(RainbowState& s) { s.rainbow.colors = read_color_map(s.build); }
};
using RainbowItems = table<RainbowState, rainbow_colors, member<Kind::Direction, &Rainbow::direction>,
                           member<Kind::Angle, &Rainbow::angle_deg>, member<Kind::Width, &Rainbow::width_deg>,
                           member<Kind::Distance, &Rainbow::distance>, member<Kind::Jitter, &Rainbow::jitter>,
                           member<Kind::Up, &Rainbow::up>, member<Kind::ArcAngle, &Rainbow::arc_deg>,
                           member<Kind::FalloffAngle, &Rainbow::falloff_deg>>;
using RainbowBlock = block<Kind::Rainbow, RainbowItems, opt<declared<std::shared_ptr<const Rainbow>>>>;

}  // namespace

template <>
inline constexpr auto expected<scattering_type> = "the type of scattering (a number, 1 to 5)";

Production media_block() { return {"media_block", MediaBlock::form()}; }

Media read_media(SceneBuilder& build)
{
    MediaState s(build);
    const scene::SourceRef source = build.stream().last();
    MediaBlock::read(build, s);
    s.media.source = source;
    return std::move(s.media);
}

Production density_block() { return {"density_block", Form::braces({Form::named(density_body)})}; }

scene::Density read_density(SceneBuilder& build)
{
    const scene::SourceRef opened = build.open_block("density");
    scene::Pigment base;
    base.kind = scene::Color{1, 1, 1, 0, 0};
    scene::Density density{read_density_body(build, base)};
    build.close_block("density", opened);
    return density;
}

Production rainbow_block() { return {"rainbow_block", RainbowBlock::form()}; }

Rainbow read_rainbow(SceneBuilder& build)
{
    RainbowState s(build);
    const scene::SourceRef source = build.stream().last();
    RainbowBlock::read(build, s);
    s.rainbow.source = source;
    return std::move(s.rainbow);
}

}  // namespace parser
