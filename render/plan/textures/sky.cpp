#include "render/plan/textures/textures.h"

namespace plan {

texture::Sky compile_sky(const scene::Description& scene, TextureCompiler& textures, bool alpha_output)
{
    texture::Sky out;
    out.alpha_output = alpha_output;
    out.legacy = scene.effective_version < 370;
    out.background = scene.background;
    scene::Color& b = out.background;
    if (scene.background_before_37 || (out.legacy && alpha_output)) {
        b.filter = 0.0f;
        b.transmit = alpha_output ? 1.0f : 0.0f;
    } else if (!alpha_output) {
        const float share = 1.0f - b.transmit;
        b = scene::Color::of(b.rgb() * share);
    }
    if (!scene.sky_sphere) return out;
    out.emission = scene.sky_sphere->emission;
    for (const scene::Pigment& layer : scene.sky_sphere->layers) out.layers.push_back(textures.pigment(layer));
    return out;
}

std::vector<texture::Fog> compile_fogs(const scene::Description& scene)
{
    constexpr double kInactive = 1e-10;  // a distance below it switches the fog off
    std::vector<texture::Fog> out;
    for (const scene::Fog& from : scene.fogs) {
        if (!(from.distance > kInactive || from.distance < -kInactive)) continue;
        texture::Fog to;
        to.ground = from.type == 2;
        to.turbulent = from.turbulence.amount != glm::dvec3(0);
        to.distance = from.distance;
        to.offset = from.offset;
        to.altitude = from.altitude;
        to.turb_depth = from.turb_depth;
        to.color = from.color;
        to.turbulence = from.turbulence;
        to.up = from.up;
        out.push_back(to);
    }
    return out;
}

std::vector<texture::Rainbow> compile_rainbows(const scene::Description& scene, TextureCompiler& textures)
{
    std::vector<texture::Rainbow> out;
    for (const scene::Rainbow& from : scene.rainbows) {
        if (from.colors.empty() || from.width_deg == 0.0 || from.distance == 0.0) continue;
        texture::Rainbow to;
        to.antisolar = glm::normalize(from.direction);
        to.right = glm::normalize(glm::cross(from.up, to.antisolar));
        to.up = glm::normalize(glm::cross(to.antisolar, glm::cross(from.up, to.antisolar)));
        to.angle = glm::radians(from.angle_deg);
        to.width = glm::radians(from.width_deg);
        to.arc = from.arc();
        to.falloff = from.falloff();
        to.distance = from.distance;
        to.jitter = from.jitter;
        to.first = textures.color_map(from.colors);
        to.count = static_cast<std::uint32_t>(from.colors.size());
        to.blending = from.colors.blending;
        out.push_back(to);
    }
    return out;
}

}  // namespace plan
