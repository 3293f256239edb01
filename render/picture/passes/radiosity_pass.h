#pragma once

#include "render/picture/render.h"

namespace trace {

struct IndirectLight;
struct KernelTable;

namespace radiosity {

/// Fills IndirectLight::radiosity with samples for the whole picture, on all threads: coarse passes that become finer,
/// then one over all pixels by the rules of the picture. False: cancelled. The samples do not depend on the number of
/// threads nor on Options::block_size (docs/radiosity.md).
bool fill(const plan::CompiledScene& scene, const RenderOptions& options, const KernelTable& kernel,
          IndirectLight& light);

}  // namespace radiosity
}  // namespace trace
