#include "render/explain/tree_parts.h"

#include "render/kernel/interior/interior_fade.h"
#include "render/texture/finish.h"
#include "render/kernel/light/shade_light.h"
#include "render/kernel/light/surface_filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace explain {
namespace {

constexpr double kAway = 1e-10;  // cosines below it face away from a light
constexpr float kNoLight = 1e-10f;

bool lightless(const glm::vec3& c) { return most_of(glm::abs(c)) <= kNoLight; }

}  // namespace

std::string RayTree::named(std::uint32_t object) const
{
    if (object >= scene_.objects.size()) return "an object";
    const std::string place = scene::place_text(description_.place(scene_.objects[object].source));
    return place.empty() ? "an object" : "the object of " + place;
}

void RayTree::add_texture(const Met& met, std::uint32_t index, const glm::dvec3& p, float weight, const std::string& of,
                          texture::Enclosing around)
{
    const auto& set = scene_.textures;
    const texture::Shown shown = texture::shown_at(set, index, p, met.around, around);
    using Kind = texture::Texture::Kind;
    if (shown.texture.kind == Kind::Layers) return add_layers(met, shown.texture, shown.p, weight, of, around);
    const char* const what = shown.texture.kind == Kind::Average ? "of an average" : "of a texture_map";
    shown.each_entry(set, weight, [&](std::uint32_t entry, float share) {
        add_texture(met, set.children[entry], shown.p, share,
                    fmt::format("{}{}{}, entry {}", of, of.empty() ? "" : ", ", what, entry - shown.texture.first + 1),
                    around);
    });
}

void RayTree::add_layers(const Met& met, const texture::Texture& texture, const glm::dvec3& p, float weight,
                         const std::string& of, const texture::Enclosing& around)
{
    const auto& set = scene_.textures;
    const auto bailout = static_cast<float>(scene_.settings.adc_bailout);
    TextureShare out;
    out.weight = weight;
    out.of = of;
    struct Mirrored {
        const texture::Finish* finish;
        scene::Color pigment;
        glm::dvec3 normal;
        float residual;
    };
    std::vector<Mirrored> mirrors;
    glm::vec3 above(1);
    float residual = 1;
    glm::dvec3 top = met.node.normal;
    for (std::uint32_t i = texture.count; i-- > 0 && residual > bailout;) {
        const texture::Layer& layer = set.layers[texture.first + i];
        const texture::Finish& finish = set.finishes[layer.finish];
        LayerShare row;
        row.normal = met.node.normal;
        texture::Surroundings here = met.around;
        if (scene_.settings.quality.normals)
            row.normal = texture::bent_normal(set, layer.normal, row.normal, p, here, around);
        if (mirrors.empty()) top = row.normal;
        row.pigment = texture::pigment_color(set, layer.pigment, p, met.around);
        row.own = texture.plain ? 1.0f : texture::opacity(row.pigment, set.legacy_opacity);
        row.above = above;
        row.glow = row.pigment.rgb() * (finish.ambient + finish.emission) * row.own;
        row.sum = row.glow;
        for (std::size_t k = 0; k < scene_.lights.lights.size(); ++k) {
            row.lights.push_back(light_share(met, k, finish, row.pigment, row.normal, row.own));
            row.sum += row.lights.back().diffuse + row.lights.back().highlight;
        }
        row.sum *= above;
        mirrors.push_back({&finish, row.pigment, row.normal, residual});
        above *= row.pigment.filter * row.pigment.rgb() + row.pigment.transmit;
        if (finish.conserve_energy && scene_.settings.quality.lights)
            above *= glm::min(glm::vec3(1), 1.0f - mirrored_share(met, finish, row.pigment, row.normal));
        residual = std::min(1.0f, std::abs(scene::grey(above)));
        out.layers.push_back(std::move(row));
    }
    Way shared = met.way;
    shared.weight *= weight;
    const Met here{met.node, shared, met.hit, met.surface, met.around};
    let_through(here, above, top, out);
    const bool total = !out.onward.empty() && out.onward.front().how == "reflects within";
    for (const Mirrored& one : mirrors)
        if (!total || one.normal != top) mirror(here, *one.finish, one.pigment, one.normal, one.residual, out);
    met.node.textures.push_back(std::move(out));
}

LightShare RayTree::light_share(const Met& met, std::size_t number, const texture::Finish& finish,
                                const scene::Color& pigment, const glm::dvec3& normal, float own)
{
    const light::Light& light = scene_.lights.lights[number];
    LightShare out;
    out.number = number;
    out.location = light.location;
    if (light.group != met.surface.light_group && !(light.group == 0 && met.surface.global_lights)) {
        out.why = "its light_group has no part in this surface";
        return out;
    }
    const light::Illumination lit = light::illuminate(light, met.node.point);
    if (lightless(lit.color)) {
        out.why = "it does not shine here: outside of its cone, or faded";
        return out;
    }
    const bool away = glm::dot(normal, lit.direction) < kAway && !met.surface.double_illuminate;
    if (away && finish.diffuse_back == 0.0f) {
        out.why = "the surface faces away from it";
        return out;
    }
    out.arriving = past_shadows(met, light, out.why);
    if (lightless(out.arriving)) return out;
    const trace::LitLayer layer{finish, pigment, met.way.ray.direction, normal, static_cast<double>(own)};
    out.diffuse = trace::surface_light(layer, lit.direction, out.arriving, away, 0.0, 0.0);
    const double strength = away || light.shadowless ? 0.0 : trace::highlight(layer, lit.direction);
    if (strength != 0.0)
        out.highlight = static_cast<float>(strength) *
                        texture::highlight_color(finish, out.arriving, pigment, normal, lit.direction);
    return out;
}

/// The light's colour at the hit past what stands between. An area light is asked at all its nodes.
glm::vec3 RayTree::past_shadows(const Met& met, const light::Light& light, std::string& why)
{
    const glm::dvec3& point = met.node.point;
    const light::Illumination lit = light::illuminate(light, point);
    if (light.shadowless || !scene_.settings.quality.shadows) return lit.color;
    const double from = scene_.tolerance.shadow_from(point, met.hit.t);
    const auto share = [&](const light::Illumination& seen, std::string& reason) {
        const double to = seen.distance - from;
        return to <= from ? glm::vec3(1) : unshadowed({point, seen.direction}, from, to, met.way.interiors, reason);
    };
    if (!light.area || !scene_.settings.quality.area_lights) return lit.color * share(lit, why);
    glm::vec3 sum(0);
    int dim = 0;
    std::string first;
    for (int j = 0; j < light.size2; ++j)
        for (int i = 0; i < light.size1; ++i) {
            std::string reason;
            const glm::vec3 seen = share(light::toward(light, point, light::node_offset(light, point, i, j)), reason);
            sum += seen;
            if (reason.empty()) continue;
            ++dim;
            if (first.empty()) first = reason;
        }
    const int all = light.size1 * light.size2;
    if (dim > 0) why = fmt::format("{} of its {} places are {}", dim, all, first);
    return lit.color * sum / static_cast<float>(all);
}

glm::vec3 RayTree::unshadowed(const csg::Ray& ray, double from, double to, trace::InteriorList inside, std::string& why)
{
    std::vector<csg::Hit> crossings;
    std::vector<csg::Share> kept;
    const csg::Shadow shadow = world_.shadow_crossings(ray, from, to, scratch_, crossings);
    if (shadow == csg::Shadow::Clear) return glm::vec3(1);
    if (shadow == csg::Shadow::Blocked) {
        const csg::Hit first = world_.nearest(ray, from, to, plan::bit(plan::RayKind::Shadow), scratch_);
        why = first.found() ? fmt::format("in the shadow of {}, {:.6g} away",
                                          named(scene_.surfaces[first.surface].object), first.t)
                            : "in a shadow";
        return glm::vec3(0);
    }
    glm::vec3 color(1);
    double before = 0.0;
    for (const csg::Hit& hit : crossings) {
        if (hit.t - before <= from) continue;  // the next ray would not see it
        const csg::HitDetails details = world_.details(ray, hit);
        const plan::Surface& surface = scene_.surfaces[hit.surface];
        color *= trace::surface_filter(scene_, world_, ray.direction, hit, details, kept);
        if (surface.interior != plan::kNone) {
            const plan::Interior& interior = scene_.interiors[surface.interior];
            if (!inside.holds(surface.interior)) {
                inside.append(surface.interior);
            } else {
                color *= trace::interior_fade(interior, hit.t - before, true);
                inside.remove_first(surface.interior);
            }
        }
        before = hit.t;
    }
    why = fmt::format("dimmed by {} that light passes",
                      crossings.empty() ? "something" : named(scene_.surfaces[crossings.front().surface].object));
    return color;
}

}  // namespace explain
