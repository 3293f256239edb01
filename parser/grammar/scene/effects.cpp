#include "parser/grammar/scene/effects.h"

#include "parser/grammar/core/rules.h"
#include "parser/stream/files/file_policy.h"
#include "render/scene/description.h"

#include <fmt/format.h>

/// Blocks of effects: radiosity, photons, subsurface, and what a camera may hold.
namespace parser {
namespace {

using scene::PhotonFlags;
using scene::PhotonSettings;
using scene::RadiositySettings;
using scene::SubsurfaceSettings;

struct RadiosityState : StructState<RadiositySettings> {
    using StructState::StructState;
    std::optional<double> least, most;    // how far samples are used again
    std::vector<std::string_view> files;  // named here, as before version 3.7
    /// A limit that is left out follows the other where they would come too close (spec 6, 4.1).
    void check()
    {
        if (least && most && *most <= *least) fail("'maximum_reuse' must be above 'minimum_reuse'");
        double &low = made.minimum_reuse, &high = made.maximum_reuse;
        low = least.value_or(low);
        high = most.value_or(high);
        if (low > high / 2 && !(least && most)) (least ? high : low) = least ? 2 * low : high / 2;
        for (const std::string_view name : files)
            stream().warn(made.source, fmt::format("{} is ignored: such files are named on the command line", name));
    }
};
/// The second number may be left out.
template <Kind kind, class Limits, auto first, auto second>
struct one_or_two : item<kind, ranged<kind, Limits>, another_number> {
    static void act(RadiosityState& s)
    {
        if (s.operands() == 2) s.made.*second = s.pop_int();
        s.made.*first = s.pop_int();
    }
};
template <Kind kind, class Limits, auto limit>
struct reuse : item<kind, ranged<kind, Limits>> {
    static void act(RadiosityState& s) { s.*limit = s.pop_float(); }
};
template <Kind kind>
struct old_file : item<kind, by_action<a_text>> {
    static void act(RadiosityState& s)
    {
        path_expr(s.stream());
        s.files.push_back(spelling(kind));
    }
};
using RadiosityItems =
    table<RadiosityState, one_or_two<Kind::Count, above<0>, &RadiositySettings::count, &RadiositySettings::pool>,
          one_or_two<Kind::NearestCount, within<1, 20>, &RadiositySettings::nearest_count,
                     &RadiositySettings::adaptive_count>,
          reuse<Kind::MinimumReuse, at_least<0>, &RadiosityState::least>,
          reuse<Kind::MaximumReuse, above<0>, &RadiosityState::most>, old_file<Kind::SaveFile>,
          old_file<Kind::LoadFile>, member<Kind::AdcBailout, &RadiositySettings::adc_bailout, above<0>>,
          number_switch<Kind::AlwaysSample, &RadiositySettings::always_sample>,
          member<Kind::Brightness, &RadiositySettings::brightness, above<0>>,
          member<Kind::ErrorBound, &RadiositySettings::error_bound, above<0>>,
          member<Kind::GrayThreshold, &RadiositySettings::gray_threshold, within<0, 1>>,
          member<Kind::LowErrorFactor, &RadiositySettings::low_error_factor, above<0>>,
          member<Kind::MaxSample, &RadiositySettings::max_sample>,
          number_switch<Kind::Media, &RadiositySettings::media>,
          number_switch<Kind::Normal, &RadiositySettings::normal>,
          member<Kind::PretraceStart, &RadiositySettings::pretrace_start, above<0, 1>>,
          member<Kind::PretraceEnd, &RadiositySettings::pretrace_end, above<0, 1>>,
          member<Kind::RecursionLimit, &RadiositySettings::recursion_limit, within<1, 20>>,
          number_switch<Kind::Subsurface, &RadiositySettings::subsurface>>;
using RadiosityBlock = block<Kind::Radiosity, RadiosityItems>;

using PhotonState = StructState<PhotonSettings>;
/// A map to load must exist; one to save must lie where a scene may write.
struct load_file : item<Kind::LoadFile, by_action<a_text>> {
    static void act(PhotonState& s)
    {
        const scene::SourceRef at = s.stream().here();
        const std::string name = path_expr(s.stream());
        s.made.load_file = s.stream().find_file(name, {});
        if (s.made.load_file.empty()) s.stream().fail(at, fmt::format("cannot find the photon map '{}'", name));
        s.stream().read_files().data(s.made.load_file);
    }
};
struct save_file : item<Kind::SaveFile, by_action<a_text>> {
    static void act(PhotonState& s)
    {
        const scene::SourceRef at = s.stream().here();
        const std::string name = path_expr(s.stream());
        if (!may_write(s.stream().options(), name))
            s.stream().fail(at, fmt::format("a scene may not write to '{}': it lies outside of the current folder and "
                                            "the output's (--allow-write)",
                                            name));
        s.made.save_file = name;
    }
};
using PhotonItems =
    table<PhotonState, load_file, save_file,
          members<Kind::Radius, 0, &PhotonSettings::radius, &PhotonSettings::radius_factor,
                  &PhotonSettings::media_radius, &PhotonSettings::media_radius_factor>,
          members<Kind::Gather, 2, &PhotonSettings::gather_least, &PhotonSettings::gather_most>,
          members<Kind::Media, 1, &PhotonSettings::media_steps, &PhotonSettings::media_factor>,
          members<Kind::ExpandThresholds, 2, &PhotonSettings::expand_increase, &PhotonSettings::expand_least>,
          member<Kind::Spacing, &PhotonSettings::spacing>, member<Kind::Count, &PhotonSettings::count>,
          member<Kind::Autostop, &PhotonSettings::autostop>, member<Kind::Jitter, &PhotonSettings::jitter>,
          member<Kind::AdcBailout, &PhotonSettings::adc_bailout>,
          member<Kind::MaxTraceLevel, &PhotonSettings::max_trace_level>>;
using PhotonBlock = block<Kind::Photons, PhotonItems>;

using SubsurfaceBlock =
    block<Kind::Subsurface,
          table<StructState<SubsurfaceSettings>,
                members<Kind::Samples, 2, &SubsurfaceSettings::diffuse_samples, &SubsurfaceSettings::single_samples>,
                number_switch<Kind::Radiosity, &SubsurfaceSettings::radiosity>>>;

struct FlagState : StructState<PhotonFlags> {
    using StructState::StructState;
    /// An object is not passed straight through and a target that refracts: what is written last wins (spec 6, 3.1).
    void settle(bool passing)
    {
        PhotonFlags& f = made;
        if (f.of_light || !f.pass_through || f.target.value_or(0.0) <= 0.0 || f.refraction == false) return;
        if (!passing && f.refraction == true) f.pass_through = false;
        else f.refraction = false;
    }
};
struct target : item<Kind::Target, number_or<1>> {
    static void act(FlagState& s)
    {
        s.made.target = s.pop_float();
        s.settle(false);
    }
};
struct pass_through : item<Kind::PassThrough, a_flag> {
    static void act(FlagState& s)
    {
        s.made.pass_through = s.pop_flag();
        s.settle(true);
    }
};
template <Kind kind, auto flag>
struct photon_flag : item<kind, a_number> {
    static void act(FlagState& s)
    {
        s.made.*flag = s.pop_int() != 0;
        s.settle(false);
    }
};
using LightFlags = block<Kind::Photons, table<FlagState, photon_flag<Kind::Refraction, &PhotonFlags::refraction>,
                                              photon_flag<Kind::Reflection, &PhotonFlags::reflection>,
                                              word<Kind::AreaLight, &PhotonFlags::area_light>>>;
using ObjectFlags =
    block<Kind::Photons, table<FlagState, target, pass_through, photon_flag<Kind::Refraction, &PhotonFlags::refraction>,
                               photon_flag<Kind::Reflection, &PhotonFlags::reflection>,
                               photon_flag<Kind::Collect, &PhotonFlags::collect>>>;

struct Importance {
    double importance = 0.0;
};
using ImportanceBlock =
    block<Kind::Radiosity,
          table<StructState<Importance>, member<Kind::Importance, &Importance::importance, above<0, 1>>>>;
using FinishSubsurfaceBlock =
    block<Kind::Subsurface,
          table<StructState<scene::Subsurface>, member<Kind::Translucency, &scene::Subsurface::translucency>,
                member<Kind::Anisotropy, &scene::Subsurface::anisotropy>>>;

/// Of a settings block: its source, what is there before, what the block makes of it.
template <class Block, class Settings, class State = StructState<Settings>>
Settings read_settings(SceneBuilder& build, Settings before = {})
{
    State s(build);
    s.made = std::move(before);
    s.made.source = build.stream().last();
    Block::read(build, s);
    return std::move(s.made);
}

}  // namespace

Production global_radiosity_block() { return {"global_radiosity_block", RadiosityBlock::form()}; }
Production global_photons_block() { return {"global_photons_block", PhotonBlock::form()}; }
Production global_subsurface_block() { return {"global_subsurface_block", SubsurfaceBlock::form()}; }
Production light_photons_block() { return {"light_photons_block", LightFlags::form()}; }
Production object_photons_block() { return {"object_photons_block", ObjectFlags::form()}; }
Production object_radiosity_block() { return {"object_radiosity_block", ImportanceBlock::form()}; }
Production finish_subsurface_block() { return {"finish_subsurface_block", FinishSubsurfaceBlock::form()}; }

RadiositySettings read_global_radiosity(SceneBuilder& build)
{
    return read_settings<RadiosityBlock, RadiositySettings, RadiosityState>(build);
}

PhotonSettings read_global_photons(SceneBuilder& build, const PhotonSettings& before)
{
    PhotonSettings settings;
    settings.media_radius = before.media_radius;
    settings.media_radius_factor = before.media_radius_factor;
    settings = read_settings<PhotonBlock>(build, std::move(settings));
    if (settings.gather_least > settings.gather_most)
        build.stream().fail(build.stream().last(), "'gather' takes the smaller number of photons first");
    return settings;
}

SubsurfaceSettings read_global_subsurface(SceneBuilder& build)
{
    return read_settings<SubsurfaceBlock, SubsurfaceSettings>(build);
}

std::shared_ptr<const PhotonFlags> read_photon_flags(SceneBuilder& build, bool of_light, const PhotonFlags* before)
{
    PhotonFlags flags = before != nullptr ? *before : PhotonFlags();
    flags.of_light = of_light;
    const auto read = of_light ? read_settings<LightFlags, PhotonFlags, FlagState>
                               : read_settings<ObjectFlags, PhotonFlags, FlagState>;
    return std::make_shared<const PhotonFlags>(read(build, std::move(flags)));
}

std::optional<double> read_object_radiosity(SceneBuilder& build)
{
    StructState<Importance> s(build);
    ImportanceBlock::read(build, s);
    return s.made.importance > 0.0 ? std::optional(s.made.importance) : std::nullopt;
}

std::shared_ptr<const scene::Subsurface> read_finish_subsurface(SceneBuilder& build)
{
    return std::make_shared<const scene::Subsurface>(read_settings<FinishSubsurfaceBlock, scene::Subsurface>(build));
}

namespace {

using MeshCameraState = StructState<scene::MeshCamera>;
struct mesh_rays : seq<a_number, opt_comma, a_number, opt_comma>, item_base {
    static void act(MeshCameraState& s)
    {
        constexpr int kMostMethods = 3;
        const double method = s.pop_float();
        s.made.rays_per_pixel = s.pop_int();
        if (s.made.rays_per_pixel == 0) s.fail("the rays per pixel of a mesh_camera must not be 0");
        if (!(method >= 0 && method < kMostMethods + 1))
            s.fail("the distribution of a mesh_camera must lie from 0 to 3");
        s.made.distribution = static_cast<scene::MeshCamera::Distribution>(static_cast<int>(method));
    }
};
struct mesh_distance : a_number, item_base {
    static void act(MeshCameraState& s) { s.made.max_distance = s.pop_float(); }
};
template <Kind kind, scene::Object (*read)(SceneBuilder&, const scene::SourceRef&), Production (*inside)()>
struct camera_mesh : item<kind, reads<inside>> {
    static void act(MeshCameraState& s)
    {
        s.made.meshes.push_back(
            {std::make_shared<const scene::Object>(read(s.build, s.stream().last())), spelling(kind)});
        s.stream().accept_comma();
    }
};
struct camera_meshes : pegtl::plus<pegtl::sor<camera_mesh<Kind::Mesh, read_mesh, mesh_block>,
                                              camera_mesh<Kind::Mesh2, read_mesh2, mesh2_block>>> {};
using MeshCameraBlock = block<Kind::MeshCamera, no_items, mesh_rays, opt<mesh_distance, opt_comma>, camera_meshes,
                              opt<word<Kind::Smooth, &scene::MeshCamera::smooth>>>;

struct bokeh_pigment : item<Kind::Pigment, reads<pigment_block>> {
    static void act(StructState<scene::Bokeh>& s)
    {
        s.made.pigment = std::make_shared<const scene::Pigment>(read_pigment(s.build, s.build.default_layer().pigment));
    }
};
using BokehBlock = block<Kind::Bokeh, no_items, opt<bokeh_pigment>>;

}  // namespace

template <>
inline constexpr auto expected<mesh_rays> = "the rays per pixel and the distribution of a mesh_camera (two numbers)";
template <>
inline constexpr auto expected<camera_meshes> = "a mesh";

Production mesh_camera_block() { return {"mesh_camera_block", MeshCameraBlock::form()}; }
Production bokeh_block() { return {"bokeh_block", BokehBlock::form()}; }

std::shared_ptr<const scene::MeshCamera> read_mesh_camera(SceneBuilder& build)
{
    return std::make_shared<const scene::MeshCamera>(read_settings<MeshCameraBlock, scene::MeshCamera>(build));
}

scene::Bokeh read_bokeh(SceneBuilder& build) { return read_settings<BokehBlock, scene::Bokeh>(build); }

}  // namespace parser
