#include "render/kernel/antialias/antialias.h"

#include "render/kernel/antialias/methods.h"

namespace trace {

void antialias(const plan::Antialiasing& settings, const scene::AssumedGamma& gamma, const Block& block,
               const SampleTracer& tracer, AntialiasScratch& scratch, scene::Color* out)
{
    if (settings.method == 0) {
        tracer.grid({{block.left, block.top}, block.width, block.height}, out);
        return;
    }
    const ColorDistance distance(settings, gamma);
    const auto method = settings.method == 1 ? antialias_1 : settings.method == 2 ? antialias_2 : antialias_3;
    method(settings, distance, block, tracer, scratch, out);
}

}  // namespace trace
