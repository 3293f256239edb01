#pragma once

#include "render/app/run/run.h"
#include "render/plan/compiled_scene.h"

namespace app {

/// What --explain=cost and --heat ask for; nothing where neither is given. Throws AbortedRun where it is cancelled.
void report_cost(Run& run, const scene::Description& description, const plan::CompiledScene& compiled);

}  // namespace app
