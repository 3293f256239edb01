#include "render/plan/compile_photons.h"

#include <fmt/format.h>

namespace plan {

std::shared_ptr<PhotonPlan> compile_photons(const scene::Description& description, const Quality& quality)
{
    const scene::GlobalSettings& global = description.global;
    if (!global.photons || !global.photons->active() || !quality.effects) return nullptr;
    auto plan = std::make_shared<PhotonPlan>();
    plan->settings = *global.photons;
    plan->max_trace_level = plan->settings.max_trace_level.value_or(global.max_trace_level);
    plan->adc_bailout = plan->settings.adc_bailout.value_or(global.adc_bailout);
    plan->place = description.place(plan->settings.source);
    return plan;
}

PhotonLight photon_light(const scene::Object& object, const scene::Light& light, const light::Light& compiled)
{
    PhotonLight out;
    out.parallel = light.parallel;
    out.shoots = compiled.group == 0 && !light.shadowless;
    if (!object.details->photons) return out;
    out.reflection = consent(object.details->photons->reflection);
    out.refraction = consent(object.details->photons->refraction);
    out.area = object.details->photons->area_light && light.area && !light.parallel;
    return out;
}

}  // namespace plan
