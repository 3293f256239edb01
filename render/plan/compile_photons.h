#pragma once

#include "render/light/light_set.h"
#include "render/plan/photons.h"
#include "render/plan/quality.h"
#include "render/scene/description.h"

#include <memory>

namespace plan {

/// Settings of the scene's photons, without targets and lights; null where it has none or the quality leaves them out.
std::shared_ptr<PhotonPlan> compile_photons(const scene::Description& description, const Quality& quality);

/// What photons ask of a light. object: that it is; compiled: what became of it.
PhotonLight photon_light(const scene::Object& object, const scene::Light& light, const light::Light& compiled);

}  // namespace plan
