#include "render/trace/radiosity/field.h"

namespace trace::radiosity {

void Filling::begin(const Field& field, std::uint64_t seed)
{
    samples.resize(field.samples.size());
    for (SampleGrid& grid : samples) grid.clear();
    found.clear();
    next.resize(field.samples.size());
    for (std::size_t bounce = 0; bounce < next.size(); ++bounce) {
        // Mixing steps of splitmix64 (see trace/random.h).
        std::uint64_t h = (seed + bounce + 1) * 0x9e3779b97f4a7c15u;
        h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
        h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
        // POV-Ray's samples begin at multiples of their number of rays.
        const auto rays = static_cast<std::uint64_t>(field.rules[bounce].rays),
                   pool = std::uint64_t{field.directions.size()};
        next[bounce] = static_cast<std::size_t>((h ^ (h >> 31)) % pool * rays % pool);
    }
    weight.fill(0.0f);
    asked.fill(0);
}

}  // namespace trace::radiosity
