#include "render/kernel/path/lamps.h"

#include "render/kernel/context/projected.h"
#include "render/kernel/path/directions.h"
#include "render/kernel/tile/nearly_zero.h"
#include "render/plan/shines_on.h"

namespace trace::path {
namespace {

/// What it would add. Highlights are of lamps that cast shadows alone.
glm::vec3 response(const light::Light& light, const light::Illumination& lit, const Bsdf& bsdf)
{
    if (black(lit.color)) return glm::vec3(0);
    return static_cast<float>(kPi) *
           (light.shadowless ? bsdf.respond_diffuse(lit.direction) : bsdf.respond(lit.direction).value);
}

/// Anywhere on the face: its axes are those of plan::free_light().
glm::dvec3 place_on(const light::Light& light, const glm::dvec3& point, const std::array<double, 2>& u)
{
    if (!light.area) return glm::dvec3(0);
    const auto along = [](double v, int size) { return size > 1 ? v * size - 0.5 : 0.0; };
    return light::node_offset(light, point, along(u[0], light.size1), along(u[1], light.size2));
}

}  // namespace

LampSample sample_lamp(const Context& context, const HitPlace& hit, const Bsdf& bsdf, std::vector<double>& chances,
                       Draws& draws)
{
    // A lamp whose middle a hit does not see may still shine on it.
    constexpr float kFloor = 0.1f;
    const auto& lights = context.lights.lights;
    const float floor = kFloor * largest(bsdf.albedo());
    chances.resize(lights.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const light::Light& light = lights[i];
        chances[i] = 0.0;
        if (!shines_on(light, hit.surface)) continue;
        const light::Illumination lit = light::illuminate(light, hit.point);
        float weight = largest(glm::abs(response(light, lit, bsdf) * lit.color));
        if (light.area) weight += floor * largest(glm::abs(light.color));
        sum += chances[i] = static_cast<double>(weight);
    }
    LampSample out;
    if (!(sum > 0.0)) return out;
    const auto u = draws.pair(), place = draws.pair();
    double at = u[0] * sum;
    std::size_t chosen = lights.size();
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (!(chances[i] > 0.0)) continue;
        chosen = i;
        if (at < chances[i]) break;
        at -= chances[i];
    }
    const light::Light& light = lights[chosen];
    out.lit = light::illuminate(light, hit.point, place_on(light, hit.point, place));
    out.weight = response(light, out.lit, bsdf) * static_cast<float>(sum / chances[chosen]);
    if (black(out.weight)) return out;
    if (light.projector) {
        const double depth = projected_depth(*light.projector, {hit.point, out.lit.direction});
        if (depth < 0.0 || depth >= out.lit.distance) return out;
        out.lit.distance = depth;
    }
    out.light = &light;
    return out;
}

}  // namespace trace::path
