#pragma once

#include "render/plan/compiled_scene.h"

namespace plan {

/// Decides which surfaces a shadow ray may stop at: Surface::opaque and what the geometry knows of it. These are the
/// ones that POV-Ray classifies as opaque (spec 3, 13.2) and those whose textures let no light through at any place,
/// where nothing clear lies beside them: behind a clear surface POV-Ray's next ray does not see what is not farther
/// than its tolerance. After all items are added, before WorldData::finish().
void find_light_stops(CompiledScene& scene);

}  // namespace plan
