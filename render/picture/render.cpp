#include "render/picture/render.h"

#include "render/picture/kernel_module.h"
#include "render/picture/workers.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace trace {
namespace {

void store(const Block& block, const std::vector<scene::Color>& colors, image::Image& image)
{
    const scene::Color* color = colors.data();
    for (int row = 0; row < block.height; ++row) {
        float* pixel = image.at(block.left, block.top + row);
        for (int column = 0; column < block.width; ++column, ++color, pixel += 4) {
            pixel[0] = color->red;
            pixel[1] = color->green;
            pixel[2] = color->blue;
            pixel[3] = color->transmit;
        }
    }
}

}  // namespace

RenderStatistics render(const plan::CompiledScene& scene, const RenderOptions& options, image::Image& image)
{
    const KernelTable& kernel = load_kernel(options.isa);
    function::use(kernel.evaluators);
    const auto start = std::chrono::steady_clock::now();
    if (image.width != scene.options.width || image.height != scene.options.height || image.pixels.empty()) {
        image.width = scene.options.width;
        image.height = scene.options.height;
        image.hold(0, image.height);
    }

    Workers<BlockTracer, std::vector<scene::Color>> workers(
        options, [&] { return kernel.make(scene, options.indirect, options.cancel); }, kernel.free);
    const Blocks blocks(scene.options);
    const std::size_t last = std::min(options.last, blocks.size());
    const bool has_done = options.done.size() == blocks.size();
    const auto wanted = [&](std::size_t i) { return options.asks_for(i) && !(has_done && options.done[i]); };
    std::atomic<std::size_t> done = options.first;
    for (std::size_t i = options.first; i < last; ++i) done += wanted(i) ? 0 : 1;
    const bool all = workers.each(options.first, last, [&](std::size_t i, auto& worker) {
        if (!wanted(i)) return true;
        const Block block = blocks[i];
        worker.kept.resize(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
        if (!kernel.trace(*worker.tracer, block, worker.kept.data())) return false;
        store(block, worker.kept, image);
        if (options.finished) options.finished(i);
        const std::size_t finished = ++done;
        if (options.progress) options.progress(static_cast<double>(finished) / static_cast<double>(blocks.size()));
        return true;
    });

    RenderStatistics statistics;
    statistics.rays = workers.counts(kernel.counts);
    statistics.threads = workers.threads();
    statistics.isa = kernel.isa;
    statistics.cancelled = !all;
    statistics.seconds_trace = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return statistics;
}

}  // namespace trace
