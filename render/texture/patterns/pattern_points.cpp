#include "csg/world/inside_index.h"
#include "render/texture/points/angle.h"
#include "render/texture/evaluate_points.h"
#include "render/texture/map_points.h"
#include "render/texture/noise/noise_points.h"
#include "render/texture/entries.h"
#include "render/texture/points/point_lanes.h"
#include "render/texture/patterns/patterns.h"
#include "render/texture/patterns/turning.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace texture {
namespace {


void turbulence_values(const Pattern& pattern, const Points& p, Values& out)
{
    const scene::Turbulence& t = pattern.turbulence;
    scalar_turbulence_points(p, t.octaves, t.lambda, t.omega, pattern.noise_generator, out);
}

void wood_values(const Pattern& pattern, const Points& p, Values& out)
{
    if (!pattern.has_turbulence) {
        for (std::size_t i = 0; i < p.size(); ++i) out[i] = wood(pattern, p.at(i));
        return;
    }
    const scene::Turbulence& t = pattern.turbulence;
    Points moved;
    vector_turbulence_points(p, t.octaves, t.lambda, t.omega, 3, moved);
    // wood_ring() of each
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        const auto get = [i](const Values& v) { return Double::load_aligned(v.data() + i); };
        const Double px = get(p.x), py = get(p.y);
        const Double x = px + series_cycle((px + get(moved.x)) * Double(t.amount.x)),
                     y = py + series_cycle((py + get(moved.y)) * Double(t.amount.y));
        xsimd::sqrt(x * x + y * y).store_aligned(out.data() + i);
    }
}

/// agate_band() of each; `out` holds the turbulence.
void agate_bands(const Pattern& pattern, const Points& p, Values& out)
{
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        const Double turbulence = Double::load_aligned(out.data() + i), z = Double::load_aligned(p.z.data() + i);
        const Double c = (Double(1.0) + series_cycle(Double(1.3 * pattern.numbers[0]) * turbulence + Double(1.1) * z)) /
                         Double(2.0);
        agate_power(c).store_aligned(out.data() + i);
    }
}

/// spherical, cylindrical or planar of each: 1 less the distance from a point, an axis or a plane, to 0.
enum class From { Point, Axis, Plane };
template <From What>
void distance_values(const Points& p, Values& out)
{
    const Double zero(0.0), one(1.0);
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        const auto square = [i](const Values& v) {
            const Double d = Double::load_aligned(v.data() + i);
            return d * d;
        };
        Double distance;
        if constexpr (What == From::Point) distance = xsimd::sqrt(square(p.x) + square(p.y) + square(p.z));
        else if constexpr (What == From::Axis) distance = xsimd::sqrt(square(p.x) + square(p.z));
        else distance = xsimd::abs(Double::load_aligned(p.y.data() + i));
        xsimd::select(distance > one, zero, one - distance).store_aligned(out.data() + i);
    }
}

/// boxed of each.
void boxed_values(const Points& p, Values& out)
{
    const Double zero(0.0), one(1.0);
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        const auto size = [i](const Values& v) { return xsimd::abs(Double::load_aligned(v.data() + i)); };
        const Double x = size(p.x), y = size(p.y), z = size(p.z);
        const Double xy = xsimd::select(x < y, y, x), distance = xsimd::select(xy < z, z, xy);
        xsimd::select(distance > one, zero, one - distance).store_aligned(out.data() + i);
    }
}

/// Whether v modulo 2 is 1, as floor_mod() of the single points has it.
auto odd(const Double& v) { return v - Double(2.0) * xsimd::floor(v / Double(2.0)) == Double(1.0); }

void spiral_values(const Pattern& pattern, const Points& p, Values& out)
{
    const double arms = std::trunc(pattern.numbers[0]);
    const Double amount(pattern.turbulence.amount.x);
    if (pattern.has_turbulence) turbulence_values(pattern, p, out);
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        const Double x = get(p.x, i), y = get(p.y, i);
        Double phase = spiral_phase(arms, x, y, get(p.z, i));
        if (pattern.has_turbulence) phase = phase + amount * get(out, i);
        if (pattern.kind == PatternKind::Spiral2) phase = triangle(spiral_radius(x, y)) + triangle(phase);
        phase.store_aligned(out.data() + i);
    }
}

void checker_values(const Points& p, Values& out)
{
    const Double tiny(kTiny);
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        const Double sum = xsimd::floor(get(p.x, i) + tiny) + xsimd::floor(get(p.y, i) + tiny) +
                           xsimd::floor(get(p.z, i) + tiny);
        xsimd::select(odd(sum), Double(1.0), Double(0.0)).store_aligned(out.data() + i);
    }
}

void square_values(const Points& p, Values& out)
{
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        const auto b = odd(xsimd::floor(get(p.z, i)));
        const Double a = xsimd::select(b, Double(2.0), Double(3.0)), not_a = xsimd::select(b, Double(1.0), Double(0.0));
        xsimd::select(odd(xsimd::floor(get(p.x, i))), a, not_a).store_aligned(out.data() + i);
    }
}

void brick_values(const Pattern& pattern, const Points& p, Values& out)
{
    const glm::dvec3& size = pattern.vector;
    const double mortar = pattern.numbers[0];
    const Double shift(mortar + kTiny), zero(0.0), half(0.5), one(1.0);
    const auto fraction = [&](const Double& v) {  // positive_fraction()
        const Double f = v - xsimd::trunc(v);
        return xsimd::select(f < zero, f + one, f);
    };
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        const Double x = get(p.x, i) + shift, y = get(p.y, i) + shift, z = get(p.z, i) + shift;
        const auto lower = fraction(y / Double(2.0 * size.y)) <= half;
        const auto joint =
            (fraction(y / Double(size.y)) <= Double(mortar / size.y)) |
            (fraction(x / Double(size.x) + xsimd::select(lower, zero, half)) <= Double(mortar / size.x)) |
            (fraction(z / Double(size.z) + xsimd::select(lower, half, zero)) <= Double(mortar / size.z));
        xsimd::select(joint, zero, one).store_aligned(out.data() + i);
    }
}

/// The remainder by 1 is exact, as fmod's.
void gradient_values(const Pattern& pattern, const Points& p, Values& out)
{
    const Double x(pattern.vector.x), y(pattern.vector.y), z(pattern.vector.z), one(1.0);
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        const Double d = get(p.x, i) * x + get(p.y, i) * y + get(p.z, i) * z;
        xsimd::select(d > one, d - xsimd::floor(d), d).store_aligned(out.data() + i);
    }
}

void onion_values(const Points& p, Values& out)
{
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        const Double x = get(p.x, i), y = get(p.y, i), z = get(p.z, i), l = xsimd::sqrt(x * x + y * y + z * z);
        (l - xsimd::floor(l)).store_aligned(out.data() + i);
    }
}

/// How bright another pigment is.
void grey_values(const TextureSet& set, const Pattern& pattern, const Points& p, const Around& around, Values& out)
{
    ColorPoints colors;
    pigment_colors(set, pattern.pigment, p, around, colors);
    for (std::size_t i = 0; i < p.size(); ++i) out[i] = static_cast<double>(scene::grey(colors.at(i).rgb()));
}

/// Whether an object holds them.
void object_values(const csg::InsideIndex& object, const Points& p, Values& out)
{
    const std::uint64_t held = object.holds(p.x.data(), p.y.data(), p.z.data(), p.size());
    for (std::size_t i = 0; i < p.size(); ++i) out[i] = static_cast<double>(held >> i & 1);
}

/// Where a map of colours shows its first or its last one.
FlatEnds flat_ends(const float* keys, const scene::Color* colors, std::uint32_t entries)
{
    const auto is_number = [](const scene::Color& c) {
        return std::isfinite(c.red + c.green + c.blue + c.filter + c.transmit);
    };
    FlatEnds out;
    if (!std::is_sorted(keys, keys + entries)) return out;
    std::uint32_t low = 0, high = entries - 1;
    while (low + 1 < entries && colors[low + 1] == colors[0]) ++low;
    while (high > 0 && colors[high - 1] == colors[entries - 1]) --high;
    if (is_number(colors[0])) out.low = static_cast<double>(keys[low]);
    if (is_number(colors[entries - 1])) out.high = static_cast<double>(keys[high]);
    return out;
}

/// The same for the values of a pattern before frequency and wave.
FlatEnds raw_flat_ends(const TextureSet& set, const Pigment& pigment, const Pattern& pattern)
{
    const bool sums_octaves = pattern.kind == PatternKind::Granite || pattern.kind == PatternKind::Wrinkles;
    const bool as_it_is = pattern.wave == scene::WaveForm::Ramp && pattern.frequency == 1.0 && pattern.phase == 0.0;
    if (!sums_octaves || !as_it_is) return {};
    return flat_ends(set.keys.data() + pigment.first, set.colors.data() + pigment.first, pigment.count);
}

/// Before frequency and wave. Of a value in a flat end any other from there may be told.
void raw_values(const TextureSet& set, const Pattern& pattern, const Points& p, const Around& around,
                const FlatEnds& flat, Values& out)
{
    const int generator = pattern.noise_generator;
    switch (pattern.kind) {
    case PatternKind::Bozo:
    case PatternKind::Bumps: return noise_points(p, generator, out);
    case PatternKind::Dents:
        noise_points(p, generator, out);
        for (std::size_t i = 0; i < p.size(); ++i) out[i] = out[i] * out[i] * out[i];
        return;
    case PatternKind::Granite: return octave_points(p, OctaveSum::Granite, generator, flat, out);
    case PatternKind::Wrinkles: return octave_points(p, OctaveSum::Wrinkles, generator, flat, out);
    case PatternKind::Agate:
        turbulence_values(pattern, p, out);
        agate_bands(pattern, p, out);
        return;
    case PatternKind::Marble:
        if (pattern.has_turbulence) turbulence_values(pattern, p, out);
        for (std::size_t i = 0; i < p.size(); ++i)
            out[i] = pattern.has_turbulence ? p.x[i] + pattern.turbulence.amount.x * out[i] : p.x[i];
        return;
    case PatternKind::Wood: return wood_values(pattern, p, out);
    case PatternKind::Spherical: return distance_values<From::Point>(p, out);
    case PatternKind::Cylindrical: return distance_values<From::Axis>(p, out);
    case PatternKind::Planar: return distance_values<From::Plane>(p, out);
    case PatternKind::Boxed: return boxed_values(p, out);
    case PatternKind::Checker: return checker_values(p, out);
    case PatternKind::Square: return square_values(p, out);
    case PatternKind::Brick: return brick_values(pattern, p, out);
    case PatternKind::Gradient: return gradient_values(pattern, p, out);
    case PatternKind::Onion: return onion_values(p, out);
    case PatternKind::DensityFile: return density_values(pattern, *set.volumes[pattern.data], p, out);
    case PatternKind::Object: return object_values(*set.objects[pattern.data], p, out);
    case PatternKind::Potential: return potential_values(set.potentials[pattern.data], pattern, p, out);
    case PatternKind::Function: return function_values(set, pattern, p, out);
    case PatternKind::Image: return image_values(set.images[pattern.data], p, out);
    case PatternKind::PigmentPattern: return grey_values(set, pattern, p, around, out);
    case PatternKind::Spiral1:
    case PatternKind::Spiral2: return spiral_values(pattern, p, out);
    case PatternKind::Radial: return radial_values(p, out);
    case PatternKind::Quilted: return quilted_values(pattern, p, out);
    case PatternKind::Leopard: return leopard_values(p, out);
    case PatternKind::Ripples: return ripples_values(set, pattern, p, out);
    case PatternKind::Waves: return waves_values(set, pattern, p, out);
    case PatternKind::Crackle: return crackle_values(pattern, p, out);
    case PatternKind::Mandel:
    case PatternKind::Julia:
    case PatternKind::MagnetMandel:
    case PatternKind::MagnetJulia: return fractal_values(pattern, p, out);
    default: break;
    }
    for (std::size_t i = 0; i < p.size(); ++i) out[i] = raw_pattern(set, pattern, p.at(i), *around[i]);
}

/// Components of the point that a raw value depends on.
unsigned live_components(const Pattern& pattern)
{
    switch (pattern.kind) {
    case PatternKind::Gradient: {
        unsigned live = 0;
        for (int k = 0; k < 3; ++k)
            if (pattern.vector[k] != 0.0) live |= 1u << k;
        return live == 0 ? kAllLive : live;
    }
    case PatternKind::Planar: return 2;
    case PatternKind::Cylindrical:
    case PatternKind::Radial: return 5;
    case PatternKind::Mandel:
    case PatternKind::Julia:
    case PatternKind::MagnetMandel:
    case PatternKind::MagnetJulia: return 3;
    case PatternKind::Marble: return pattern.has_turbulence ? kAllLive : 1u;
    default: return kAllLive;
    }
}

/// Points that look at the same entry of a map.
struct Group {
    Points points;
    Around around;
    std::array<std::uint8_t, kMostPoints> owner;

    void add(const Points& from, const Around& all, std::size_t i)
    {
        const std::size_t k = points.size();
        points.add(from.at(i));
        around[k] = all[i];
        owner[k] = static_cast<std::uint8_t>(i);
    }
};

/// Whether these points show the entry and no other.
bool of_one_entry(const BlendPoints& blends, std::uint32_t entry, std::uint64_t points)
{
    return (points & ~(numbers::lanes::equal(blends.lower, entry) & numbers::lanes::equal(blends.upper, entry))) == 0;
}

/// Each child for the points that need it, once; then the mixture.
void mapped_colors(const TextureSet& set, const Pigment& pigment, const BlendPoints& blends, const Points& p,
                   const Around& around, ColorPoints& out)
{
    ColorPoints upper, found;
    Group group;
    const std::uint64_t all = first_bits(p.size());
    bool mixed = true;
    each_entry(blends, pigment.count, p.size(), [&](std::uint32_t entry, std::uint64_t which) {
        const std::uint32_t child = set.children[pigment.first + entry];
        const auto owner_gets = [&](std::size_t i, const scene::Color& c) {
            (blends.lower[i] == entry ? out : upper).set(i, c);
        };
        if (which == all && of_one_entry(blends, entry, all)) {
            mixed = false;
            return pigment_colors(set, child, p, around, out);
        }
        if (set.pigments[child].kind == Pigment::Kind::Solid) {
            for (; which != 0; which &= which - 1)
                owner_gets(static_cast<std::size_t>(std::countr_zero(which)), set.pigments[child].color);
            return;
        }
        group.points.count = 0;
        group.points.density = p.density;
        for (; which != 0; which &= which - 1) group.add(p, around, static_cast<std::size_t>(std::countr_zero(which)));
        group.points.pad();
        pigment_colors(set, child, group.points, group.around, found);
        for (std::size_t k = 0; k < group.points.size(); ++k) owner_gets(group.owner[k], found.at(k));
    });
    for (std::size_t i = 0; mixed && i < p.size(); ++i)
        if (blends.lower[i] != blends.upper[i])
            out.set(i, mix(set.working, pigment.blending, out.at(i), upper.at(i), blends.share[i]));
}

bool all_equal(const Values& values, std::size_t count)
{
    const Double first(values[0]);
    for (std::size_t i = 0; i < count; i += kLanes) {
        const std::uint32_t equal = numbers::lanes::mask(get(values, i) == first);
        const std::uint32_t wanted = count - i < kLanes ? (1u << (count - i)) - 1 : (1u << kLanes) - 1;
        if ((equal & wanted) != wanted) return false;
    }
    return true;
}

void average_colors(const TextureSet& set, const Pigment& pigment, const Points& p, const Around& around,
                    ColorPoints& out)
{
    ColorPoints found;
    std::array<scene::Color, kMostPoints> sums{};
    float weights = 0;
    for (std::uint32_t i = pigment.first; i < pigment.first + pigment.count; ++i) {
        pigment_colors(set, set.children[i], p, around, found);
        weights += set.keys[i];
        for (std::size_t k = 0; k < p.size(); ++k) add_weighted(sums[k], set.keys[i], found.at(k));
    }
    for (std::size_t k = 0; k < p.size(); ++k) out.set(k, divided(sums[k], weights));
}

}  // namespace

void pattern_values(const TextureSet& set, const Pattern& pattern, const Points& p, const Around& around, Values& out)
{
    raw_values(set, pattern, p, around, {}, out);
    waved_points(pattern, p.size(), out);
}

void pigment_colors(const TextureSet& set, std::uint32_t index, const Points& p, const Around& around, ColorPoints& out)
{
    const Pigment& pigment = set.pigments[index];
    if (pigment.kind == Pigment::Kind::Uv) {
        Points places;
        for (std::size_t i = 0; i < p.size(); ++i) places.add({around[i]->uv.x, around[i]->uv.y, 0.0});
        places.pad();
        return pigment_colors(set, set.children[pigment.first], places, around, out);
    }
    if (pigment.kind == Pigment::Kind::Solid) return out.fill(pigment.color);
    const bool color_map = pigment.kind == Pigment::Kind::ColorMap;
    const Pattern& pattern = set.patterns[pigment.pattern];
    Points q;
    q.take(p);
    warp_points(set, pattern, q, color_map ? live_components(pattern) : kAllLive);
    if (pigment.kind == Pigment::Kind::Average) return average_colors(set, pigment, q, around, out);
    if (pigment.kind == Pigment::Kind::Functions)
        return function_colors(set, set.color_functions[pigment.first], q, out);
    if (pigment.kind == Pigment::Kind::Image) return images_shown(set.images[pattern.data], q, out);
    Values values;
    raw_values(set, pattern, q, around, color_map ? raw_flat_ends(set, pigment, pattern) : FlatEnds{}, values);
    if (color_map && all_equal(values, q.size()))  // as beside a ball of density
        return out.fill(
            mapped(set, pigment.blending, blend_at(set, pigment.first, pigment.count, waved(pattern, values[0]))));
    waved_points(pattern, q.size(), values);
    if (color_map) return color_map_points(set, pigment, values, q, out);
    BlendPoints blends;
    map_blends(set, pigment.first, pigment.count, values, p.size(), blends);
    mapped_colors(set, pigment, blends, q, around, out);
}

}  // namespace texture
