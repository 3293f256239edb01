#pragma once

#include "render/picture/render.h"

#include <memory>

namespace trace {

struct IndirectLight;

/// Runs the passes that a scene needs before its picture, on all threads of `options`: once a picture, however many
/// strips it is traced in. Null where it needs none, or where RenderOptions::cancel ended them. The same light for any
/// number of threads. RenderOptions::pass is told which pass begins.
std::shared_ptr<const IndirectLight> run_passes(const plan::CompiledScene& scene, const RenderOptions& options);

}  // namespace trace
