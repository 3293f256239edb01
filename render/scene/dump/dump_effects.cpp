#include "render/scene/effects.h"
#include "render/scene/media.h"
#include "render/scene/mesh_camera.h"
#include "render/scene/rainbow.h"

#include <string>

/// What these blocks say beside what is usual.
namespace scene {
namespace {

/// A colour that is not black.
void color(DumpWriter& out, std::string_view name, const glm::vec3& rgb)
{
    if (rgb != glm::vec3(0)) out.words(name, Color::of(rgb));
}
void yes(DumpWriter& out, std::string_view name, bool v, bool usual = false)
{
    if (v != usual) out.words(name, v ? 1 : 0);
}
template <class Value>
void written(DumpWriter& out, std::string_view name, const std::optional<Value>& v)
{
    if (v) out.words(name, *v);
}
void written(DumpWriter& out, std::string_view name, const std::optional<bool>& v)
{
    if (v) out.words(name, *v ? 1 : 0);
}

void dump_scattering(DumpWriter& out, const Media::Scattering& s)
{
    if (s.color == glm::vec3(0)) return;
    const Media::Scattering usual;
    out.word("scattering");
    out.open("scattering");
    out.words("-", static_cast<int>(s.phase), Color::of(s.color));
    out.changed("eccentricity", s.eccentricity, usual.eccentricity);
    out.changed("extinction", s.extinction, usual.extinction);
    out.close();
}

}  // namespace

void Media::dump(DumpWriter& out) const
{
    const Media usual;
    out.open("media");
    color(out, "absorption", absorption);
    color(out, "emission", emission);
    dump_scattering(out, scattering);
    out.changed("method", static_cast<int>(method), static_cast<int>(usual.method));
    out.changed("intervals", intervals, usual.intervals);
    if (samples_most != samples_least) out.words("samples", samples_least, samples_most);
    else out.changed("samples", samples_least, usual.samples_least);
    out.changed("confidence", confidence, usual.confidence);
    out.changed("variance", variance, usual.variance);
    out.changed("ratio", ratio, usual.ratio);
    out.changed("aa_level", aa_level, usual.aa_level);
    out.changed("aa_threshold", aa_threshold, usual.aa_threshold);
    out.changed("jitter", jitter, usual.jitter);
    yes(out, "collect", collect, usual.collect);
    for (const Pigment& density : densities) {
        out.word("density");
        out.open("density");
        out.word("-");
        scene::dump(out, density);
        out.close();
    }
    out.close();
}

void Rainbow::dump(DumpWriter& out) const
{
    const Rainbow usual;
    out.open("rainbow");
    out.words("direction", direction);
    out.changed("angle", angle_deg, usual.angle_deg);
    out.changed("width", width_deg, usual.width_deg);
    out.changed("distance", distance, usual.distance);
    out.changed("jitter", jitter, usual.jitter);
    out.changed("up", up, usual.up);
    written(out, "arc_angle", arc_deg);
    written(out, "falloff_angle", falloff_deg);
    if (!colors.empty()) {
        out.open("color_map");
        for (const auto& entry : colors) out.words("entry", entry.key, entry.value);
        out.close();
    }
    out.close();
}

void RadiositySettings::dump(DumpWriter& out) const
{
    const RadiositySettings usual;
    out.open("radiosity");
    out.changed("adc_bailout", adc_bailout, usual.adc_bailout);
    yes(out, "always_sample", always_sample);
    out.changed("brightness", brightness, usual.brightness);
    if (pool != 0) out.words("count", count, pool);
    else out.changed("count", count, usual.count);
    out.changed("error_bound", error_bound, usual.error_bound);
    out.changed("gray_threshold", gray_threshold, usual.gray_threshold);
    out.changed("low_error_factor", low_error_factor, usual.low_error_factor);
    out.changed("max_sample", max_sample, usual.max_sample);
    out.changed("maximum_reuse", maximum_reuse, usual.maximum_reuse);
    yes(out, "media", media);
    out.changed("minimum_reuse", minimum_reuse, usual.minimum_reuse);
    if (adaptive_count != 0) out.words("nearest_count", nearest_count, adaptive_count);
    else out.changed("nearest_count", nearest_count, usual.nearest_count);
    yes(out, "normal", normal);
    out.changed("pretrace_start", pretrace_start, usual.pretrace_start);
    out.changed("pretrace_end", pretrace_end, usual.pretrace_end);
    out.changed("recursion_limit", recursion_limit, usual.recursion_limit);
    yes(out, "subsurface", subsurface);
    out.close();
}

void PhotonSettings::dump(DumpWriter& out) const
{
    const PhotonSettings usual;
    out.open("photons");
    const bool of_media = media_radius != usual.media_radius || media_radius_factor != usual.media_radius_factor;
    if (of_media) out.words("radius", radius, radius_factor, media_radius, media_radius_factor);
    else if (radius_factor != usual.radius_factor) out.words("radius", radius, radius_factor);
    else out.changed("radius", radius, usual.radius);
    out.changed("spacing", spacing, usual.spacing);
    out.changed("count", count, usual.count);
    if (gather_least != usual.gather_least || gather_most != usual.gather_most)
        out.words("gather", gather_least, gather_most);
    if (media_factor != usual.media_factor) out.words("media", media_steps, media_factor);
    else out.changed("media", media_steps, usual.media_steps);
    out.changed("autostop", autostop, usual.autostop);
    out.changed("jitter", jitter, usual.jitter);
    written(out, "adc_bailout", adc_bailout);
    written(out, "max_trace_level", max_trace_level);
    if (expand_increase != usual.expand_increase || expand_least != usual.expand_least)
        out.words("expand_thresholds", expand_increase, expand_least);
    if (!load_file.empty()) out.line("load_file", load_file);
    if (!save_file.empty()) out.line("save_file", save_file);
    out.close();
}

void SubsurfaceSettings::dump(DumpWriter& out) const
{
    const SubsurfaceSettings usual;
    out.open("subsurface");
    if (diffuse_samples != usual.diffuse_samples || single_samples != usual.single_samples)
        out.words("samples", diffuse_samples, single_samples);
    yes(out, "radiosity", radiosity);
    out.close();
}

void PhotonFlags::dump(DumpWriter& out) const
{
    out.open("photons");
    written(out, "target", target);
    written(out, "refraction", refraction);
    written(out, "reflection", reflection);
    yes(out, "collect", collect, true);
    yes(out, "pass_through", pass_through);
    if (area_light) out.word("area_light");
    out.close();
}

void Subsurface::dump(DumpWriter& out) const
{
    out.open("subsurface");
    color(out, "translucency", translucency);
    color(out, "anisotropy", anisotropy);
    out.close();
}

void MeshCamera::dump(DumpWriter& out) const
{
    out.open("mesh_camera");
    out.words("-", rays_per_pixel, static_cast<int>(distribution));
    out.changed("max_distance", max_distance, 0.0);
    for (const Member& member : meshes) {
        out.word(member.keyword);
        scene::dump(out, *member.object);
    }
    if (smooth) out.word("smooth");
    out.close();
}

}  // namespace scene
