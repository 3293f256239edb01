#include "render/texture/finish.h"
#include "render/trace/shade_context.h"

#include <algorithm>
#include <cmath>

namespace trace {
namespace {

constexpr std::size_t kMostLayers = 32;  // plan/ refuses more

/// A layer's mirror, remembered until all layers have been visited.
struct Mirror {
    glm::vec3 reflectivity;
    glm::dvec3 normal;
    float weight;
    const texture::Finish* finish;
};

/// The layer's normal, bent by the layer and carried through the patterns around it (spec 3, section 4). Of unit length, but within
/// texture maps with no_bump_scale: there it is as long as their transformations make it, and lit so.
glm::dvec3 layer_normal(Context& context, HitContext& hit, std::uint32_t normal, const glm::dvec3& p)
{
    if (normal == texture::kNone || context.scene.settings.quality < 8) return hit.normal;
    const auto& set = context.scene.textures;
    glm::dvec3 n = hit.normal;
    const auto around = [&](std::size_t i) -> const texture::Texture& { return set.textures[hit.enclosing[i]]; };
    for (std::size_t i = 0; i < hit.enclosing_count; ++i)
        n = texture::normal_into(set, set.patterns[around(i).pattern], n, around(i).no_bump_scale);
    n = glm::normalize(texture::perturb(set, normal, n, p, hit.around));
    for (std::size_t i = hit.enclosing_count; i-- > 0;)
        n = texture::normal_out_of(set, set.patterns[around(i).pattern], n, around(i).no_bump_scale);
    return n;
}

glm::vec3 mirrored_light(Context& context, const HitContext& hit, const Mirror& mirror)
{
    glm::dvec3 direction;
    scene::Color c = reflected(context, hit, mirror.normal, mirror.weight, direction);
    if (mirror.finish->irid > 0.0f)
        c = scene::Color::of(c.rgb() * film_color(context, hit, *mirror.finish, mirror.normal, direction));
    return mirror.reflectivity * raised(c, mirror.finish->reflection_power);
}

/// State while going down the layers (spec 3, section 6).
struct Stack {
    glm::vec3 result{0}, filter{1};
    float residual = 1;
    glm::dvec3 top_normal{0};
    std::array<Mirror, kMostLayers> mirrors;
    std::size_t count = 0;
};

/// The pigment of a texture's i-th layer.
scene::Color pigment_of(const Context& context, const HitContext& hit, const texture::Texture& texture, std::uint32_t i, const glm::dvec3& p)
{
    if (hit.ahead != nullptr) return hit.ahead->of(i);
    const auto& set = context.scene.textures;
    return texture::pigment_color(set, set.layers[texture.first + i].pigment, p, hit.around);
}

void add_layer(Context& context, HitContext& hit, const texture::Texture& texture, std::uint32_t index, const glm::dvec3& p, Stack& stack)
{
    const auto& set = context.scene.textures;
    const plan::Settings& settings = context.scene.settings;
    const texture::Layer& layer = set.layers[texture.first + index];
    const texture::Finish& finish = set.finishes[layer.finish];
    const glm::dvec3 normal = layer_normal(context, hit, layer.normal, p);
    if (stack.count == 0) stack.top_normal = normal;
    const scene::Color c = pigment_of(context, hit, texture, index, p);

    Mirror& mirror = stack.mirrors[stack.count++];
    mirror = {glm::vec3(0), normal, 0.0f, &finish};
    if (settings.quality < 2) {
        stack.result = c.rgb();
    } else {
        if (finish.reflects()) {
            const double eta = finish.fresnel ? fresnel_index(context, hit) : 1.0;
            mirror.reflectivity = texture::reflectivity(finish, c, hit.state.ray.direction, normal, eta);
            const float strength = finish.fresnel ? largest(mirror.reflectivity)
                                                  : std::max(largest(finish.reflection_max),
                                                             largest(finish.reflection_min));
            mirror.weight = hit.state.weight * stack.residual * std::max(0.0f, strength);
        }
        const float alpha = texture::opacity(c, set.legacy_opacity);
        glm::vec3 sum = c.rgb() * (finish.ambient + finish.emission) * alpha;
        if (finish.lit()) sum += direct_light(context, hit, finish, c, normal, static_cast<double>(alpha));
        stack.result += stack.filter * sum;
    }
    stack.filter *= c.filter * c.rgb() + c.transmit;
    if (finish.conserve_energy) stack.filter *= glm::min(glm::vec3(1.0f), 1.0f - mirror.reflectivity);
    stack.residual = std::min(1.0f, std::abs(scene::grey(stack.filter)));
}

/// The plain case by itself: one layer that lets no light through and mirrors none.
scene::Color shade_plain(Context& context, HitContext& hit, const texture::Texture& texture, const glm::dvec3& p)
{
    const auto& set = context.scene.textures;
    const texture::Finish& finish = set.finishes[set.layers[texture.first].finish];
    const scene::Color c = pigment_of(context, hit, texture, 0, p);
    glm::vec3 sum = c.rgb() * (finish.ambient + finish.emission);
    if (finish.lit()) sum += direct_light(context, hit, finish, c, hit.normal, 1.0);
    return scene::Color::of(sum);
}

}  // namespace

glm::vec3 raised(const scene::Color& c, float exponent)
{
    if (exponent == 1.0f) return c.rgb();
    const auto one = [e = static_cast<double>(exponent)](float v) {
        const double r = std::pow(static_cast<double>(v), e);
        return r == r ? static_cast<float>(r) : 0.0f;  // fractional powers of negative colours count as 0
    };
    return {one(c.red), one(c.green), one(c.blue)};
}

scene::Color shade_layers(Context& context, HitContext& hit, const texture::Texture& texture, const glm::dvec3& p)
{
    const plan::Settings& settings = context.scene.settings;
    if (texture.plain && settings.quality >= 2) return shade_plain(context, hit, texture, p);
    const auto bailout = static_cast<float>(settings.adc_bailout);
    Stack stack;
    for (std::uint32_t i = texture.count; i-- > 0 && stack.residual > bailout;)
        add_layer(context, hit, texture, i, p, stack);

    scene::Color out;
    bool total = false;
    if (stack.residual > bailout && settings.quality >= 6) {
        const glm::vec3 magnitude = glm::abs(stack.filter);
        const scene::Color behind = transmitted(context, hit, stack.top_normal,
                                                hit.state.weight * largest(magnitude), *stack.mirrors[0].finish, total);
        stack.result += total ? behind.rgb() : behind.rgb() * stack.filter;
        if (!total) out.transmit = behind.transmit * stack.residual;
    }
    if (settings.quality >= 8)
        for (std::size_t i = 0; i < stack.count; ++i) {
            const Mirror& mirror = stack.mirrors[i];
            if (black(mirror.reflectivity)) continue;
            // Total reflection has already sent this ray.
            const glm::dvec3 off = glm::abs(mirror.normal - stack.top_normal);
            if (total && off.x <= kNearlyZero && off.y <= kNearlyZero && off.z <= kNearlyZero) continue;
            stack.result += mirrored_light(context, hit, mirror);
        }
    out.red = stack.result.x;
    out.green = stack.result.y;
    out.blue = stack.result.z;
    return out;
}

}  // namespace trace
