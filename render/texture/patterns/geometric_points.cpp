#include "numbers/functions/lane_functions.h"
#include "render/texture/points/angle.h"
#include "render/texture/points/point_lanes.h"
#include "render/texture/patterns/patterns.h"
#include "render/texture/patterns/turning.h"

#include <cmath>
#include <numbers>

// Patterns of geometric.cpp whose sines take most of their time, many points at once.
namespace texture {
namespace {

/// cycle() of each.
Double cycles(const Double& v)
{
    const Double size = xsimd::abs(v), sine = numbers::sin(Double(kTau) * (size - xsimd::floor(size)));
    return xsimd::select(v >= Double(0.0), sine, -sine);
}

/// The sum over all sources of wave(i, distance from the i-th), of each point.
template <class F>
void sum_over_sources(const TextureSet& set, const Points& p, F&& wave, Values& out)
{
    const Double zero(0.0), one(1.0);
    for (std::size_t k = 0; k < p.size(); k += kLanes) {
        const Double x = get(p.x, k), y = get(p.y, k), z = get(p.z, k);
        Double sum(0.0);
        for (std::size_t i = 0; i < set.wave_sources.size(); ++i) {
            const glm::dvec3& source = set.wave_sources[i];
            const Double dx = x - Double(source.x), dy = y - Double(source.y), dz = z - Double(source.z),
                         l = xsimd::sqrt(dx * dx + dy * dy + dz * dz);
            sum += wave(i, xsimd::select(l == zero, one, l));
        }
        sum.store_aligned(out.data() + k);
    }
}

}  // namespace

void radial_values(const Points& p, Values& out)
{
    for (std::size_t i = 0; i < p.size(); i += kLanes) radial(get(p.x, i), get(p.z, i)).store_aligned(out.data() + i);
}

void quilted_values(const Pattern& pattern, const Points& p, Values& out)
{
    for (std::size_t i = 0; i < p.size(); i += kLanes)
        quilted(get(p.x, i), get(p.y, i), get(p.z, i), pattern.numbers[0], pattern.numbers[1])
            .store_aligned(out.data() + i);
}

void leopard_values(const Points& p, Values& out)
{
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        const Double s = (numbers::sin(get(p.x, i)) + numbers::sin(get(p.y, i)) + numbers::sin(get(p.z, i))) /
                         Double(3.0);
        (s * s).store_aligned(out.data() + i);
    }
}

void ripples_values(const TextureSet& set, const Pattern& pattern, const Points& p, Values& out)
{
    const Double frequency(pattern.frequency), phase(pattern.phase);
    const auto wave = [&](std::size_t, const Double& l) { return cycles(l * frequency + phase); };
    sum_over_sources(set, p, wave, out);
    const auto sources = static_cast<double>(set.wave_sources.size());
    for (std::size_t i = 0; i < p.size(); ++i) out[i] = 0.5 * (1.0 + out[i] / sources);
}

void waves_values(const TextureSet& set, const Pattern& pattern, const Points& p, Values& out)
{
    const Double frequency(pattern.frequency), phase(pattern.phase);
    const auto wave = [&](std::size_t i, const Double& l) {
        const Double f(set.wave_frequencies[i]);
        return cycles(l * frequency * f + phase) / f;
    };
    sum_over_sources(set, p, wave, out);
    const auto sources = static_cast<double>(set.wave_sources.size());
    for (std::size_t i = 0; i < p.size(); ++i) out[i] = 0.2 * (2.5 + out[i] / sources);
}

}  // namespace texture
