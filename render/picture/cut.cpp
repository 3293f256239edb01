#include "render/picture/cut.h"

#include "render/picture/kernel_module.h"
#include "render/picture/workers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace trace {
namespace {

/// Places of the grid: all parts ask for them anew, so many parts allow no more.
constexpr int kMostPlaces = 256;

struct CoarseGrid {
    Block window;
    int columns, rows;

    explicit CoarseGrid(const Block& picture) : window(picture)
    {
        const double aspect = static_cast<double>(window.width) / window.height;
        columns = std::clamp(static_cast<int>(std::sqrt(kMostPlaces * aspect)), 1, std::min(kMostPlaces, window.width));
        rows = std::clamp(kMostPlaces / columns, 1, window.height);
    }
    std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
    SamplePosition place(std::size_t cell) const
    {
        const int column = static_cast<int>(cell) % columns, row = static_cast<int>(cell) / columns;
        return {window.left + std::floor((column + 0.5) * window.width / columns),
                window.top + std::floor((row + 0.5) * window.height / rows)};
    }
    /// Half of the place itself and half of those around it: a block is wider than a ray.
    double around(const std::vector<double>& of, double x, double y) const
    {
        const int column = std::clamp(static_cast<int>((x - window.left) * columns / window.width), 0, columns - 1),
                  row = std::clamp(static_cast<int>((y - window.top) * rows / window.height), 0, rows - 1);
        double sum = 0.0;
        int count = 0;
        for (int v = std::max(0, row - 1); v <= std::min(rows - 1, row + 1); ++v)
            for (int u = std::max(0, column - 1); u <= std::min(columns - 1, column + 1); ++u, ++count)
                sum += of[static_cast<std::size_t>(v * columns + u)];
        return 0.5 * (sum / count + of[static_cast<std::size_t>(row * columns + column)]);
    }
};

double rays_of(const RayCounts& counts)
{
    return static_cast<double>(counts.camera + counts.shadow + counts.reflected + counts.refracted);
}

}  // namespace

std::vector<double> coarse_costs(const plan::CompiledScene& scene, const RenderOptions& options)
{
    const Blocks blocks(scene.options);
    const CoarseGrid grid(blocks.window());
    std::vector<double> costs(grid.size(), 1.0);
    if (scene.options.paths) return costs;  // paths cost about the same everywhere
    const KernelTable& kernel = load_kernel(options.isa);
    function::use(kernel.evaluators);
    Workers<BlockTracer> workers(
        options, [&] { return kernel.make(scene, options.indirect, options.cancel); }, kernel.free);
    const bool all = workers.each(0, costs.size(), [&](std::size_t i, auto& worker) {
        const double before = rays_of(kernel.counts(*worker.tracer));
        const SamplePosition place = grid.place(i);
        scene::Color color;
        if (!kernel.sample(*worker.tracer, {&place, 1}, &color)) return false;
        costs[i] += rays_of(kernel.counts(*worker.tracer)) - before;
        return true;
    });
    return all ? costs : std::vector<double>();
}

std::vector<std::uint32_t> deal_by_cost(const Blocks& blocks, const std::vector<double>& costs, int parts)
{
    const CoarseGrid grid(blocks.window());
    if (costs.size() != grid.size()) throw std::runtime_error("the costs are those of another picture");
    struct Dealt {
        double cost;
        std::uint32_t number;
    };
    std::vector<Dealt> dearest;
    for (std::uint32_t i = 0; i < blocks.size(); ++i) {
        const Block block = blocks[i];
        const double each = grid.around(costs, block.left + 0.5 * block.width, block.top + 0.5 * block.height);
        dearest.push_back({each * block.width * block.height, i});
    }
    std::stable_sort(dearest.begin(), dearest.end(), [](const Dealt& a, const Dealt& b) { return a.cost > b.cost; });
    std::vector<Dealt> least;  // a heap of parts
    for (std::uint32_t part = 0; part < static_cast<std::uint32_t>(parts); ++part) least.push_back({0.0, part});
    const auto later = [](const Dealt& a, const Dealt& b) {
        return a.cost > b.cost || (a.cost == b.cost && a.number > b.number);
    };
    std::vector<std::uint32_t> owners(blocks.size());
    for (const Dealt& block : dearest) {
        std::pop_heap(least.begin(), least.end(), later);
        least.back().cost += block.cost;
        owners[block.number] = least.back().number;
        std::push_heap(least.begin(), least.end(), later);
    }
    return owners;
}

}  // namespace trace
