#include "render/texture/map_points.h"

#include "numbers/lane_arithmetic.h"
#include "numbers/functions/remainder_lanes.h"
#include "render/texture/points/point_lanes.h"

#include <algorithm>
#include <bit>

namespace texture {
namespace {

/// Points whose places are looked up together.
constexpr std::size_t kTogether = 8;
std::size_t in_eights(std::size_t count) { return (count + kTogether - 1) / kTogether * kTogether; }

/// A number for each entry of a map: those of short maps are in registers.
class Table {
public:
    /// first: of the numbers, which lie `stride` apart
    Table(const float* first, int stride, std::uint32_t entries) : first_(first), stride_(stride), entries_(entries)
    {
        if (!is_short()) return;
#if defined(__AVX2__)
        // As they are read: numbers that were written by themselves would be waited for.
        for (std::uint32_t k = 0; k < entries && stride == 1; k += kTogether) {
            const __m256i there = _mm256_cmpgt_epi32(_mm256_set1_epi32(static_cast<int>(entries - k)),
                                                     _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
            _mm256_store_ps(numbers_.data() + k, _mm256_maskload_ps(first + k, there));
        }
        if (stride == 1) return;
#endif
        for (std::uint32_t k = 0; k < entries; ++k) numbers_[k] = first[k * static_cast<std::uint32_t>(stride)];
    }
    bool is_short() const { return entries_ <= kShort; }

#if defined(__AVX2__)
    /// Those of eight places.
    __m256 at(const std::uint32_t* places) const
    {
        return at(_mm256_load_si256(reinterpret_cast<const __m256i*>(places)));
    }
    __m256 at(const __m256i& where) const
    {
        if (!is_short())
            return _mm256_i32gather_ps(first_, _mm256_mullo_epi32(where, _mm256_set1_epi32(stride_)), sizeof(float));
        __m256 out = _mm256_permutevar8x32_ps(_mm256_load_ps(numbers_.data()), where);
        for (std::uint32_t k = kTogether; k < entries_; k += kTogether) {
            const __m256 more = _mm256_permutevar8x32_ps(_mm256_load_ps(numbers_.data() + k), where);
            const __m256i beyond = _mm256_cmpgt_epi32(where, _mm256_set1_epi32(static_cast<int>(k) - 1));
            out = _mm256_blendv_ps(out, more, _mm256_castsi256_ps(beyond));
        }
        return out;
    }
#else
    float at(std::uint32_t place) const { return first_[place * static_cast<std::uint32_t>(stride_)]; }
#endif

private:
    static constexpr std::uint32_t kShort = 32;

    const float* first_;
    int stride_;
    std::uint32_t entries_;
    alignas(32) std::array<float, kShort> numbers_{};
};

// Places are whole numbers in Values; as many as there are in_eights() are read and written.

#if defined(__AVX2__)
/// Eight of them: whoever reads them next would wait for two halves that were written by themselves.
__m256i eight_places(const double* at)
{
    return _mm256_set_m128i(_mm256_cvttpd_epi32(_mm256_load_pd(at + 4)), _mm256_cvttpd_epi32(_mm256_load_pd(at)));
}
#endif

void store_places(const Values& places, std::size_t count, std::array<std::uint32_t, kMostPoints>& to)
{
#if defined(__AVX2__)
    for (std::size_t i = 0; i < count; i += kTogether)
        _mm256_store_si256(reinterpret_cast<__m256i*>(to.data() + i), eight_places(places.data() + i));
#else
    for (std::size_t i = 0; i < count; i += kLanes)
        numbers::lanes::store_whole(get(places, i), reinterpret_cast<std::int32_t*>(to.data() + i));
#endif
}

/// The numbers at places.
void look_up(const Table& table, const Values& places, std::size_t count, Values& out)
{
#if defined(__AVX2__)
    for (std::size_t i = 0; i < count; i += kTogether) {
        const __m256 found = table.at(eight_places(places.data() + i));
        _mm256_store_pd(out.data() + i, _mm256_cvtps_pd(_mm256_castps256_ps128(found)));
        _mm256_store_pd(out.data() + i + 4, _mm256_cvtps_pd(_mm256_extractf128_ps(found, 1)));
    }
#else
    for (std::size_t i = 0; i < count; ++i)
        out[i] = static_cast<double>(table.at(static_cast<std::uint32_t>(places[i])));
#endif
}

/// How many of the keys, which rise, are below each value.
void count_below(const float* keys, std::uint32_t entries, const Table& table, const Values& values, std::size_t count,
                 Values& out)
{
    const Double zero(0.0), one(1.0), all(static_cast<double>(entries));
    if (table.is_short()) {
        for (std::size_t i = 0; i < count; i += kLanes) {
            const Double v = get(values, i);
            Double below = zero;
            for (std::uint32_t k = 0; k < entries; ++k)
                below = below + xsimd::select(Double(static_cast<double>(keys[k])) < v, one, zero);
            below.store_aligned(out.data() + i);
        }
        return;
    }
    std::fill_n(out.data(), count, 0.0);
    Values found, last;
    for (std::uint32_t step = std::bit_floor(entries); step > 0; step /= 2) {
        const Double by(static_cast<double>(step));
        for (std::size_t i = 0; i < count; i += kLanes)
            (xsimd::min(get(out, i) + by, all) - one).store_aligned(last.data() + i);
        look_up(table, last, count, found);
        for (std::size_t i = 0; i < count; i += kLanes) {
            const Double below = get(out, i), more = below + by;
            const auto passed = (more <= all) & (get(found, i) < get(values, i));
            xsimd::select(passed, more, below).store_aligned(out.data() + i);
        }
    }
}

/// blend_at() for rising keys, of as many points as are in_eights(): as many lie below a value as there are steps up to
/// its place.
void blend_points(const float* keys, std::uint32_t entries, const Values& values, std::size_t count, BlendPoints& out)
{
    const Double first_key(static_cast<double>(keys[0])), last_key(static_cast<double>(keys[entries - 1])), zero(0.0),
        one(1.0), last(static_cast<double>(entries - 1));
    const Table table(keys, 1, entries);
    Values place, below, low, high;
    count_below(keys, entries, table, values, count, place);
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Double at = xsimd::select(get(values, i) >= last_key, last, get(place, i));
        at.store_aligned(place.data() + i);
        xsimd::max(at - one, zero).store_aligned(below.data() + i);
    }
    look_up(table, below, count, low);
    look_up(table, place, count, high);
    for (std::size_t i = 0; i < count; i += kLanes) {
        const Double v = get(values, i), at = get(place, i), from = get(low, i), to = get(high, i);
        const auto between = (v > first_key) & (v < last_key) & (v != to);
        xsimd::select(between, (v - from) / (to - from), zero).store_aligned(out.share.data() + i);
        xsimd::select(between, at - one, at).store_aligned(below.data() + i);
    }
    store_places(place, count, out.upper);
    store_places(below, count, out.lower);
}

/// One component of the colours: mix() of the two entries.
void mix_points(const Table& table, const BlendPoints& blends, std::size_t count, float* out)
{
#if defined(__AVX2__)
    for (std::size_t i = 0; i < count; i += kTogether) {
        const __m256 low = table.at(blends.lower.data() + i),
                     step = _mm256_sub_ps(table.at(blends.upper.data() + i), low);
        const auto part = [&](__m128 steps, std::size_t at) {
            return _mm256_cvtpd_ps(_mm256_mul_pd(_mm256_load_pd(blends.share.data() + at), _mm256_cvtps_pd(steps)));
        };
        const __m128 first = part(_mm256_castps256_ps128(step), i),
                     second = part(_mm256_extractf128_ps(step, 1), i + 4);
        _mm256_store_ps(out + i, _mm256_add_ps(low, _mm256_insertf128_ps(_mm256_castps128_ps256(first), second, 1)));
    }
#else
    for (std::size_t i = 0; i < count; ++i) {
        const float low = table.at(blends.lower[i]), high = table.at(blends.upper[i]);
        out[i] = low + static_cast<float>(blends.share[i] * static_cast<double>(high - low));
    }
#endif
}

/// Frequency and phase, and the remainder by kModulus.
Double folded(const Double& v, const Pattern& pattern)
{
    const Double modulus(kModulus), moved = v * Double(pattern.frequency) + Double(pattern.phase),
                                    size = xsimd::abs(moved);
    // A difference is exact where it suffices, and mostly it does.
    if (numbers::lanes::mask(size < Double(2.0 * kModulus)) != (1u << kLanes) - 1) return numbers::fmod(moved, modulus);
    return numbers::lanes::signed_as(xsimd::select(size < modulus, size, size - modulus), moved);
}

}  // namespace

void waved_points(const Pattern& pattern, std::size_t count, Values& values)
{
    using scene::WaveForm;
    if (pattern.wave == WaveForm::Raw) return;
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
    if (std::is_sorted(keys, keys + entries)) return blend_points(keys, entries, values, in_eights(count), out);
    for (std::size_t i = 0; i < count; ++i) {
        const Blend blend = blend_at(set, first, entries, values[i]);
        out.lower[i] = blend.lower - first;
        out.upper[i] = blend.upper - first;
        out.share[i] = blend.share;
    }
}

void color_map_points(const TextureSet& set, const Pigment& map, const Values& values, const Points& points,
                      ColorPoints& out)
{
    const float* keys = set.keys.data() + map.first;
    const scene::Color* colors = set.colors.data() + map.first;
    const std::uint32_t entries = map.count;
    if (map.blending.mode != scene::Blending::Mode::Working || !std::is_sorted(keys, keys + entries)) {
        for (std::size_t i = 0; i < points.size(); ++i)
            out.set(i, mapped(set, map.blending, blend_at(set, map.first, entries, values[i])));
        return;
    }
    const std::size_t count = in_eights(points.size());
    BlendPoints blends;
    blend_points(keys, entries, values, count, blends);
    constexpr int kStride = sizeof(scene::Color) / sizeof(float);
    const auto component = [&](float scene::Color::*of, std::array<float, kMostPoints>& to) {
        mix_points(Table(&(colors->*of), kStride, entries), blends, count, to.data());
    };
    const auto clear = [](const scene::Color& c) { return c.filter != 0.0f || c.transmit != 0.0f; };
    component(&scene::Color::red, out.red);
    component(&scene::Color::green, out.green);
    component(&scene::Color::blue, out.blue);
    if (points.density || std::none_of(colors, colors + entries, clear)) return out.fill_clear(0.0f);
    component(&scene::Color::filter, out.filter);
    component(&scene::Color::transmit, out.transmit);
}

}  // namespace texture
