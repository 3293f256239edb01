#pragma once

#include "render/app/watch/event_log.h"
#include "render/image/levels/quantise.h"
#include "render/plan/compiled_scene.h"
#include "render/picture/render.h"

#include <utility>
#include <vector>

namespace app {

/// What the passes of a picture took, by name, in seconds.
using PassTimes = std::vector<std::pair<std::string, double>>;

/// Traces a picture coarse to fine and tells of its blocks.
/// \param compiled its options' size and window are changed meanwhile, as the passes need them
/// \param coarse false: the pass of all pixels is the first, unless radiosity or photons come before it
/// \return false: cancelled
bool trace_passes(plan::CompiledScene& compiled, const trace::RenderOptions& options, const image::Encoding& encoding,
                  bool coarse, int generation, EventLog& events, PassTimes& times);

}  // namespace app
