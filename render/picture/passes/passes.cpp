#include "render/picture/passes/passes.h"

#include "render/kernel/gather/indirect_light.h"
#include "render/picture/kernel_module.h"
#include "render/picture/passes/photon_pass.h"
#include "render/picture/passes/radiosity_pass.h"

namespace trace {

std::shared_ptr<const IndirectLight> run_passes(const plan::CompiledScene& scene, const RenderOptions& options)
{
    if (!scene.photons && scene.radiosity == nullptr) return nullptr;
    const KernelTable& kernel = load_kernel(options.isa);
    function::use(kernel.evaluators);
    auto light = std::make_shared<IndirectLight>();
    if (scene.photons && !find_photons(scene, options, *light)) return nullptr;
    if (scene.radiosity != nullptr && !radiosity::fill(scene, options, kernel, *light)) return nullptr;
    return light;
}

}  // namespace trace
