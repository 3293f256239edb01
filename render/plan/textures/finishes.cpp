#include "numbers/functions/functions.h"
#include "render/plan/textures/compile_subsurface.h"
#include "render/plan/textures/textures.h"
#include "render/scene/base/albedo.h"


namespace plan {

std::uint32_t TextureCompiler::finish(const scene::Shared<scene::Finish>& description)
{
    const scene::Finish& from = *description;
    const auto [known, fresh] = known_finishes_.emplace(&from, static_cast<std::uint32_t>(out_.finishes.size()));
    if (!fresh) return known->second;
    texture::Finish to;
    if (ambient_) to.ambient = from.ambient * scene_.global.ambient_light;
    else to.ambient = glm::vec3(0);
    to.emission = from.emission;
    to.diffuse = from.diffuse;
    to.diffuse_back = from.diffuse_back;
    to.gathered = from.diffuse;
    to.gathered_back = from.diffuse_back;
    to.brilliance = from.brilliance;
    to.crand = from.crand;
    to.phong = from.phong;
    to.phong_size = from.phong_size;
    to.specular = from.specular;
    to.specular_exponent = scene::specular_exponent(from.roughness);
    to.metallic = from.metallic;
    if (from.diffuse_albedo) {
        to.diffuse *= scene::diffuse_of_albedo(from.brilliance);
        to.diffuse_back *= scene::diffuse_of_albedo(from.brilliance);
    }
    if (from.phong_albedo) to.phong *= scene::phong_of_albedo(from.phong_size);
    if (from.specular_albedo) to.specular *= scene::specular_of_albedo(from.roughness);
    to.reflection_min = from.reflection.min;
    to.reflection_max = from.reflection.max;
    to.reflection_falloff = from.reflection.falloff;
    to.reflection_power = from.reflection.exponent == 1.0f ? 1.0f : 1.0f / from.reflection.exponent;
    to.reflection_metallic = from.reflection.metallic;
    to.fresnel = from.reflection.fresnel;
    to.conserve_energy = from.conserve_energy;
    to.own_fresnel = from.fresnel;
    to.use_alpha = from.use_alpha;
    to.legacy_opacity = out_.legacy_opacity;
    to.irid = from.irid;
    to.irid_thickness = from.irid_thickness;
    to.irid_turbulence = from.irid_turbulence;
    if (from.subsurface && has_subsurface(scene_.global, quality_)) {
        to.subsurface = true;
        to.subsurface_diffuse = from.diffuse;
        to.translucency = from.subsurface->translucency;
        to.diffuse = to.diffuse_back = 0.0f;
        if (scene_.global.subsurface->radiosity) to.gathered = to.gathered_back = 0.0f;  // it comes from below as well
    }
    extend(from, to);
    out_.finishes.push_back(to);
    return known->second;
}

void TextureCompiler::extend(const scene::Finish& from, texture::Finish& to)
{
    to.schlick = from.reflection.schlick;
    to.tint_by_half = scene_.povray == scene::PovRay::V38 && to.metallic > 0.0f && to.specular > 0.0f;
    to.own_light = to.own_fresnel != 0.0f || to.use_alpha || (to.tint_by_half && to.phong > 0.0f);  // two tints
    const bool gloss = from.reflection.gloss > 0.0f;
    if (!gloss && from.polished == 0.0f && !from.cool_warm && from.ink == 0.0f) return;
    texture::FinishExtension extension;
    if (gloss) {
        extension.gloss_exponent = 1.0f / from.reflection.gloss;
        extension.gloss_samples = from.reflection.gloss_samples;
    }
    if (from.polished > 0.0f) {  // Schlick's law between its two ends, whatever the finish says of mirrors
        extension.polished = from.polished;
        to.reflection_min = glm::vec3(from.polished);
        to.reflection_max = glm::vec3(1.0f);
        to.reflection_falloff = 5.0f;
        to.fresnel = false;
    }
    extension.cool_warm = from.cool_warm;
    extension.cool = from.cool;
    extension.warm = from.warm;
    extension.ink = glm::radians(static_cast<double>(from.ink));
    extension.ink_cosine = numbers::cos(glm::radians(static_cast<double>(from.ink_crease_deg)));
    to.own_light = to.own_light || extension.own_light() || extension.ink > 0.0;
    to.extension = static_cast<std::uint32_t>(out_.extensions.size());
    out_.extensions.push_back(extension);
}

}  // namespace plan
