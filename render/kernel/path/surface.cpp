#include "render/kernel/path/surface.h"

#include "numbers/functions/functions.h"
#include "render/texture/evaluate.h"
#include "render/texture/finish.h"
#include "render/texture/fresnel.h"
#include "render/kernel/interior/interface.h"
#include "render/kernel/tile/nearly_zero.h"

#include <algorithm>
#include <cmath>

namespace trace::path {
namespace {

constexpr float kFaint = 1e-5f;  // a layer that is dimmed to less than this shows in no picture

/// Adds the lobes of a layer's diffuse light and highlights. described: the finish; finish: with the sizes that it has
/// here; share: the layer's opacity
void add_own_light(Bsdf& bsdf, const HitContext& hit, const texture::Finish& described, const texture::Finish& finish,
                   const scene::Color& pigment, const glm::dvec3& normal, const glm::vec3& above, float share)
{
    Lobe lobe;
    lobe.finish = &described;
    lobe.pigment = pigment;
    lobe.kind = Lobe::Kind::Diffuse;
    lobe.exponent = static_cast<double>(finish.brilliance);
    const auto add_diffuse = [&](float amount, const glm::dvec3& towards) {
        if (!(amount > 0.0f)) return;
        lobe.normal = towards;
        lobe.color = glm::max(glm::vec3(0), above * pigment.rgb() * (amount * share));
        lobe.albedo = lobe.color * (2.0f / (finish.brilliance + 1.0f));
        bsdf.add(lobe);
    };
    add_diffuse(finish.diffuse, normal);
    add_diffuse(hit.surface.double_illuminate ? finish.diffuse : finish.diffuse_back, -normal);
    const auto add_highlight = [&](Lobe::Kind kind, float amount, float exponent, double albedo) {
        if (!(amount > 0.0f)) return;
        lobe.kind = kind;
        lobe.normal = normal;
        lobe.exponent = static_cast<double>(exponent);
        lobe.color = glm::max(glm::vec3(0), above * amount);
        lobe.albedo = lobe.color * static_cast<float>(albedo);
        bsdf.add(lobe);
    };
    const auto n = static_cast<double>(finish.specular_exponent);
    add_highlight(Lobe::Kind::Phong, finish.phong, finish.phong_size,
                  2.0 / (static_cast<double>(finish.phong_size) + 1.0));
    add_highlight(Lobe::Kind::Specular, finish.specular, finish.specular_exponent,
                  4.0 * (2.0 - numbers::pow(2.0, -n / 2.0)) / (n + 2.0));
}

}  // namespace

/// What the layers so far leave to those below.
struct SurfaceReader::Stack {
    glm::vec3 above{1};      ///< what they let through
    glm::vec3 conserved{1};  ///< the same where what is mirrored is taken off (conserve_energy)
    std::array<Lobe, 8> mirrors;
    std::size_t mirror_count = 0;
    glm::dvec3 top_normal{0};
    bool first = true;
};

void SurfaceReader::read(HitContext& hit, const HitDetails& details, Draws& draws)
{
    out_.bsdf.begin(hit.normal, hit.state.ray.direction);
    out_.emission = glm::vec3(0);
    out_.passes = false;
    out_.normal = hit.normal;
    const SideTextures sides(context_.scene, context_.world, hit.met, details, hit.from_inside,
                             context_.scratch.shade.shares);
    if (sides.size() == 0) return out_.bsdf.finish();
    glm::dvec3 p = hit.surface.pattern_point(details.point, details.uv);
    const texture::Texture& layers = drawn_layers(hit, sides, p, draws);
    Stack stack;
    for (std::uint32_t i = layers.count; i-- > 0 && largest(glm::abs(stack.above)) > kFaint;)
        add_layer(hit, layers, set_.layers[layers.first + i], p, stack);
    out_.normal = stack.top_normal;
    if (largest(stack.above) > kFaint) add_through(hit, stack, draws);
    const bool dielectric = out_.passes && !out_.through.straight;
    for (std::size_t i = 0; i < stack.mirror_count && !dielectric; ++i) out_.bsdf.add(stack.mirrors[i]);
    out_.bsdf.finish();
}

/// Draws one texture of layers at random, by its share in what the hit shows. p is in that texture's space afterwards.
const texture::Texture& SurfaceReader::drawn_layers(HitContext& hit, const SideTextures& sides, glm::dvec3& p,
                                                    Draws& draws)
{
    std::size_t side = 0;
    if (sides.mixed()) {
        double u = draws.one();
        while ((u -= static_cast<double>(sides.share(side))) >= 0.0 && side + 1 < sides.size()) ++side;
    }
    std::uint32_t index = sides.texture(side);
    while (true) {
        const texture::Shown shown = texture::shown_at(set_, index, p, hit.around, hit.enclosing);
        const texture::Texture& texture = shown.texture;
        p = shown.p;
        if (texture.kind == texture::Texture::Kind::Layers) return texture;
        if (texture.kind == texture::Texture::Kind::Average) {
            float weights = 0;
            for (std::uint32_t i = 0; i < texture.count; ++i) weights += set_.keys[texture.first + i];
            double u = draws.one() * static_cast<double>(weights);
            std::uint32_t i = 0;
            for (; i + 1 < texture.count && (u -= static_cast<double>(set_.keys[texture.first + i])) >= 0.0; ++i) {}
            index = set_.children[texture.first + i];
        } else {
            const texture::Blend& blend = shown.blend;
            const bool upper = blend.lower == blend.upper || draws.one() < blend.share;
            index = set_.children[upper ? blend.upper : blend.lower];
        }
    }
}

void SurfaceReader::add_layer(HitContext& hit, const texture::Texture& texture, const texture::Layer& layer,
                              const glm::dvec3& p, Stack& stack)
{
    const texture::Finish& finish = set_.finishes[layer.finish];
    const glm::dvec3 normal =
        layer.normal == texture::kNone
            ? hit.normal
            : glm::normalize(texture::bent_normal(set_, layer.normal, hit.normal, p, hit.around, hit.enclosing));
    if (stack.first) stack.top_normal = normal;
    stack.first = false;
    const scene::Color c = texture::pigment_color(set_, layer.pigment, p, hit.around);
    const float share = texture.plain ? 1.0f : texture::opacity(c, set_.legacy_opacity);
    const bool by_index = finish.fresnel || finish.own_fresnel != 0.0f;
    const double eta = by_index ? fresnel_index(context_.scene.interiors, hit.state.interiors, hit.surface.interior)
                                : 1.0;
    if (finish.own_fresnel != 0.0f || finish.use_alpha) {  // a lobe as light meets it that is mirrored to the viewer
        const glm::dvec3& d = hit.state.ray.direction;
        const auto seen = static_cast<float>(texture::seen_share(finish, d, normal, eta));
        out_.emission += stack.above * c.rgb() * (finish.ambient + finish.emission) * share * seen;
        add_own_light(
            out_.bsdf, hit, finish,
            texture::met_by_light(finish, static_cast<double>(share), d, normal, glm::reflect(d, normal), eta), c,
            normal, stack.above, share);
    } else {
        out_.emission += stack.above * c.rgb() * (finish.ambient + finish.emission) * share;
        add_own_light(out_.bsdf, hit, finish, finish, c, normal, stack.above, share);
    }
    glm::vec3 mirrored(0);
    if (finish.reflects()) {
        mirrored = glm::max(glm::vec3(0), texture::reflectivity(finish, c, hit.state.ray.direction, normal, eta));
        if (!black(mirrored) && stack.mirror_count < stack.mirrors.size()) {
            Lobe& lobe = stack.mirrors[stack.mirror_count++];
            lobe.kind = Lobe::Kind::Mirror;
            lobe.normal = normal;
            lobe.color = lobe.albedo = mirrored;
        }
    }
    const glm::vec3 passed = texture::passed(c);
    stack.above *= passed;
    stack.conserved *= passed;
    if (finish.conserve_energy) stack.conserved *= glm::min(glm::vec3(1), 1.0f - mirrored);
}

/// What is behind the layers: straight on, or through a boundary that mirrors as Fresnel has it, whatever the finish
/// says of reflection.
void SurfaceReader::add_through(HitContext& hit, const Stack& stack, Draws& draws)
{
    Refracted& next = out_.through;
    next.fade = glm::vec3(1);
    next.samples = 0;
    if (!refract(context_, hit, stack.top_normal, 1.0f, next)) return;
    out_.passes = true;
    Lobe lobe;
    lobe.normal = stack.top_normal;
    const glm::vec3 above = glm::clamp(stack.above, glm::vec3(0), glm::vec3(1));
    double mirrored = 0.0;
    if (!next.straight) {
        glm::vec3 hue_of(1);
        double ratio = next.ratio;
        if (next.samples > 0) {
            const int samples = next.samples, i = std::min(static_cast<int>(draws.one() * samples), samples - 1);
            const float nm = wavelength(i, samples);
            hue_of = hue(nm, samples);
            ratio = ratio_at(next.ratio, next.dispersion, nm);
            const Refracted spread = next;
            next.total = !disperse(context_, hit, stack.top_normal, spread, i, next.ray);
        }
        const double cosine = std::abs(glm::dot(stack.top_normal, hit.state.ray.direction));
        mirrored = next.total ? 1.0 : texture::fresnel_share(1.0 / ratio, cosine);
        lobe.kind = Lobe::Kind::Mirror;
        lobe.color = lobe.albedo = glm::vec3(static_cast<float>(mirrored) * largest(above));
        out_.bsdf.add(lobe);
        lobe.color = above * hue_of;
    } else {
        lobe.color = glm::clamp(stack.conserved, glm::vec3(0), glm::vec3(1));
    }
    if (next.total) return;
    lobe.kind = Lobe::Kind::Through;
    lobe.color *= static_cast<float>((1.0 - mirrored) *
                                     static_cast<double>(context_.scene.interiors[hit.surface.interior].transmission));
    lobe.albedo = (next.straight ? lobe.color : above * static_cast<float>(1.0 - mirrored));
    out_.bsdf.add(lobe);
}

}  // namespace trace::path
