#include "render/explain/tree_parts.h"

#include "render/kernel/context/side_textures.h"
#include "render/kernel/interior/interface.h"
#include "render/kernel/interior/interior_fade.h"
#include "render/texture/finish.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace explain {
namespace {

constexpr std::size_t kMostRays = 256;    // that one pixel is explained by
constexpr std::size_t kMostObjects = 24;  // whose spans a ray is told with
constexpr double kSameIndex = 1e-10;      // differences of indices below it count as none

}  // namespace

std::unique_ptr<RayNode> RayTree::explain(const csg::Ray& camera_ray)
{
    rays_ = 0;
    Way way;
    way.ray = camera_ray;
    way.start = scene_.tolerance.hit;
    for (const std::uint32_t interior : scene_.camera_interiors) way.interiors.append(interior);
    return follow(way);
}

std::vector<std::string> RayTree::left_out() const
{
    std::vector<std::string> out;
    if (scene_.radiosity) out.push_back("light between surfaces (radiosity)");
    if (scene_.photons) out.push_back("photons");
    if (scene_.subsurface) out.push_back("light below surfaces");
    if (!scene_.fogs.empty()) out.push_back("fog");
    if (!scene_.rainbows.empty()) out.push_back("rainbows");
    if (scene_.media.media.size() > 0) out.push_back("media");
    const auto some = [](const auto& all, auto&& has) { return std::any_of(all.begin(), all.end(), has); };
    const auto& finishes = scene_.textures.finishes;
    if (!scene_.textures.extensions.empty()) out.push_back("rough mirrors, polish, tones and ink");
    if (some(finishes, [](const texture::Finish& f) { return f.irid > 0.0f; })) out.push_back("iridescence");
    if (some(finishes, [](const texture::Finish& f) { return f.crand > 0.0f; })) out.push_back("grain (crand)");
    if (some(scene_.interiors, [](const plan::Interior& i) { return i.dispersion != 1.0f; }))
        out.push_back("dispersion (light of 555 nm is told)");
    if (some(scene_.lights.lights, [](const light::Light& l) { return l.area_illumination; }))
        out.push_back("area_illumination (light is told from the middle of the lamp)");
    if (some(scene_.lights.lights, [](const light::Light& l) { return l.projector != nullptr; }))
        out.push_back("what lights are projected through");
    if (scene_.camera.aperture > 0.0) out.push_back("focal blur (the ray through the middle of the lens is told)");
    return out;
}

std::unique_ptr<RayNode> RayTree::follow(const Way& way)
{
    ++rays_;
    auto node = std::make_unique<RayNode>();
    node->kind = way.kind;
    node->ray = way.ray;
    node->level = way.level;
    node->spans = spans_.along(way.ray, kMostObjects);
    const csg::Hit hit = world_.nearest(way.ray, way.start, csg::kInfinity, plan::bit(way.asks), scratch_);
    if (!hit.found()) see_sky(*node, way.asks == plan::RayKind::Reflection);
    else shade(*node, way, hit);
    return node;
}

void RayTree::see_sky(RayNode& node, bool mirrored) const
{
    const texture::Sky& sky = scene_.sky;
    texture::Surroundings around;
    around.direction = node.ray.direction;
    glm::vec3 sum(0), filter(1);
    for (std::size_t i = sky.layers.size(); i-- > 0;) {
        const scene::Color c = texture::pigment_color(scene_.textures, sky.layers[i], node.ray.direction, around);
        sum += c.rgb() * (1.0f - c.filter - c.transmit) * filter * sky.emission;
        filter *= c.rgb() * c.filter + c.transmit;
    }
    const scene::Color& b = sky.background;
    const float through = mirrored || !sky.alpha_output ? 0.0f : b.filter + b.transmit;
    sum += b.rgb() * (sky.layers.empty() ? 1.0f : 1.0f - through) * filter;
    node.sees = sky.layers.empty()
                    ? "nothing but the background"
                    : fmt::format("the sky, {} layer{}", sky.layers.size(), sky.layers.size() == 1 ? "" : "s");
    node.color = sum;
}

void RayTree::shade(RayNode& node, const Way& way, const csg::Hit& hit)
{
    const csg::HitDetails details = world_.details(way.ray, hit);
    const plan::Surface& surface = scene_.surfaces[hit.surface];
    node.hit = true;
    node.t = hit.t;
    node.point = details.point;
    node.from_inside = trace::from_inside(details, way.ray.direction);
    node.normal = node.from_inside ? -details.normal : details.normal;
    if (surface.object < scene_.objects.size()) node.object = scene_.objects[surface.object].source;
    double nearest = 1e-6 * (1.0 + hit.t);  // spans and hits come from the same formulas
    for (const ObjectSpans& spans : node.spans)
        for (const Piece& piece : spans.pieces)
            for (const End* end : {&piece.in, &piece.out})
                if (end->leaf != nullptr && std::abs(end->t - hit.t) < nearest) {
                    nearest = std::abs(end->t - hit.t);
                    node.solid = end->leaf;
                }
    Met met{node, way, hit, surface, {}};
    met.around.point = details.point;
    met.around.normal = node.normal;
    met.around.direction = way.ray.direction;
    met.around.uv = details.uv;
    met.around.surface = true;
    const glm::dvec3 p = surface.pattern_point(details.point, details.uv);
    std::vector<csg::Share> kept;
    const trace::SideTextures sides(scene_, world_, hit, details, node.from_inside, kept);
    for (std::size_t k = 0; k < sides.size(); ++k) {
        constexpr std::array<const char*, 3> kCorners{"first corner", "second corner", "third corner"};
        const std::string of = !sides.mixed()            ? ""
                               : surface.part_count != 0 ? fmt::format("part {}", kept[k].part + 1)
                                                         : kCorners[k];
        if (sides.share(k) > 0.0f) add_texture(met, sides.texture(k), p, sides.share(k), of, {});
    }
    for (const TextureShare& share : node.textures) {
        glm::vec3 sum(0);
        for (const LayerShare& layer : share.layers) sum += layer.sum;
        for (const SecondaryRay& onward : share.onward)
            if (onward.ray) sum += onward.factor * onward.ray->color;
        node.color += share.weight * sum;
    }
}

/// \param used levels in use before it
SecondaryRay RayTree::go_on(const Way& way, int used, const char* how, const glm::vec3& factor)
{
    const float weight = way.weight;
    SecondaryRay out;
    out.how = how;
    out.factor = factor;
    const plan::Settings& settings = scene_.settings;
    if (used >= settings.max_trace_level)
        out.cut = fmt::format("max_trace_level {} is reached", settings.max_trace_level);
    else if (!(static_cast<double>(weight) >= settings.adc_bailout))
        out.cut =
            fmt::format("its share {:.4g} of the pixel is below adc_bailout {:.4g}", weight, settings.adc_bailout);
    else if (rays_ >= kMostRays) out.cut = fmt::format("{} rays are explained, no more", kMostRays);
    else out.ray = follow(way);
    return out;
}

/// Reflectivity of a layer here, with the index that a fresnel finish goes by (spec 3, 7.9).
glm::vec3 RayTree::mirrored_share(const Met& met, const texture::Finish& finish, const scene::Color& pigment,
                                  const glm::dvec3& normal) const
{
    if (!finish.reflects()) return glm::vec3(0);
    const double eta = finish.fresnel ? trace::fresnel_index(scene_.interiors, met.way.interiors, met.surface.interior)
                                      : 1.0;
    return texture::reflectivity(finish, pigment, met.way.ray.direction, normal, eta);
}

void RayTree::mirror(const Met& met, const texture::Finish& finish, const scene::Color& pigment,
                     const glm::dvec3& normal, float residual, TextureShare& into)
{
    if (!scene_.settings.quality.reflection) return;
    const glm::dvec3& d = met.way.ray.direction;
    const glm::vec3 share = mirrored_share(met, finish, pigment, normal);
    if (most_of(glm::abs(share)) == 0.0f) return;
    glm::dvec3 r = d - 2.0 * glm::dot(d, normal) * normal;
    const double out = glm::dot(r, met.node.normal);
    if (out < 0.0) {
        if (glm::dot(r, normal) < 0.0) r = d - 2.0 * glm::dot(d, met.node.normal) * met.node.normal;
        else r -= 2.0 * out * met.node.normal;
    }
    Way way = met.way;
    way.ray = {met.node.point, glm::normalize(r)};
    way.start = scene_.tolerance.hit_from(met.node.point, met.hit.t);
    way.kind = "reflected";
    way.asks = plan::RayKind::Reflection;
    way.level = met.way.level + 1;
    const float strength = finish.fresnel ? most_of(share)
                                          : std::max(most_of(finish.reflection_max), most_of(finish.reflection_min));
    way.weight = met.way.weight * residual * std::max(0.0f, strength);
    into.onward.push_back(go_on(way, met.way.level, "reflects", share));
}

void RayTree::let_through(const Met& met, const glm::vec3& filter, const glm::dvec3& normal, TextureShare& into)
{
    const float residual = std::min(1.0f, std::abs(scene::grey(filter)));
    if (residual <= 0.0f || met.surface.interior == plan::kNone || !scene_.settings.quality.transmission) return;
    const plan::Interior& interior = scene_.interiors[met.surface.interior];
    Way way = met.way;
    glm::vec3 factor = filter * interior.transmission;
    if (way.interiors.holds(met.surface.interior)) factor *= trace::interior_fade(interior, met.hit.t, false);
    const trace::Crossing crossing = trace::crossing_of(scene_.interiors, met.way.interiors, met.surface.interior);
    trace::cross(scene_.interiors, met.way.interiors, met.surface.interior, crossing.way, way.interiors);
    const double ratio = crossing.ratio;
    way.weight = met.way.weight * most_of(glm::abs(filter));
    way.start = scene_.tolerance.hit_from(met.node.point, met.hit.t);
    const glm::dvec3& d = met.way.ray.direction;
    const char* how = "lets through";
    way.kind = "straight on";
    way.ray = {met.node.point, d};
    if (std::abs(ratio - 1.0) >= kSameIndex) {
        const double facing = glm::dot(d, normal);
        const glm::dvec3 n = facing <= 0.0 ? normal : -normal;
        const double c = std::abs(facing), k = 1.0 + ratio * ratio * (c * c - 1.0);
        way.level = met.way.level + 1;
        if (k < 0.0) {
            how = "reflects within";
            way.kind = "reflected within";
            way.interiors = met.way.interiors;
            way.asks = plan::RayKind::Reflection;
            way.ray.direction = glm::normalize(d - 2.0 * glm::dot(d, normal) * normal);
        } else {
            how = "refracts";
            way.kind = "refracted";
            way.ray.direction = glm::normalize(ratio * d + (ratio * c - std::sqrt(k)) * n);
        }
    }
    if (static_cast<double>(residual) <= scene_.settings.adc_bailout) {
        SecondaryRay cut;
        cut.how = how;
        cut.factor = factor;
        cut.cut = fmt::format("what is let through, {:.4g}, is below adc_bailout {:.4g}", residual,
                              scene_.settings.adc_bailout);
        into.onward.push_back(std::move(cut));
        return;
    }
    into.onward.push_back(go_on(way, met.way.level, how, factor));
}

}  // namespace explain
