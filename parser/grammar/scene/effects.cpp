#include "parser/grammar/scene/effects.h"

#include "parser/stream/files/file_policy.h"
#include "render/scene/description.h"

#include <fmt/format.h>

/// Blocks of effects: radiosity, photons, subsurface, and what a camera may hold.
namespace parser {
namespace {

using scene::PhotonFlags;
using scene::PhotonSettings;
using scene::RadiositySettings;

/// A file's name that belongs on the command line since version 3.7.
bool read_file_name(BlockReader& s, std::vector<std::string>& names)
{
    const Kind kind = s.next_kind();
    if (!s.accept(Kind::SaveFile) && !s.accept(Kind::LoadFile)) return false;
    path_expr(s.in());
    names.emplace_back(spelling(kind));
    return true;
}

constexpr auto kRadiosityFields = std::tuple(
    field(Kind::AdcBailout, &RadiositySettings::adc_bailout, above(0)),
    number_switch(Kind::AlwaysSample, &RadiositySettings::always_sample),
    field(Kind::Brightness, &RadiositySettings::brightness, above(0)),
    field(Kind::ErrorBound, &RadiositySettings::error_bound, above(0)),
    field(Kind::GrayThreshold, &RadiositySettings::gray_threshold, within(0, 1)),
    field(Kind::LowErrorFactor, &RadiositySettings::low_error_factor, above(0)),
    field(Kind::MaxSample, &RadiositySettings::max_sample), number_switch(Kind::Media, &RadiositySettings::media),
    number_switch(Kind::Normal, &RadiositySettings::normal),
    field(Kind::PretraceStart, &RadiositySettings::pretrace_start, above(0, 1)),
    field(Kind::PretraceEnd, &RadiositySettings::pretrace_end, above(0, 1)),
    field(Kind::RecursionLimit, &RadiositySettings::recursion_limit, within(1, 20)),
    number_switch(Kind::Subsurface, &RadiositySettings::subsurface));

/// `count a, b` and the like: the second number may be left out.
bool read_two(BlockReader& s, Kind keyword, const Range& range, int& first, int& second)
{
    if (!s.accept(keyword)) return false;
    first = whole_number(ranged_number(s.in(), keyword, range, s.in().last()));
    if (more_numbers(s.in())) read_value(s.in(), second);
    return true;
}

/// How far samples are used again: a limit that is left out follows the other where they would come too close (spec
/// 6, 4.1).
struct Reuse {
    std::optional<double> least, most;

    bool read(BlockReader& s)
    {
        if (s.accept(Kind::MinimumReuse)) least = ranged_number(s.in(), Kind::MinimumReuse, at_least(0), s.in().last());
        else if (s.accept(Kind::MaximumReuse))
            most = ranged_number(s.in(), Kind::MaximumReuse, above(0), s.in().last());
        else return false;
        return true;
    }
    void settle(BlockReader& s, RadiositySettings& to) const
    {
        if (least && most && *most <= *least) s.fail("'maximum_reuse' must be above 'minimum_reuse'");
        to.minimum_reuse = least.value_or(to.minimum_reuse);
        to.maximum_reuse = most.value_or(to.maximum_reuse);
        if (to.minimum_reuse <= to.maximum_reuse / 2 || (least && most)) return;
        if (least) to.maximum_reuse = 2 * to.minimum_reuse;
        else to.minimum_reuse = to.maximum_reuse / 2;
    }
};

}  // namespace

RadiositySettings read_global_radiosity(SceneBuilder& build)
{
    BlockReader s(build);
    RadiositySettings settings;
    settings.source = s.source();
    std::vector<std::string> files;
    Reuse reuse;
    s.open();
    while (read_two(s, Kind::Count, above(0), settings.count, settings.pool) ||
           read_two(s, Kind::NearestCount, within(1, 20), settings.nearest_count, settings.adaptive_count) ||
           reuse.read(s) || read_file_name(s, files) || read_one(s, settings, kRadiosityFields)) {}
    reuse.settle(s, settings);
    for (const std::string& name : files)
        s.in().warn(s.source(), name + " is ignored: such files are named on the command line");
    s.close();
    return settings;
}

namespace {

/// The map's files. One to load must exist; one to save must lie where a scene may write.
bool read_map_file(BlockReader& s, PhotonSettings& to)
{
    const bool loads = s.accept(Kind::LoadFile);
    if (!loads && !s.accept(Kind::SaveFile)) return false;
    const scene::SourceRef at = s.in().here();
    const std::string name = path_expr(s.in());
    if (loads) {
        to.load_file = s.in().find_file(name, {});
        if (to.load_file.empty()) s.in().fail(at, fmt::format("cannot find the photon map '{}'", name));
        s.in().data_files().push_back(to.load_file);
        return true;
    }
    if (!may_write(s.in().options(), name))
        s.in().fail(at, fmt::format("a scene may not write to '{}': it lies outside of the current folder and the "
                                    "output's (--allow-write)",
                                    name));
    to.save_file = name;
    return true;
}

}  // namespace

PhotonSettings read_global_photons(SceneBuilder& build, const PhotonSettings& before)
{
    static constexpr auto kFields =
        std::tuple(field(Kind::Spacing, &PhotonSettings::spacing), field(Kind::Count, &PhotonSettings::count),
                   field(Kind::Autostop, &PhotonSettings::autostop), field(Kind::Jitter, &PhotonSettings::jitter),
                   field(Kind::AdcBailout, &PhotonSettings::adc_bailout),
                   field(Kind::MaxTraceLevel, &PhotonSettings::max_trace_level));
    BlockReader s(build);
    PhotonSettings settings;
    settings.media_radius = before.media_radius;
    settings.media_radius_factor = before.media_radius_factor;
    settings.source = s.source();
    s.open();
    for (;;) {
        if (s.accept(Kind::Radius)) {
            for (double* number :
                 {&settings.radius, &settings.radius_factor, &settings.media_radius, &settings.media_radius_factor})
                if (more_numbers(s.in())) read_value(s.in(), *number);
                else break;
        } else if (s.accept(Kind::Gather)) {
            read_values(s.in(), settings.gather_least, settings.gather_most);
        } else if (s.accept(Kind::Media)) {
            read_value(s.in(), settings.media_steps);
            if (more_numbers(s.in())) read_value(s.in(), settings.media_factor);
        } else if (s.accept(Kind::ExpandThresholds)) {
            read_values(s.in(), settings.expand_increase, settings.expand_least);
        } else if (!read_map_file(s, settings) && !read_one(s, settings, kFields)) {
            break;
        }
    }
    s.close();
    if (settings.gather_least > settings.gather_most) s.fail("'gather' takes the smaller number of photons first");
    return settings;
}

scene::SubsurfaceSettings read_global_subsurface(SceneBuilder& build)
{
    BlockReader s(build);
    scene::SubsurfaceSettings settings;
    settings.source = s.source();
    s.open();
    for (;;) {
        if (s.accept(Kind::Samples)) read_values(s.in(), settings.diffuse_samples, settings.single_samples);
        else if (!read_one(s, settings,
                           std::tuple(number_switch(Kind::Radiosity, &scene::SubsurfaceSettings::radiosity))))
            break;
    }
    s.close();
    return settings;
}

namespace {

/// An object is not passed straight through and a target that refracts: what is written last wins (spec 6, 3.1).
void settle_passing(PhotonFlags& flags, Kind written)
{
    if (!flags.pass_through || flags.target.value_or(0.0) <= 0.0 || flags.refraction == false) return;
    if (written == Kind::PassThrough) flags.refraction = false;
    else if (flags.refraction == true) flags.pass_through = false;
    else flags.refraction = false;
}

}  // namespace

std::shared_ptr<const PhotonFlags> read_photon_flags(SceneBuilder& build, bool of_light, const PhotonFlags* before)
{
    static constexpr auto kOfBoth = std::tuple(number_switch(Kind::Refraction, &PhotonFlags::refraction),
                                               number_switch(Kind::Reflection, &PhotonFlags::reflection));
    static constexpr auto kOfObjects = std::tuple(number_switch(Kind::Collect, &PhotonFlags::collect),
                                                  field(Kind::PassThrough, &PhotonFlags::pass_through));
    static constexpr auto kOfLights = std::tuple(word(Kind::AreaLight, &PhotonFlags::area_light));
    BlockReader s(build);
    auto flags = before != nullptr ? std::make_shared<PhotonFlags>(*before) : std::make_shared<PhotonFlags>();
    flags->of_light = of_light;
    flags->source = s.source();
    s.open();
    for (;;) {
        const Kind written = s.next_kind();
        if (!of_light && s.accept(Kind::Target)) flags->target = at_expression(s.in()) ? float_expr(s.in()) : 1.0;
        else if (!read_one(s, *flags, kOfBoth) &&
                 !(of_light ? read_one(s, *flags, kOfLights) : read_one(s, *flags, kOfObjects)))
            break;
        if (!of_light) settle_passing(*flags, written);
    }
    s.close();
    return flags;
}

std::optional<double> read_object_radiosity(SceneBuilder& build)
{
    struct Settings {
        double importance = 0.0;
    } settings;
    BlockReader s(build);
    read_fields(s, settings, std::tuple(field(Kind::Importance, &Settings::importance, above(0, 1))));
    return settings.importance > 0.0 ? std::optional(settings.importance) : std::nullopt;
}

std::shared_ptr<const scene::Subsurface> read_finish_subsurface(SceneBuilder& build)
{
    static constexpr auto kFields = std::tuple(field(Kind::Translucency, &scene::Subsurface::translucency),
                                               field(Kind::Anisotropy, &scene::Subsurface::anisotropy));
    BlockReader s(build);
    auto subsurface = std::make_shared<scene::Subsurface>();
    subsurface->source = s.source();
    read_fields(s, *subsurface, kFields);
    return subsurface;
}

std::shared_ptr<const scene::MeshCamera> read_mesh_camera(SceneBuilder& build)
{
    constexpr int kMostMethods = 3;
    BlockReader s(build);
    auto camera = std::make_shared<scene::MeshCamera>();
    camera->source = s.source();
    s.open();
    double rays = 0.0, method = 0.0;
    read_values(s.in(), rays, method);
    camera->rays_per_pixel = whole_number(rays);
    if (camera->rays_per_pixel == 0) s.fail("the rays per pixel of a mesh_camera must not be 0");
    if (!(method >= 0 && method < kMostMethods + 1)) s.fail("the distribution of a mesh_camera must lie from 0 to 3");
    camera->distribution = static_cast<scene::MeshCamera::Distribution>(static_cast<int>(method));
    s.in().accept_comma();
    if (at_expression(s.in())) read_value(s.in(), camera->max_distance);
    for (;;) {
        s.in().accept_comma();
        const Kind kind = s.next_kind();
        if (s.accept(Kind::Mesh))
            camera->meshes.push_back(
                {std::make_shared<const scene::Object>(read_mesh(build, s.in().last())), spelling(kind)});
        else if (s.accept(Kind::Mesh2))
            camera->meshes.push_back(
                {std::make_shared<const scene::Object>(read_mesh2(build, s.in().last())), spelling(kind)});
        else break;
    }
    if (camera->meshes.empty()) build.fail_unknown("a mesh");
    camera->smooth = s.accept(Kind::Smooth);
    s.close();
    return camera;
}

scene::Bokeh read_bokeh(SceneBuilder& build)
{
    BlockReader s(build);
    scene::Bokeh bokeh{nullptr, s.source()};
    s.open();
    if (s.accept(Kind::Pigment))
        bokeh.pigment = std::make_shared<const scene::Pigment>(read_pigment(build, build.default_layer().pigment));
    s.close();
    return bokeh;
}

}  // namespace parser
