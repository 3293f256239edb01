#include "csg/reach.h"
#include "render/trace/shade_context.h"

#include <cmath>

namespace trace {

void InteriorList::remove_first(std::uint32_t interior)
{
    for (std::size_t i = 0; i < head_.count; ++i) {
        if (items_[i] != interior) continue;
        for (std::size_t k = i + 1; k < head_.count; ++k) items_[k - 1] = items_[k];
        --head_.count;
        return;
    }
}

bool InteriorList::holds(std::uint32_t interior) const
{
    for (std::size_t i = 0; i < head_.count; ++i)
        if (items_[i] == interior) return true;
    return false;
}

bool InteriorList::all_hollow(const std::vector<plan::Interior>& interiors) const
{
    if (head_.clouded != 0) return false;
    for (std::size_t i = 0; i < head_.count; ++i)
        if (!interiors[items_[i]].hollow) return false;
    return true;
}

namespace {

/// texture::mix, but where both are infinite (highlights on long normals) that is infinite too, as with POV-Ray: white.
scene::Color mixed(const scene::Color& lower, const scene::Color& upper, double share)
{
    scene::Color out = texture::mix(lower, upper, share);
    for (float scene::Color::*of : {&scene::Color::red, &scene::Color::green, &scene::Color::blue})
        if (std::isinf(lower.*of) && lower.*of == upper.*of) out.*of = lower.*of;
    return out;
}

scene::Color average(Context& context, HitContext& hit, const texture::Texture& texture, const glm::dvec3& p)
{
    const auto& set = context.scene.textures;
    scene::Color sum;
    float weights = 0;
    for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i) {
        const scene::Color c = shade_texture(context, hit, set.children[i], p);
        const float w = set.keys[i];
        weights += w;
        sum = {sum.red + w * c.red, sum.green + w * c.green, sum.blue + w * c.blue, sum.filter + w * c.filter,
               sum.transmit + w * c.transmit};
    }
    return {sum.red / weights, sum.green / weights, sum.blue / weights, sum.filter / weights, sum.transmit / weights};
}

/// The textures of a face's three corners. What weighs less than adc_bailout is left out, the rest as it is (spec 5b, 3.5).
scene::Color corner_blend(Context& context, HitContext& hit, const glm::vec3& weights, const glm::dvec3& p)
{
    const plan::Surface& surface = hit.surface;
    const std::array<std::uint32_t, 3> textures{surface.texture, surface.corner_textures[0], surface.corner_textures[1]};
    scene::Color sum;
    for (std::size_t k = 0; k < 3; ++k) {
        const float w = weights[static_cast<int>(k)];
        if (static_cast<double>(w) < context.scene.settings.adc_bailout) continue;
        hit.enclosing_count = 0;
        const scene::Color c = shade_texture(context, hit, textures[k], p);
        sum = {sum.red + w * c.red, sum.green + w * c.green, sum.blue + w * c.blue, sum.filter + w * c.filter,
               sum.transmit + w * c.transmit};
    }
    return sum;
}

/// The textures of a shape's parts by their shares of the point, left out below adc_bailout like a mesh's.
scene::Color part_blend(Context& context, HitContext& hit, const Hit& where, const glm::dvec3& p)
{
    auto& shares = context.scratch.shade.shares;
    const std::size_t base = shares.size();
    context.world.shares(where, hit.point, shares);
    scene::Color sum;
    for (std::size_t k = base, end = shares.size(); k < end; ++k) {
        const csg::Share share = shares[k];
        if (static_cast<double>(share.weight) < context.scene.settings.adc_bailout) continue;
        const float w = share.weight;
        hit.enclosing_count = 0;
        const scene::Color c = shade_texture(context, hit, context.scene.part_textures[hit.surface.first_part + share.part], p);
        sum = {sum.red + w * c.red, sum.green + w * c.green, sum.blue + w * c.blue, sum.filter + w * c.filter,
               sum.transmit + w * c.transmit};
    }
    shares.resize(base);
    return sum;
}

}  // namespace

scene::Color shade_texture(Context& context, HitContext& hit, std::uint32_t index, const glm::dvec3& p)
{
    const auto& set = context.scene.textures;
    const texture::Texture& texture = set.textures[index];
    if (texture.kind == texture::Texture::Kind::Layers) return shade_layers(context, hit, texture, p);
    if (texture.kind == texture::Texture::Kind::Uv) {
        // Transformations around a uv_mapping item do not reach it.
        const std::size_t enclosing = hit.enclosing_count;
        hit.enclosing_count = 0;
        const glm::dvec3 uv{hit.around.uv.x, hit.around.uv.y, 0.0};
        const scene::Color c = shade_texture(context, hit, set.children[texture.first], uv);
        hit.enclosing_count = enclosing;
        return c;
    }
    const texture::Pattern& pattern = set.patterns[texture.pattern];
    const glm::dvec3 q = texture::warp_point(set, pattern, p);
    // It stays there: normals of neighbours that are looked at later go through its transformations too, as in POV-Ray.
    if (hit.enclosing_count < hit.enclosing.size()) hit.enclosing[hit.enclosing_count++] = index;
    scene::Color c;
    if (texture.kind == texture::Texture::Kind::Average) {
        c = average(context, hit, texture, q);
    } else if (texture.kind == texture::Texture::Kind::Material) {
        c = shade_texture(context, hit, texture::material_at(set, texture, q), q);
    } else {
        const double v = texture::pattern_value(set, pattern, q, hit.around);
        const texture::Blend blend = texture::blend_at(set, texture.first, texture.count, v);
        // The upper one first: a slope in the lower one sees the normal that it leaves (spec 4, 15.1).
        c = shade_texture(context, hit, set.children[blend.upper], q);
        if (blend.lower != blend.upper)
            c = mixed(shade_texture(context, hit, set.children[blend.lower], q), c, blend.share);
    }
    return c;
}

scene::Color shade_hit(Context& context, const RayState& state, const Hit& hit, const HitDetails& details, int level,
                       std::size_t first_light, const LayersAhead* ahead)
{
    const plan::Surface& surface = context.scene.surfaces[hit.surface];
    const bool from_inside = glm::dot(details.normal, state.ray.direction) > 0.0;
    const std::uint32_t texture =
        from_inside && surface.interior_texture != plan::kNone ? surface.interior_texture : surface.texture;
    if (texture == plan::kNone) return {};
    HitContext at{{state, hit, surface, details.point, from_inside ? -details.normal : details.normal, level, from_inside}, first_light, {}};
    at.around = {details.point, at.normal, state.ray.direction, details.uv, true};
    const glm::dvec3 p = surface.uv_mapping ? glm::dvec3(details.uv.x, details.uv.y, 0.0) : details.point;
    if (surface.part_count != 0) return part_blend(context, at, hit, p);
    if (surface.blends() && texture == surface.texture) return corner_blend(context, at, details.weights, p);
    if (ahead != nullptr && ahead->texture == texture) at.ahead = ahead;
    return shade_texture(context, at, texture, p);
}

scene::Color through_hollow(const Context& context, const RayState& state, double length, const scene::Color& color)
{
    return state.interiors.all_hollow(context.scene.interiors) ? through_fog(context, state, length, color) : color;
}

scene::Color trace_ray(Context& context, const RayState& state, bool straight)
{
    const plan::Settings& settings = context.scene.settings;
    if (state.level >= settings.max_trace_level || static_cast<double>(state.weight) < settings.adc_bailout) return {};
    const int level = straight ? state.level : state.level + 1;
    const Hit hit = context.world.nearest(state.ray, state.start, csg::kInfinity, bit(state.kind),
                                          context.scratch.geometry);
    scene::Color color;
    if (hit.found()) {
        if (hit.t > csg::Reach::kFar && context.world.too_far(hit)) ++context.scratch.counts.far;
        auto& stack = context.scratch.shade.lights;
        const std::size_t base = stack.size();
        stack.resize(base + context.scene.lights.lights.size());
        color = shade_hit(context, state, hit, hit_details(context, state.ray, hit), level, base);
        stack.resize(base);
    } else {
        color = sky_color(context, state);
    }
    return through_air(context, state, hit.t, color);
}

}  // namespace trace
