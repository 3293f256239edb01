#include "render/texture/finish.h"
#include "render/texture/noise/noise.h"
#include "numbers/random.h"
#include "render/kernel/interior/interface.h"
#include "render/kernel/light/direct_light.h"
#include "render/kernel/tile/nearly_zero.h"
#include "render/plan/shines_on.h"
#include "render/kernel/light/shade_light.h"
#include "render/kernel/record/recorder.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace trace {
namespace {

/// The next random number of `crand` here, one for every light of every layer, in [0, 1]. Of the point and how many
/// came before, or under Options::grain_stream POV-Ray's own stream (spec 3, 17.2).
double grain(Context& context, const ScalarRow& row)
{
    if (!context.scene.options.grain_stream) return numbers::random_at(row.hit.point, row.grains++);
    std::uint32_t& state = context.scratch.grain_state;
    state = state * 1812433253u + 12345u;
    return static_cast<double>(state) / 4294967295.0;
}

/// Shirley, Smits, Hu and Lafortune, "A practitioners' assessment of light reflection models" (1997): what a polish
/// mirrors does not reach the matte ground, on the way in and on the way out; ground and mirror together keep all
/// light.
double polished_share(double reflectance, double to_viewer, double to_light)
{
    const auto enters = [](double cosine) {
        const double away = 1.0 - std::clamp(cosine, 0.0, 1.0), square = away * away;
        return 1.0 - square * square * away;
    };
    return 21.0 / 20.0 * (1.0 - reflectance) * enters(to_viewer) * enters(to_light);
}

/// Gooch, Gooch, Shirley and Cohen, "A non-photorealistic lighting model for automatic technical illustration" (1998).
glm::vec3 tone(const ScalarRow& row, const texture::FinishExtension& tones, const glm::dvec3& l)
{
    constexpr float kOfCool = 0.25f, kOfWarm = 0.5f;  // of the pigment in both tones, as they have it
    const auto share = static_cast<float>(0.5 * (1.0 + glm::dot(row.normal, l)));
    const glm::vec3 own = row.pigment.rgb();
    return static_cast<float>(row.alpha) *
           (share * (tones.warm + kOfWarm * own) + (1.0f - share) * (tones.cool + kOfCool * own));
}

/// What of a contribution is diffuse light, for a recorder.
[[gnu::noinline]] void record_diffuse_part(const Context& context, const ScalarRow& row, const LitLayer& met,
                                           const glm::dvec3& l, const glm::vec3& color, bool behind,
                                           double less) noexcept
{
    if (context.scratch.shade.recorder == nullptr) return;
    glm::vec3 part = surface_light(met, l, color, behind, 0.0, less);
    if (row.finish.irid > 0.0f) part *= film_color(context, row.hit, row.finish, row.normal, l);
    tell<&Recorder::scalar_diffuse>(context.scratch.shade, part);
}

glm::vec3 contribution(Context& context, const ScalarRow& row, const light::Light& light,
                       const light::Illumination& lit, const glm::vec3& color, bool behind)
{
    std::optional<texture::Finish> own;
    if (row.finish.own_fresnel != 0.0f || row.finish.use_alpha) {
        const double eta = fresnel_index(context.scene.interiors, row.hit.state.interiors, row.hit.surface.interior);
        own = texture::met_by_light(row.finish, row.alpha, row.hit.state.ray.direction, row.normal, lit.direction, eta);
    }
    const texture::Finish& finish = own ? *own : row.finish;
    const double less = finish.crand > 0.0f ? static_cast<double>(finish.crand) * grain(context, row) : 0.0;
    const LitLayer met{finish, row.pigment, row.hit.state.ray.direction, row.normal, row.alpha};
    const double strength = behind || light.shadowless || context.bounce > 0 ? 0.0 : highlight(met, lit.direction);
    glm::vec3 sum = surface_light(met, lit.direction, color, behind, strength, less);
    if (finish.irid > 0.0f) sum *= film_color(context, row.hit, finish, row.normal, lit.direction);
    record_diffuse_part(context, row, met, lit.direction, color, behind, less);
    return sum;
}

/// area_illumination: every node is a light of its own under one common shadow (spec 3, 12.7).
glm::vec3 from_area(Context& context, const ScalarRow& row, const light::Light& light, const glm::vec3& shadow)
{
    glm::vec3 sum(0);
    for (int j = 0; j < light.size2; ++j)
        for (int i = 0; i < light.size1; ++i) {
            const glm::dvec3 offset = light::node_offset(light, row.hit.point, i, j);
            const light::Illumination lit = light::illuminate(light, row.hit.point, offset);
            const bool behind = glm::dot(row.normal, lit.direction) < kNearlyZero && !row.hit.surface.double_illuminate;
            if (behind && row.finish.diffuse_back == 0.0f) continue;
            sum += contribution(context, row, light, lit, node_color(light, lit, shadow), behind);
        }
    return sum;
}

/// What one light adds that reaches the surface.
glm::vec3 of_light(Context& context, const ScalarRow& row, const light::Light& light, const LightSample& sample)
{
    bool behind = false;
    if (!row.hit.surface.double_illuminate && !light.area_illumination &&
        glm::dot(row.normal, sample.lit.direction) < kNearlyZero) {
        if (row.finish.diffuse_back == 0.0f) return glm::vec3(0);
        behind = true;
    }
    if (dark(sample.arriving)) return glm::vec3(0);
    return light.area_illumination ? from_area(context, row, light, sample.arriving)
                                   : contribution(context, row, light, sample.lit, sample.arriving, behind);
}

/// Whether a light may reach the surface at all.
bool reaches(const ScalarRow& row, const light::Light& light, const LightSample& sample)
{
    return shines_on(light, row.hit.surface) && (light.area_illumination || !dark(sample.lit.color));
}

/// Direct light by the formulas of docs/extensions.md, apart so that the others are not longer for it.
[[gnu::noinline]] glm::vec3 extended_light(Context& context, const ScalarRow& row)
{
    const auto& lights = context.lights.lights;
    const texture::FinishExtension& extension = context.scene.textures.extensions[row.finish.extension];
    const double to_viewer = -glm::dot(row.hit.state.ray.direction, row.normal);
    texture::Finish ground = row.finish;
    glm::vec3 sum(0);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const light::Light& light = lights[i];
        const LightSample& sample = row.samples[i];
        if (!reaches(row, light, sample)) continue;
        if (extension.cool_warm) {
            sum += sample.lit.color * tone(row, extension, sample.lit.direction);
            tell<&Recorder::scalar_lamp>(context.scratch.shade, i, sum);
            continue;
        }
        ground.diffuse = row.finish.diffuse *
                         static_cast<float>(polished_share(static_cast<double>(extension.polished), to_viewer,
                                                           glm::dot(row.normal, sample.lit.direction)));
        sum += of_light(context, {row.hit, ground, row.pigment, row.normal, row.alpha, row.samples, row.grains}, light,
                        sample);
        tell<&Recorder::scalar_lamp>(context.scratch.shade, i, sum);
    }
    return sum;
}

}  // namespace

glm::vec3 direct_light(Context& context, const ScalarRow& row)
{
    if (row.finish.own_light && row.finish.extension != texture::kNone &&
        context.scene.textures.extensions[row.finish.extension].own_light()) [[unlikely]]
        return extended_light(context, row);
    const auto& lights = context.lights.lights;
    glm::vec3 sum(0);
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (reaches(row, lights[i], row.samples[i])) {
            sum += of_light(context, row, lights[i], row.samples[i]);
            tell<&Recorder::scalar_lamp>(context.scratch.shade, i, sum);
        }
    return sum;
}

glm::vec3 film_color(const Context& context, const HitPlace& hit, const texture::Finish& finish,
                     const glm::dvec3& normal, const glm::dvec3& l)
{
    const auto& set = context.scene.textures;
    auto h = static_cast<double>(finish.irid_thickness);
    if (finish.irid_turbulence != 0.0f) {
        const double b = texture::scalar_turbulence(hit.point, 5, 2.0, 0.5, set.noise_generator);
        h *= 1.0 + static_cast<double>(finish.irid_turbulence) * (2.0 * b - 1.0);
    }
    const double cos_view = std::abs(glm::dot(normal, hit.state.ray.direction));
    return texture::film(finish, h, std::abs(glm::dot(normal, l)), cos_view, set.irid_wavelength);
}

}  // namespace trace
