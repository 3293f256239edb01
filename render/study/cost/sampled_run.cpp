#include "render/study/cost/sampled_run.h"

#include <algorithm>

namespace study {

std::vector<trace::SamplePosition> scattered_tiles(const plan::Options& options, std::size_t pixels)
{
    constexpr int kTileSide = 8;
    const int columns = (options.width + kTileSide - 1) / kTileSide,
              rows = (options.height + kTileSide - 1) / kTileSide;
    const auto tiles = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    const std::size_t wanted = std::clamp<std::size_t>(pixels / (kTileSide * kTileSide), 1, tiles);
    std::vector<trace::SamplePosition> out;
    for (std::size_t n = 0; n < wanted; ++n) {
        const std::size_t tile = n * tiles / wanted;
        const int left = static_cast<int>(tile % static_cast<std::size_t>(columns)) * kTileSide,
                  top = static_cast<int>(tile / static_cast<std::size_t>(columns)) * kTileSide;
        for (int y = top; y < std::min(top + kTileSide, options.height); ++y)
            for (int x = left; x < std::min(left + kTileSide, options.width); ++x) out.emplace_back(x, y);
    }
    return out;
}

}  // namespace study
