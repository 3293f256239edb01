#include "render/texture/map_points.h"

#include "numbers/lane_arithmetic.h"
#include "numbers/remainder_lanes.h"
#include "render/texture/points/point_lanes.h"

#include <algorithm>

namespace texture {
namespace {

/// blend_at() for rising keys: as many lie below a value as there are steps up to its place.
void blend_points(const float* keys, std::uint32_t entries, const Values& values, std::size_t count, BlendPoints& out)
{
    const Double last_key(static_cast<double>(keys[entries - 1])), zero(0.0), one(1.0),
        last(static_cast<double>(entries - 1));
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Double v = Double::load_aligned(values.data() + i);
        Double below = zero, low = last_key, high = last_key;
        for (std::uint32_t k = 0; k < entries; ++k) {
            const Double key(static_cast<double>(keys[k]));
            const auto passed = key < v;
            below = below + xsimd::select(passed, one, zero);
            low = xsimd::select(passed, key, low);
        }
        for (std::uint32_t k = entries; k-- > 0;) {
            const Double key(static_cast<double>(keys[k]));
            high = xsimd::select(key < v, high, key);
        }
        const auto beyond = v >= last_key, alone = beyond | (below == zero) | (high == v);
        xsimd::select(alone, zero, (v - low) / (high - low)).store_aligned(out.share.data() + i);
        const Double at = xsimd::select(beyond, last, below);
        const auto store = [i](const Double& of, auto& to) {
            csg::lanes::store_whole(of, reinterpret_cast<std::int32_t*>(to.data() + i));
        };
        store(at, out.upper);
        store(xsimd::select(alone, at, at - one), out.lower);
    }
}

/// Entries of maps that are looked up in registers.
constexpr std::uint32_t kMostEntries = 8;
bool in_registers(const float* keys, std::uint32_t entries)
{
    return entries <= kMostEntries && std::is_sorted(keys, keys + entries);
}

/// One component of the colours: mix() of the two entries.
#if defined(__AVX2__)
void mix_points(const float* entries, const BlendPoints& blends, std::size_t count, float* out)
{
    const __m256 table = _mm256_load_ps(entries);
    for (std::size_t i = 0; i < count; i += 8) {
        const auto entry = [&](const auto& places) {
            return _mm256_permutevar8x32_ps(table,
                                            _mm256_load_si256(reinterpret_cast<const __m256i*>(places.data() + i)));
        };
        const __m256 low = entry(blends.lower), step = _mm256_sub_ps(entry(blends.upper), low);
        const auto part = [&](__m128 steps, std::size_t at) {
            return _mm256_cvtpd_ps(_mm256_mul_pd(_mm256_load_pd(blends.share.data() + at), _mm256_cvtps_pd(steps)));
        };
        const __m128 first = part(_mm256_castps256_ps128(step), i),
                     second = part(_mm256_extractf128_ps(step, 1), i + 4);
        _mm256_store_ps(out + i, _mm256_add_ps(low, _mm256_insertf128_ps(_mm256_castps128_ps256(first), second, 1)));
    }
}
#else
void mix_points(const float* entries, const BlendPoints& blends, std::size_t count, float* out)
{
    for (std::size_t i = 0; i < count; ++i) {
        const float low = entries[blends.lower[i]], high = entries[blends.upper[i]];
        out[i] = low + static_cast<float>(blends.share[i] * static_cast<double>(high - low));
    }
}
#endif

/// Frequency and phase, and the remainder by kModulus.
Double folded(const Double& v, const Pattern& pattern)
{
    const Double modulus(kModulus), moved = v * Double(pattern.frequency) + Double(pattern.phase),
                                    size = xsimd::abs(moved);
    // A difference is exact where it suffices, and mostly it does.
    if (csg::lanes::mask(size < Double(2.0 * kModulus)) != (1u << kLanes) - 1) return numbers::fmod(moved, modulus);
    return csg::lanes::signed_as(xsimd::select(size < modulus, size, size - modulus), moved);
}

}  // namespace

void waved_points(const Pattern& pattern, std::size_t count, Values& values)
{
    using scene::WaveForm;
    const Double zero(0.0), half(0.5), one(1.0), two(2.0);
    for (std::size_t i = 0; i < count; i += kLanes) {
        Double v = Double::load_aligned(values.data() + i);
        if (pattern.folds) v = folded(v, pattern);
        v = xsimd::select(v < zero, v - xsimd::floor(v), v);
        if (pattern.wave == WaveForm::Sine) {
            v = (one + cycle(v)) / two;
        } else if (pattern.wave == WaveForm::Scallop) {
            v = xsimd::abs(cycle(v / two));
        } else if (pattern.wave == WaveForm::Triangle) {
            const Double o = v - xsimd::floor(v);
            v = xsimd::select(o < half, two * o, two * (one - o));
        } else if (pattern.wave == WaveForm::Cubic) {
            v = v * v * (Double(3.0) - two * v);
        } else if (pattern.wave == WaveForm::Poly) {
            v = pattern.poly_exponent == 2.0 ? v * v : numbers::pow(v, Double(pattern.poly_exponent));
        }
        v.store_aligned(values.data() + i);
    }
}

void map_blends(const TextureSet& set, std::uint32_t first, std::uint32_t entries, const Values& values,
                std::size_t count, BlendPoints& out)
{
    const float* keys = set.keys.data() + first;
    if (in_registers(keys, entries)) return blend_points(keys, entries, values, count, out);
    for (std::size_t i = 0; i < count; ++i) {
        const Blend blend = blend_at(set, first, entries, values[i]);
        out.lower[i] = blend.lower - first;
        out.upper[i] = blend.upper - first;
        out.share[i] = blend.share;
    }
}

void color_map_points(const TextureSet& set, std::uint32_t first, std::uint32_t entries, const Values& values,
                      const Points& points, ColorPoints& out)
{
    const std::size_t count = points.size();
    const float* keys = set.keys.data() + first;
    const scene::Color* colors = set.colors.data() + first;
    if (!in_registers(keys, entries)) {
        for (std::size_t i = 0; i < count; ++i) {
            const Blend b = blend_at(set, first, entries, values[i]);
            out.set(i,
                    b.lower == b.upper ? set.colors[b.lower] : mix(set.colors[b.lower], set.colors[b.upper], b.share));
        }
        return;
    }
    BlendPoints blends;
    blend_points(keys, entries, values, count, blends);
    const auto component = [&](float scene::Color::*of, std::array<float, kMostPoints>& to) {
        alignas(32) float table[kMostEntries] = {};
        for (std::uint32_t k = 0; k < entries; ++k) table[k] = colors[k].*of;
        mix_points(table, blends, count, to.data());
    };
    component(&scene::Color::red, out.red);
    component(&scene::Color::green, out.green);
    component(&scene::Color::blue, out.blue);
    if (points.density) return out.fill_clear(0.0f);
    component(&scene::Color::filter, out.filter);
    component(&scene::Color::transmit, out.transmit);
}

}  // namespace texture
