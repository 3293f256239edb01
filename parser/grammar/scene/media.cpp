#include "parser/grammar/scene/effects.h"

/// media, density and rainbow.
namespace parser {
namespace {

using scene::Media;
using scene::Rainbow;

constexpr double kMostConfidence = 0.9999999999999999;  // any below 1
constexpr auto kMediaFields = std::tuple(
    field(Kind::Absorption, &Media::absorption), field(Kind::Emission, &Media::emission),
    field(Kind::Intervals, &Media::intervals, at_least(1)),
    field(Kind::Confidence, &Media::confidence, within(0, kMostConfidence)), field(Kind::Variance, &Media::variance),
    field(Kind::Ratio, &Media::ratio), field(Kind::AaLevel, &Media::aa_level, at_least(1)),
    field(Kind::AaThreshold, &Media::aa_threshold, above(0)), field(Kind::Jitter, &Media::jitter),
    field(Kind::Collect, &Media::collect));

constexpr auto kRainbowFields =
    std::tuple(field(Kind::Direction, &Rainbow::direction), field(Kind::Angle, &Rainbow::angle_deg),
               field(Kind::Width, &Rainbow::width_deg), field(Kind::Distance, &Rainbow::distance),
               field(Kind::Jitter, &Rainbow::jitter), field(Kind::Up, &Rainbow::up),
               field(Kind::ArcAngle, &Rainbow::arc_deg), field(Kind::FalloffAngle, &Rainbow::falloff_deg));

/// An unknown type scatters alike in all directions, as POV-Ray has it.
Media::Phase phase_of(int type)
{
    const bool known = type >= static_cast<int>(Media::Phase::Isotropic) &&
                       type <= static_cast<int>(Media::Phase::HenyeyGreenstein);
    return known ? static_cast<Media::Phase>(type) : Media::Phase::Isotropic;
}

/// `scattering` after another keeps what it does not name.
Media::Scattering read_scattering(SceneBuilder& build, Media::Scattering scattering)
{
    BlockReader s(build);
    s.open();
    const int type = whole_number(float_expr(s.in()));
    scattering.phase = phase_of(type);
    s.in().accept_comma();
    if (at_color(s.in())) read_value(s.in(), scattering.color);
    if (static_cast<int>(scattering.phase) != type) s.in().warn(s.source(), "this type of scattering is unknown");
    for (;;) {
        if (s.accept(Kind::Eccentricity)) {
            read_value(s.in(), scattering.eccentricity);
            if (scattering.phase != Media::Phase::HenyeyGreenstein) s.fail("'eccentricity' needs scattering of type 5");
        } else if (s.accept(Kind::Extinction)) {
            read_value(s.in(), scattering.extinction);
        } else {
            break;
        }
    }
    s.close();
    return scattering;
}

bool read_media_item(BlockReader& s, Media& media)
{
    if (s.accept(Kind::Scattering)) {
        media.scattering = read_scattering(s.build(), media.scattering);
    } else if (s.accept(Kind::Density)) {
        media.densities.push_back(read_density(s.build()).pigment);
    } else if (s.accept(Kind::Method)) {
        media.method = static_cast<Media::Method>(
            whole_number(ranged_number(s.in(), Kind::Method, within(1, 3.999), s.in().last())));
    } else if (s.accept(Kind::Samples)) {
        read_value(s.in(), media.samples_least);
        media.samples_most = media.samples_least;
        if (more_numbers(s.in())) read_value(s.in(), media.samples_most);
        if (media.samples_least < 1) s.fail("media need at least one sample in an interval");
        if (media.samples_most < media.samples_least)
            s.fail("the most samples in an interval are fewer than the least");
    } else if (const auto transform = read_transformation(s.build())) {
        media.transform(*transform);
    } else {
        return read_one(s, media, kMediaFields);
    }
    return true;
}

}  // namespace

Media read_media(SceneBuilder& build)
{
    const auto guard = build.stream().nest();
    BlockReader s(build);
    Media media = Media::of_version(build.version());
    s.open();
    if (const auto declared = s.in().accept_identifier<std::shared_ptr<const Media>>()) media = **declared;
    media.source = s.source();
    while (read_media_item(s, media)) {}
    s.close();
    return media;
}

scene::Density read_density(SceneBuilder& build)
{
    const scene::SourceRef opened = build.open_block("density");
    scene::Pigment base;
    base.kind = scene::Color{1, 1, 1, 0, 0};
    scene::Density density{read_density_body(build, base)};
    build.close_block("density", opened);
    return density;
}

Rainbow read_rainbow(SceneBuilder& build)
{
    const auto guard = build.stream().nest();
    BlockReader s(build);
    Rainbow rainbow;
    s.open();
    if (const auto declared = s.in().accept_identifier<std::shared_ptr<const Rainbow>>()) rainbow = **declared;
    rainbow.source = s.source();
    for (;;) {
        if (s.accept(Kind::ColorMap)) rainbow.colors = read_color_map(build);
        else if (!read_one(s, rainbow, kRainbowFields)) break;
    }
    constexpr double kParallel = 1e-10;
    if (glm::length(rainbow.direction) == 0.0) s.fail("this rainbow's direction is zero or missing");
    if (glm::length(glm::cross(rainbow.direction, rainbow.up)) < kParallel)
        s.fail("this rainbow's up and direction are parallel");
    if (rainbow.arc() < rainbow.falloff()) s.fail("this rainbow's arc_angle is smaller than its falloff_angle");
    s.close();
    return rainbow;
}

}  // namespace parser
