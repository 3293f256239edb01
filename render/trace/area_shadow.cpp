#include "render/trace/area_shadow.h"

#include "render/trace/random.h"

#include <cmath>

namespace trace {
namespace {

constexpr float kEdge = 0.1f;  // neighbouring samples that differ by more are refined (spec 3, 12.6)
constexpr float kUnknown = -1.0f;

struct Sampler {
    Context& context;
    const HitContext& hit;
    const light::Light& light;
    glm::vec3 color;

    const glm::vec3& node(int i, int j)
    {
        glm::vec3& value = context.scratch.shade.area_nodes[static_cast<std::size_t>(i * light.size2 + j)];
        if (value.x < 0.0f) {
            double x = i, y = j;
            if (light.jitter) {
                const auto purpose = static_cast<std::uint32_t>(2 * (i * light.size2 + j)) + 1000u;
                x += random_at(hit.point, purpose) - 0.5;
                y += random_at(hit.point, purpose + 1u) - 0.5;
            }
            const light::Illumination lit =
                light::toward(light, hit.point, light::node_offset(light, hit.point, x, y));
            value = point_shadow(context, hit, light, lit, color, false);
        }
        return value;
    }

    static bool differ(const glm::vec3& a, const glm::vec3& b)
    {
        const glm::vec3 d = glm::abs(a - b);
        return d.x + d.y + d.z > kEdge;
    }

    glm::vec3 rectangle(int i1, int j1, int i2, int j2, int depth)
    {
        const glm::vec3 c00 = node(i1, j1), c10 = node(i2, j1), c01 = node(i1, j2), c11 = node(i2, j2);
        const bool divisible = i2 - i1 > 1 || j2 - j1 > 1;
        if (!divisible || (depth >= light.adaptive && !differ(c00, c10) && !differ(c00, c01) && !differ(c11, c10) &&
                           !differ(c11, c01)))
            return (c00 + c10 + c01 + c11) * 0.25f;
        const int i_low = (i1 + i2) / 2, i_high = (i1 + i2 + 1) / 2;
        const int j_low = (j1 + j2) / 2, j_high = (j1 + j2 + 1) / 2;
        glm::vec3 sum = rectangle(i1, j1, i_low, j_low, depth + 1);
        sum += rectangle(i_high, j1, i2, j_low, depth + 1);
        sum += rectangle(i1, j_high, i_low, j2, depth + 1);
        sum += rectangle(i_high, j_high, i2, j2, depth + 1);
        return sum * 0.25f;
    }
};

}  // namespace

glm::vec3 point_shadow(Context& context, const HitContext& hit, const light::Light& light, light::Illumination lit,
                       const glm::vec3& color, bool in_fog)
{
    if (light.projector) {
        const double depth = light.projector->depth({hit.point, lit.direction});
        if (depth < 0.0 || depth >= lit.distance) return glm::vec3(0);
        lit.distance = depth;
    }
    if (light.shadowless) return color;
    const double tolerance = context.scene.tolerance.shadow_from(hit.point, hit.met.t);
    return filtered_light(context, hit.point, tolerance, hit.state.interiors, lit, color, in_fog);
}

glm::vec3 area_shadow(Context& context, const HitContext& hit, const light::Light& light,
                      const light::Illumination& lit)
{
    Sampler sampler{context, hit, light, light.area_illumination ? light.color : lit.color};
    context.scratch.shade.area_nodes.assign(static_cast<std::size_t>(light.size1 * light.size2), glm::vec3(kUnknown));
    const glm::vec3 seen = sampler.rectangle(0, 0, light.size1 - 1, light.size2 - 1, 0);
    // Fog as if all of it came from the centre.
    if (!light.atmosphere || light.shadowless || !hit.state.interiors.all_hollow(context.scene.interiors)) return seen;
    return seen * fog_share(context, {hit.point, lit.direction}, lit.distance);
}

}  // namespace trace
