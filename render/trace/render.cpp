#include "render/trace/render.h"

#include "render/trace/kernel_module.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <vector>

namespace trace {
namespace {

struct FreeTracer {
    const KernelTable* kernel;
    void operator()(BlockTracer* tracer) const { kernel->free(tracer); }
};

/// One thread's part: the tracer and the colours of the block at hand.
struct Worker {
    std::unique_ptr<BlockTracer, FreeTracer> tracer;
    std::vector<scene::Color> colors;
};

void store(const Block& block, const std::vector<scene::Color>& colors, image::Image& image)
{
    const scene::Color* color = colors.data();
    for (int row = 0; row < block.height; ++row)
        for (int column = 0; column < block.width; ++column, ++color) {
            float* pixel = image.at(block.left + column, block.top + row);
            pixel[0] = color->red;
            pixel[1] = color->green;
            pixel[2] = color->blue;
            pixel[3] = color->transmit;
        }
}

}  // namespace

std::vector<Block> blocks_of(const plan::Options& options)
{
    const int right = options.end_column < 0 ? options.width - 1 : options.end_column;
    const int bottom = options.end_row < 0 ? options.height - 1 : options.end_row;
    const int width = right - options.start_column + 1, height = bottom - options.start_row + 1;
    const int side = std::max(1, std::min(options.block_size, std::max(width, height)));
    std::vector<Block> blocks;
    for (int top = 0; top < height; top += side)
        for (int left = 0; left < width; left += side)
            blocks.push_back({options.start_column + left, options.start_row + top, std::min(side, width - left),
                              std::min(side, height - top)});
    return blocks;
}

void prepare(Isa isa, int threads)
{
    load_kernel(isa);
    const int count = threads > 0 ? threads : tbb::info::default_concurrency();
    tbb::task_arena arena(count);
    arena.execute([count] { tbb::parallel_for(0, 4 * count, [](int) {}); });
}

RenderStatistics render(const plan::CompiledScene& scene, const RenderOptions& options, image::Image& image)
{
    const KernelTable& kernel = load_kernel(options.isa);
    function::use(kernel.evaluators);
    const auto start = std::chrono::steady_clock::now();
    image.width = scene.options.width;
    image.height = scene.options.height;
    const std::size_t samples = 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (options.done.empty() || image.pixels.size() != samples) image.pixels.assign(samples, 0.0f);

    const int threads = options.threads > 0 ? options.threads : tbb::info::default_concurrency();
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    tbb::enumerable_thread_specific<Worker> workers([&] {
        return Worker{std::unique_ptr<BlockTracer, FreeTracer>(kernel.make(scene), FreeTracer{&kernel}), {}};
    });

    const std::vector<Block> blocks = blocks_of(scene.options);
    const bool has_done = options.done.size() == blocks.size();
    std::atomic<std::size_t> done = static_cast<std::size_t>(has_done ? std::count(options.done.begin(), options.done.end(), true) : 0);
    std::atomic<bool> stopped = false;
    tbb::task_arena arena(threads);
    arena.execute([&] {
        tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
            if (options.cancel != nullptr && options.cancel->load(std::memory_order_relaxed)) {
                stopped = true;
                return;
            }
            if (has_done && options.done[i]) return;
            Worker& worker = workers.local();
            const Block& block = blocks[i];
            worker.colors.resize(static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
            kernel.trace(*worker.tracer, block, worker.colors.data());
            store(block, worker.colors, image);
            if (options.finished) options.finished(i);
            const std::size_t finished = ++done;
            if (options.progress) options.progress(static_cast<double>(finished) / static_cast<double>(blocks.size()));
        });
    });

    RenderStatistics statistics;
    for (const Worker& worker : workers) statistics.rays += kernel.counts(*worker.tracer);
    statistics.threads = threads;
    statistics.isa = kernel.isa;
    statistics.cancelled = stopped;
    statistics.seconds_trace = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return statistics;
}

}  // namespace trace
