#include "render/plan/camera_starts.h"
#include "render/plan/sampling/free_sampling.h"
#include "render/plan/compiled_scene.h"
#include "render/plan/textures/compile_subsurface.h"
#include "render/plan/geometry/geometry.h"
#include "render/plan/sampling/path_scene.h"
#include "render/plan/traits/find_traits.h"
#include "render/plan/turn_camera.h"

#include <fmt/format.h>

#include <algorithm>

namespace plan {
namespace {

Settings settings(const scene::Description& description, const Options& options)
{
    Settings s;
    s.max_trace_level = description.global.max_trace_level;
    s.adc_bailout = description.global.adc_bailout;
    s.ambient_light = description.global.ambient_light;
    s.quality = options.quality;
    s.alpha = options.alpha;
    s.assumed_gamma = description.global.assumed_gamma;
    return s;
}

/// Null where the scene asks for none, or the quality has none (spec 6, 1.5). After the lights.
std::shared_ptr<const Radiosity> radiosity(const scene::Description& description, const CompiledScene& scene)
{
    if (!has_radiosity(description.global, scene.options.quality)) return nullptr;
    auto out = std::make_shared<Radiosity>();
    out->settings = *description.global.radiosity;
    out->importance = static_cast<float>(description.default_importance);
    out->lights = scene.lights;
    for (light::Light& light : out->lights.lights) {
        light.area = light.area_illumination = light.circular = light.orient = light.jitter = false;
        light.size1 = light.size2 = 1;
        light.atmosphere = light.atmosphere && out->settings.media;
    }
    return out;
}

/// What has no end has no size either.
csg::Tolerance tolerance(const CompiledScene& scene)
{
    if (scene.options.faithful) return {};
    csg::Aabb seen = scene.geometry.bvh.bounds;
    if (!seen.finite()) return {};
    seen.include(scene.camera.location);
    const glm::dvec3 edges = seen.upper - seen.lower;
    return csg::Tolerance::of_scene(glm::max(edges.x, glm::max(edges.y, edges.z)));
}

/// Lights ask for what dims them in the air only where something does.
void clear_air(CompiledScene& out)
{
    const bool fog_shows = out.options.quality.effects;
    const bool dims = (!out.fogs.empty() && fog_shows) || out.atmosphere.extinguishes;
    const bool asks = dims || (!out.options.lean.takes(LeanStep::ClearAir) && (out.fogs.empty() || fog_shows));
    std::uint64_t clear = 0;
    for (light::Light& light : out.lights.lights) {
        clear += light.atmosphere && !asks ? 1 : 0;
        light.atmosphere = light.atmosphere && asks;
    }
    if (clear != 0)
        out.decisions.push_back({fmt::format("what dims {} light{} in the air left out", clear, clear == 1 ? "" : "s"),
                                 "neither fog nor media fill the scene",
                                 {},
                                 LeanStep::ClearAir});
}

/// What depends on where the camera stands, after all else.
void follow_camera(CompiledScene& out)
{
    out.tolerance = tolerance(out);
    find_camera_interiors(out);
    out.traits = find_traits(out);
}

/// `planned` is called when no object is asked for any more.
template <class Planned>
CompiledScene compile_all(const scene::Description& description, const Options& options, int threads, Planned&& planned)
{
    CompiledScene out;
    out.options = options;
    out.geometry.faithful = options.faithful;
    out.geometry.shadow_kinds = bit(RayKind::Shadow);
    out.camera = description.camera;
    out.camera.povray = description.povray;
    out.mesh_camera = compile_mesh_camera(out.camera);
    out.settings = settings(description, options);
    std::vector<scene::Unsupported> notes = description.unsupported;
    TextureCompiler textures(description, options.quality, out.textures, notes);
    MediaCompiler media(textures, options.quality, options.lean.takes(LeanStep::BlackMedia), description.povray,
                        out.media);
    GeometryCompiler geometry(description, options, textures, media, out, notes);
    geometry.expect(description.objects.size());
    for (const scene::Object& object : description.objects) geometry.add(object);
    planned();
    if (options.free_sampling) {
        for (light::Light& light : out.lights.lights) free_light(light);
        free_lens(out.camera);
    }
    if (const auto& by = description.camera.functions)
        for (std::size_t i = 0; i < 6; ++i)
            if (const auto& one = i < 3 ? by->location[i] : by->direction[i - 3])
                out.camera_functions[i] = textures.function(one);
    if (description.camera.normal) out.camera_normal = textures.normal(*description.camera.normal, false);
    if (description.camera.bokeh && description.camera.bokeh->pigment)
        out.bokeh = textures.pigment(*description.camera.bokeh->pigment);
    out.sky = compile_sky(description, textures, options.alpha);
    out.fogs = compile_fogs(description);
    out.rainbows = compile_rainbows(description, textures);
    std::vector<std::shared_ptr<const scene::Media>> atmosphere;
    for (const scene::Media& one : description.media) atmosphere.push_back(std::make_shared<const scene::Media>(one));
    out.atmosphere = media.list(atmosphere);
    geometry.finish(threads);
    out.subsurface = compile_subsurface(description, options.quality, out.interiors);
    clear_air(out);
    if (media.dropped() != 0)
        out.decisions.push_back({fmt::format("media of {} interiors or the whole scene left out", media.dropped()),
                                 "they neither glow nor dim",
                                 {},
                                 LeanStep::BlackMedia});
    out.radiosity = radiosity(description, out);
    follow_camera(out);
    for (const scene::Unsupported& note : notes)
        out.decisions.push_back({note.what, "not rendered yet", scene::place_text(description.place(note.source))});
    return out;
}

}  // namespace

CompiledScene compile(const scene::Description& description, const Options& options, int threads)
{
    if (options.paths) return compile(scene::Description(description), options, threads);
    return compile_all(description, options, threads, [] {});
}

CompiledScene compile(scene::Description&& description, const Options& options, int threads)
{
    if (options.paths) prepare_for_paths(description);
    return compile_all(description, options, threads, [&] { description.objects.clear(); });
}

void turn_camera(CompiledScene& scene, const scene::Camera& camera)
{
    const scene::PovRay povray = scene.camera.povray;
    scene.camera = camera;
    scene.camera.povray = povray;
    if (scene.options.free_sampling) free_lens(scene.camera);
    scene.camera_interiors.clear();
    scene.start_holders.clear();
    follow_camera(scene);
}

std::string explain(const CompiledScene& scene)
{
    const csg::WorldData& world = scene.geometry;
    std::string text = fmt::format("kept: {} objects as {} items ({} CSG programs, {} outside the hierarchy), {} "
                                   "surfaces, {} textures, {} lights\n",
                                   scene.objects.size(), world.items.size(), world.programs.size(),
                                   world.unbounded.size(), scene.surfaces.size(), scene.textures.textures.size(),
                                   scene.lights.lights.size());
    for (const Decision& d : scene.decisions) {
        if (!d.place.empty()) text += d.place + ": ";
        text += fmt::format("{}: {}\n", d.what, d.why);
    }
    return text;
}

}  // namespace plan
