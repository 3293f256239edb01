#include "render/study/ladder.h"

#include "render/study/solver_accuracy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace study {
namespace {

using Settings = std::vector<Setting>;

void add_antialiasing(Settings& out)
{
    out.push_back({"antialiasing", "-A", [](Trial& t) { t.options.antialiasing.method = 0; }, {"-A"}});
    for (int method = 1; method <= 2; ++method)
        for (const double threshold : {0.3, 0.1, 0.03, 0.0})
            for (int depth = 2; depth <= 4; ++depth) {
                // The greatest depth is left out at both ends: few pixels are refined at 0.3, and at 0 nearly all are,
                // at the greatest cost.
                if ((threshold == 0.3 && depth == 4) || (threshold == 0.0 && depth == 4)) continue;
                const std::string name = fmt::format("+A{:g} +AM{} +R{}", threshold, method, depth);
                out.push_back(
                    {fmt::format("antialiasing, method {}", method),
                     name,
                     [=](Trial& t) {
                         t.options.antialiasing.method = method;
                         t.options.antialiasing.threshold = threshold;
                         t.options.antialiasing.depth = depth;
                     },
                     {fmt::format("+A{:g}", threshold), fmt::format("+AM{}", method), fmt::format("+R{}", depth)}});
            }
}

/// POV-Ray 3.8's, which stops by confidence: its threshold is an error, its depth a power of 4.
void add_oversampling(Settings& out)
{
    for (const auto& [threshold, depth] : {std::pair(0.3, 3), std::pair(0.1, 3), std::pair(0.1, 4), std::pair(0.05, 4),
                                           std::pair(0.03, 4), std::pair(0.03, 5), std::pair(0.01, 5)})
        out.push_back({"antialiasing, method 3",
                       fmt::format("+A{:g} +AM3 +R{}", threshold, depth),
                       [error = threshold, power = depth](Trial& t) {
                           t.options.antialiasing.method = 3;
                           t.options.antialiasing.threshold = error;
                           t.options.antialiasing.depth = power;
                       },
                       {fmt::format("+A{:g}", threshold), "+AM3", fmt::format("+R{}", depth), "+AC0.9"},
                       0.0,
                       0.0,
                       true});
}

void add_samples(Settings& out)
{
    for (const std::uint32_t samples : {1u, 4u, 16u, 64u, 256u})
        out.push_back({"samples",
                       fmt::format("--samples={}", samples),
                       [=](Trial& t) {
                           t.options.free_sampling = true;
                           t.goal.samples = samples;
                       },
                       {}});
    for (const double error : {4.0, 2.0, 1.0, 0.5, 0.25})
        out.push_back({"samples where needed",
                       fmt::format("--error={:g}", error),
                       [=](Trial& t) {
                           t.options.free_sampling = true;
                           t.goal.error = error;
                       },
                       {},
                       error});
}

void add_times(Settings& out)
{
    for (const double seconds : {0.3, 1.0})
        out.push_back({"samples in a time",
                       fmt::format("--time={:g}", seconds),
                       [=](Trial& t) {
                           t.options.free_sampling = true;
                           t.goal.seconds = seconds;
                       },
                       {},
                       0.0,
                       seconds});
}

/// The settings below are compared on a picture with smooth edges, so that their own error is seen and not that of the
/// edges. Lamps and lenses stay as the scene gives them.
void smooth(Trial& trial) { trial.goal.samples = 32; }

void add_lamps(Settings& out, const light::LightSet& lights)
{
    if (std::none_of(lights.lights.begin(), lights.lights.end(), [](const light::Light& light) { return light.area; }))
        return;
    for (const int size : {1, 2, 3, 5, 9, 17, 33})
        for (const int adaptive : {100, 1}) {
            if (adaptive == 1 && size < 5) continue;
            const bool all = adaptive > 1;
            out.push_back({all ? "area lights, all lamps" : "area lights, adaptive 1",
                           fmt::format("area_light {0}, {0}{1}", size, all ? "" : " adaptive 1"),
                           [=](Trial& t) {
                               smooth(t);
                               t.compiled = [=](plan::CompiledScene& compiled) {
                                   for (light::Light& light : compiled.lights.lights) {
                                       if (!light.area) continue;
                                       light.size1 = light.size1 > 1 ? size : 1;
                                       light.size2 = light.size2 > 1 ? size : 1;
                                       light.adaptive = adaptive;
                                   }
                               };
                           },
                           {}});
        }
}

void add_lens(Settings& out, const scene::Camera& camera)
{
    if (camera.aperture == 0.0 || camera.blur_samples <= 0) return;
    for (const int samples : {4, 7, 19, 37, 100, 300})
        out.push_back({"lens",
                       fmt::format("blur_samples {}", samples),
                       [=](Trial& t) {
                           t.options.antialiasing.method = 0;  // a lens smooths
                           t.scene.camera.blur_samples = samples;
                           t.scene.camera.blur_fewest = std::min(t.scene.camera.blur_fewest, samples);
                       },
                       {}});
}

void add_depth(Settings& out, const trace::RayCounts& rays)
{
    if (rays.reflected + rays.refracted == 0) return;
    for (const int depth : {1, 2, 3, 5, 8, 12, 20})
        out.push_back({"depth of reflection",
                       fmt::format("max_trace_level {}", depth),
                       [=](Trial& t) {
                           smooth(t);
                           t.scene.global.max_trace_level = depth;
                       },
                       {}});
    for (const double bailout : {0.1, 0.03, 0.01, 0.001})
        out.push_back({"adc_bailout",
                       fmt::format("adc_bailout {:g}", bailout),
                       [=](Trial& t) {
                           smooth(t);
                           t.scene.global.adc_bailout = bailout;
                       },
                       {}});
}

void add_radiosity(Settings& out, const scene::GlobalSettings& global)
{
    if (!global.radiosity) return;
    for (const int count : {10, 35, 100, 300, 1000})
        out.push_back({"radiosity, rays",
                       fmt::format("count {}", count),
                       [=](Trial& t) {
                           smooth(t);
                           t.scene.global.radiosity->count = count;
                       },
                       {}});
    for (const double bound : {3.0, 1.8, 1.0, 0.5, 0.25})
        out.push_back({"radiosity, error_bound",
                       fmt::format("error_bound {:g}", bound),
                       [=](Trial& t) {
                           smooth(t);
                           t.scene.global.radiosity->error_bound = bound;
                       },
                       {}});
    for (const int limit : {1, 2, 3, 5, 8})
        out.push_back({"radiosity, bounces",
                       fmt::format("recursion_limit {}", limit),
                       [=](Trial& t) {
                           smooth(t);
                           t.scene.global.radiosity->recursion_limit = limit;
                       },
                       {}});
}

void add_photons(Settings& out, const scene::GlobalSettings& global)
{
    if (!global.photons || !global.photons->active() || !global.photons->load_file.empty()) return;
    for (const double share : {4.0, 2.0, 1.0, 0.5})
        out.push_back({"photons",
                       fmt::format("spacing times {:g}", share),
                       [=](Trial& t) {
                           smooth(t);
                           t.scene.global.photons->spacing *= share;
                           t.scene.global.photons->count /= share * share;
                       },
                       {}});
}

/// Radiosity and photons, which stand in for light between surfaces: each alone and both together, with more and more
/// samples.
void add_stand_ins(Settings& out, const scene::GlobalSettings& global)
{
    const bool radiosity = global.radiosity.has_value(), photons = global.photons && global.photons->active();
    const auto add = [&](const char* family, bool keeps_radiosity, bool keeps_photons) {
        for (const std::uint32_t samples : {1u, 4u, 16u, 64u})
            out.push_back({family,
                           fmt::format("--samples={}", samples),
                           [=](Trial& t) {
                               t.options.free_sampling = true;
                               t.goal.samples = samples;
                               if (!keeps_radiosity) t.scene.global.radiosity.reset();
                               if (!keeps_photons) t.scene.global.photons.reset();
                           },
                           {}});
    };
    if (radiosity) add("radiosity alone", true, false);
    if (photons) add("photons alone", false, true);
    if (radiosity && photons) add("radiosity and photons", true, true);
}

void add_paths(Settings& out)
{
    for (const double error : {16.0, 8.0, 4.0})
        out.push_back({"paths where needed",
                       fmt::format("--integrator=path --error={:g}", error),
                       [=](Trial& t) {
                           t.options.free_sampling = t.options.paths = true;
                           t.goal.error = error;
                       },
                       {},
                       error});
    for (const bool denoise : {false, true})
        for (const std::uint32_t samples : {1u, 4u, 16u, 64u, 256u, 1024u})
            out.push_back({denoise ? "paths, filtered" : "paths",
                           fmt::format("--integrator=path --samples={}{}", samples, denoise ? " --denoise" : ""),
                           [=](Trial& t) {
                               t.options.free_sampling = t.options.paths = true;
                               t.goal.samples = samples;
                               t.denoise = denoise;
                           },
                           {}});
}

void scale_samples(plan::MediaSet& media, double share)
{
    for (plan::Media& one : media.media) {
        one.samples_least = one.samples_most = std::max(1, static_cast<int>(std::lround(one.samples_least * share)));
        one.enough.clear();
    }
}

void add_media(Settings& out, const plan::MediaSet& media)
{
    if (media.media.empty()) return;
    for (const double share : {0.25, 0.5, 1.0, 2.0, 4.0})
        out.push_back({"media",
                       fmt::format("samples times {:g}", share),
                       [=](Trial& t) {
                           smooth(t);
                           t.compiled = [=](plan::CompiledScene& compiled) { scale_samples(compiled.media, share); };
                       },
                       {}});
}

void add_solvers(Settings& out, const scene::ObjectList& objects)
{
    if (!has_solvers(objects)) return;
    for (const double share : {100.0, 30.0, 10.0, 3.0, 1.0, 0.3, 0.1})
        out.push_back({"accuracy of isosurfaces, parametric surfaces and julia sets",
                       fmt::format("accuracy times {:g}", share),
                       [=](Trial& t) {
                           smooth(t);
                           scale_accuracy(t.scene.objects, share);
                       },
                       {}});
}

}  // namespace

Settings ladder(const scene::Description& scene, const plan::CompiledScene& compiled, const trace::RayCounts& rays,
                bool paths)
{
    Settings out;
    add_antialiasing(out);
    add_oversampling(out);
    add_samples(out);
    add_times(out);
    add_lamps(out, compiled.lights);
    add_lens(out, scene.camera);
    add_depth(out, rays);
    add_radiosity(out, scene.global);
    add_photons(out, scene.global);
    add_media(out, compiled.media);
    add_solvers(out, scene.objects);
    if (paths) {
        for (Setting& setting : out) setting.asked_error = 0.0;  // which is no promise about light that it leaves out
        add_stand_ins(out, scene.global);
        add_paths(out);
    }
    return out;
}

void make_truth(Trial& trial, double error, double seconds, bool paths)
{
    constexpr int kDeep = 15;
    constexpr double kFaint = 1e-3;
    constexpr double kFine = 0.1;  // of the accuracy of solvers
    trial.options.free_sampling = true;
    trial.options.paths = paths;
    trial.goal.error = error;
    trial.goal.seconds = seconds;
    trial.goal.seed = 1;  // none of its samples are those that it judges
    trial.scene.global.max_trace_level = std::max(trial.scene.global.max_trace_level, kDeep);
    trial.scene.global.adc_bailout = std::min(trial.scene.global.adc_bailout, kFaint);
    scale_accuracy(trial.scene.objects, kFine);
}

}  // namespace study
