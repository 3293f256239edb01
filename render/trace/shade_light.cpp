#include "render/trace/area_shadow.h"
#include "render/trace/random.h"
#include "render/trace/shade_context.h"
#include "render/trace/shade_light.h"

#include <cmath>

namespace trace {
namespace {

bool dark(const glm::vec3& c) { return std::abs(c.x) < kDark && std::abs(c.y) < kDark && std::abs(c.z) < kDark; }

/// The light's colour with all that shadows it; found once per hit and light.
const glm::vec3& shadowed(Context& context, const HitContext& hit, const light::Light& light, LightSample& sample)
{
    if (!sample.shadow_known) {
        sample.shadowed = light.area ? area_shadow(context, hit, light, sample.lit)
                                     : point_shadow(context, hit, light, sample.lit, sample.lit.color, light.atmosphere);
        sample.shadow_known = true;
    }
    return sample.shadowed;
}

/// What one light adds to a layer (spec 3, 7.4, from its second step on).
struct Layer {
    const texture::Finish& finish;
    const scene::Color& pigment;
    const glm::dvec3& normal;
    double alpha;
};

/// The next random number of `crand` here, one for every light of every layer, in [0, 1]. Of the point and how many came before, or under
/// Options::grain_stream POV-Ray's own stream (spec 3, 17.2).
double grain(Context& context, HitContext& hit)
{
    if (!context.scene.options.grain_stream) return random_at(hit.point, hit.grains++);
    std::uint32_t& state = context.scratch.grain_state;
    state = state * 1812433253u + 12345u;
    return static_cast<double>(state) / 4294967295.0;
}

glm::vec3 contribution(Context& context, HitContext& hit, const Layer& layer, const light::Light& light,
                       const light::Illumination& lit, const glm::vec3& color, bool behind)
{
    const texture::Finish& finish = layer.finish;
    const double less = finish.crand > 0.0f ? static_cast<double>(finish.crand) * grain(context, hit) : 0.0;
    const LitLayer met{finish, layer.pigment, hit.state.ray.direction, layer.normal, layer.alpha};
    const double strength = behind || light.shadowless ? 0.0 : highlight(met, lit.direction);
    glm::vec3 sum = surface_light(met, lit.direction, color, behind, strength, less);
    if (finish.irid > 0.0f) sum *= film_color(context, hit, finish, layer.normal, lit.direction);
    return sum;
}

/// area_illumination: every node is a light of its own under one common shadow (spec 3, 12.7).
glm::vec3 from_area(Context& context, HitContext& hit, const Layer& layer, const light::Light& light,
                    const glm::vec3& shadow)
{
    glm::vec3 sum(0);
    const float share = 1.0f / static_cast<float>(light.size1 * light.size2);
    for (int j = 0; j < light.size2; ++j)
        for (int i = 0; i < light.size1; ++i) {
            const glm::dvec3 offset = light::node_offset(light, hit.point, i, j);
            const light::Illumination lit = light::illuminate(light, hit.point, offset);
            const bool behind = glm::dot(layer.normal, lit.direction) < kNearlyZero && !hit.surface.double_illuminate;
            if (behind && layer.finish.diffuse_back == 0.0f) continue;
            // `shadow` is the unattenuated colour behind its shadow; the node's own cone and fading dim it.
            glm::vec3 color = shadow * share;
            for (int k = 0; k < 3; ++k)
                if (light.color[k] != 0.0f) color[k] *= lit.color[k] / light.color[k];
            sum += contribution(context, hit, layer, light, lit, color, behind);
        }
    return sum;
}

}  // namespace

glm::vec3 direct_light(Context& context, HitContext& hit, const texture::Finish& finish, const scene::Color& pigment,
                       const glm::dvec3& normal, double alpha)
{
    const auto& lights = context.scene.lights.lights;
    const int quality = context.scene.settings.quality;
    const Layer layer{finish, pigment, normal, alpha};
    glm::vec3 sum(0);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const light::Light& light = lights[i];
        if (!shines_on(light, hit.surface)) continue;
        LightSample& sample = context.scratch.shade.lights[hit.lights + i];
        if (!sample.illuminated) {
            sample.lit = light::illuminate(light, hit.point);
            sample.illuminated = true;
        }
        if (!light.area_illumination && dark(sample.lit.color)) continue;
        bool behind = false;
        if (!hit.surface.double_illuminate && !light.area_illumination &&
            glm::dot(normal, sample.lit.direction) < kNearlyZero) {
            if (finish.diffuse_back == 0.0f) continue;
            behind = true;
        }
        glm::vec3 color = light.area_illumination ? light.color : sample.lit.color;
        if (quality >= 4 && (!light.shadowless || light.projector)) color = shadowed(context, hit, light, sample);
        if (!(std::abs(color.x) > kDark || std::abs(color.y) > kDark || std::abs(color.z) > kDark)) continue;
        sum += light.area_illumination ? from_area(context, hit, layer, light, color)
                                       : contribution(context, hit, layer, light, sample.lit, color, behind);
    }
    return sum;
}

}  // namespace trace
