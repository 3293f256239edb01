#pragma once

#include "render/plan/quality.h"
#include "render/plan/subsurface.h"
#include "render/plan/interior.h"
#include "render/scene/description.h"

#include <memory>

namespace plan {

/// Null where the scene does not ask for it or the quality leaves it out. interiors: all of the scene.
std::shared_ptr<const SubsurfacePlan> compile_subsurface(const scene::Description& description, const Quality& quality,
                                                         const std::vector<Interior>& interiors);

/// Whether finishes with `subsurface` are more than ordinary ones.
bool has_subsurface(const scene::GlobalSettings& global, const Quality& quality);

}  // namespace plan
