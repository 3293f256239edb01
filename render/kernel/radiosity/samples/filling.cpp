#include "render/kernel/radiosity/samples/field.h"
#include "numbers/random.h"

#include <algorithm>

namespace trace::radiosity {

void Filling::begin(const Field& field, const PassTile& tile)
{
    pretrace = tile.pretrace;
    in_order = tile.first != nullptr;
    samples.resize(field.samples.size());
    for (SampleGrid& grid : samples) grid.clear();
    found.clear();
    weight.fill(0.0f);
    asked.fill(0);
    next.resize(field.samples.size());
    if (tile.first != nullptr) {
        std::copy(tile.first->begin(), tile.first->end(), next.begin());
        return;
    }
    for (std::size_t bounce = 0; bounce < next.size(); ++bounce) {
        const std::uint64_t h = numbers::stirred((tile.seed + bounce + 1) * 0x9e3779b97f4a7c15u);
        // POV-Ray's samples begin at multiples of their number of rays.
        const auto rays = static_cast<std::uint64_t>(field.rules[bounce].rays),
                   pool = std::uint64_t{field.directions.size()};
        next[bounce] = static_cast<std::size_t>(h % pool * rays % pool);
    }
}

}  // namespace trace::radiosity
