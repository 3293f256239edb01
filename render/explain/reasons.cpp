#include "render/explain/reasons.h"

#include "render/kernel/scatter/scatter.h"
#include "render/plan/shines_on.h"

#include <fmt/format.h>

#include <algorithm>

namespace explain {

std::string why_dim(const plan::CompiledScene& scene, const PlaceNames& names, const trace::RecordedRay& hit,
                    const trace::RecordedRow& row, std::size_t number, bool gives)
{
    const light::Light& light = scene.lights.lights[number];
    const plan::Surface& surface = scene.surfaces[hit.met.surface];
    const auto of = std::find_if(hit.lamps.begin(), hit.lamps.end(),
                                 [&](const trace::RecordedLamp& lamp) { return lamp.number == number; });
    if (of == hit.lamps.end())
        return plan::shines_on(light, surface) ? "it is not asked: nothing there takes light"
                                               : "its light_group has no part in this surface";
    if (trace::dark(of->color)) return "it does not shine here: outside of its cone, or faded";
    const trace::RecordedShadow& shadow = of->shadow;
    const bool away = glm::dot(row.normal, of->direction) < 0.0 && !surface.double_illuminate;
    if (!gives && away) return "the surface faces away from it";
    if (const int dim = shadow.blocked + shadow.filtered; dim > 0) {
        const bool known = shadow.surface != csg::kNoSurface;
        const std::string what = known ? names.object(scene, shadow.surface) : "something";
        const std::string how = shadow.blocked == 0
                                    ? fmt::format("dimmed by {} that light passes", what)
                                    : fmt::format("in the shadow of {}{}", what,
                                                  known ? fmt::format(", {:.6g} away", shadow.distance) : "");
        return shadow.asked == 1 ? how : fmt::format("{} of its {} places are {}", dim, shadow.asked, how);
    }
    if (gives) return light.atmosphere && shadow.asked > 0 ? "past what fills the air" : "";
    return light.projector ? "what it shines through does not show it here" : "this layer takes none of it";
}

std::string why_cut(const plan::CompiledScene& scene, const trace::RecordedRay& hit, float weight)
{
    const plan::Settings& settings = scene.settings;
    if (hit.level >= settings.max_trace_level)
        return fmt::format("max_trace_level {} is reached", settings.max_trace_level);
    return fmt::format("its share {}of the pixel is below adc_bailout {:.4g}",
                       weight < 0.0f ? "" : fmt::format("{:.4g} ", weight), settings.adc_bailout);
}

float mirror_weight(const trace::Record& record, const trace::ShadeNode& node, std::uint32_t n)
{
    const trace::RecordedOwner& owner = record.owners[static_cast<std::size_t>(&node - record.nodes.data())];
    const trace::RecordedRay& hit = record.rays[owner.ray];
    std::vector<const trace::RecordedRow*> mirrors;
    for (std::uint32_t i = owner.first; i < owner.last; ++i)
        if (hit.rows[i].finish->reflects()) mirrors.push_back(&hit.rows[i]);
    if (mirrors.size() != node.count) return -1.0f;
    return trace::mirror_weight(hit.state.weight, trace::residual_of(mirrors[n]->filter), *mirrors[n]->finish,
                                record.terms[node.first + n].factor);
}

}  // namespace explain
