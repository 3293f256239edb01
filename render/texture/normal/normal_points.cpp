#include "render/texture/evaluate_points.h"
#include "render/texture/noise/noise_points.h"
#include "render/texture/normal/normal_height.h"
#include "render/texture/points/point_lanes.h"
#include "render/texture/quilt.h"

#include <algorithm>
#include <array>

namespace texture {

namespace {

/// As many normals as there are lanes.
struct Normals {
    Double x, y, z;

    Normals of_unit_length() const
    {
        const Double inverse = Double(1.0) / xsimd::sqrt(x * x + y * y + z * z);
        return {x * inverse, y * inverse, z * inverse};
    }
    Normals times(const glm::dmat3& m) const
    {
        const auto row = [&](int k) { return Double(m[0][k]) * x + Double(m[1][k]) * y + Double(m[2][k]) * z; };
        return {row(0), row(1), row(2)};
    }
    void store(Points& n, std::size_t i) const
    {
        x.store_aligned(n.x.data() + i);
        y.store_aligned(n.y.data() + i);
        z.store_aligned(n.z.data() + i);
    }
};

Normals normals_at(const Points& n, std::size_t i) { return {get(n.x, i), get(n.y, i), get(n.z, i)}; }

}  // namespace

void normalize_points(Points& n)
{
    for (std::size_t i = 0; i < n.size(); i += kLanes) normals_at(n, i).of_unit_length().store(n, i);
}

namespace {

/// n + amount * (x, y, z) of every point, a vector at a time; `amount` by the place of the vector.
template <class Amount>
void move(Points& n, Amount&& amount, const Points& by)
{
    for (std::size_t i = 0; i < n.size(); i += kLanes) {
        const Double a = amount(i);
        (get(n.x, i) + a * get(by.x, i)).store_aligned(n.x.data() + i);
        (get(n.y, i) + a * get(by.y, i)).store_aligned(n.y.data() + i);
        (get(n.z, i) + a * get(by.z, i)).store_aligned(n.z.data() + i);
    }
}

/// by_height of normal.cpp: the pattern is asked at each corner for all points.
void bend_by_height(const TextureSet& set, const Normal& normal, const Pattern& pattern, const Points& p,
                    const Around& around, Points& n)
{
    const Double strength(height_strength(normal));
    Points q;
    Values v;
    q.count = p.count;
    for (const glm::dvec3& corner : kHeightCorners) {
        const glm::dvec3 step = normal.accuracy * corner;
        const auto shift = [&](Values& to, const Values& from, double by) {
            for (std::size_t i = 0; i < p.size(); i += kLanes) (get(from, i) + Double(by)).store_aligned(to.data() + i);
        };
        shift(q.x, p.x, step.x);
        shift(q.y, p.y, step.y);
        shift(q.z, p.z, step.z);
        q.pad();
        pattern_values(set, pattern, q, around, v);
        if (normal.map == Normal::Map::Slopes)
            for (std::size_t i = 0; i < p.size(); ++i) v[i] = slope_height(set, normal, v[i]);
        for (std::size_t i = 0; i < p.size(); i += kLanes) {
            const Double height = strength * get(v, i);
            (get(n.x, i) + height * Double(corner.x)).store_aligned(n.x.data() + i);
            (get(n.y, i) + height * Double(corner.y)).store_aligned(n.y.data() + i);
            (get(n.z, i) + height * Double(corner.z)).store_aligned(n.z.data() + i);
        }
    }
}

void bend_by_bumps(const Normal& normal, const Points& p, Points& n)
{
    Points v;
    vector_noise_points(p, kAllLive, v);
    move(
        n, [&](std::size_t) { return Double(normal.amount); }, v);
}

void bend_by_dents(const Normal& normal, const Pattern& pattern, const Points& p, Points& n)
{
    Values d;
    noise_points(p, pattern.noise_generator, d);
    Points v;
    vector_noise_points(p, kAllLive, v);
    move(
        n, [&](std::size_t i) { return Double(normal.amount) * get(d, i) * get(d, i) * get(d, i); }, v);
}

void bend_by_wrinkles(const Normal& normal, const Points& p, Points& n)
{
    constexpr int kOctaves = 10;
    Points q, v;
    q.count = p.count;
    double scale = 1.0;
    for (int octave = 0; octave < kOctaves; ++octave) {
        const auto part = [&](Values& to, const Values& from) {
            for (std::size_t i = 0; i < p.size(); i += kLanes)
                (Double(scale) * get(from, i)).store_aligned(to.data() + i);
        };
        part(q.x, p.x);
        part(q.y, p.y);
        part(q.z, p.z);
        q.pad();
        vector_noise_points(q, kAllLive, v);
        const auto size = [&](Values& of) {
            for (std::size_t i = 0; i < p.size(); i += kLanes) xsimd::abs(get(of, i)).store_aligned(of.data() + i);
        };
        size(v.x);
        size(v.y);
        size(v.z);
        move(
            n, [&](std::size_t) { return Double(normal.amount / scale); }, v);
        scale *= 2.0;
    }
}

/// by_waves of normal.cpp, in vectors.
void bend_by_waves(const TextureSet& set, const Normal& normal, const Pattern& pattern, const Points& p, bool waves,
                   Points& n)
{
    const Double count(static_cast<double>(set.wave_sources.size())), frequency(pattern.frequency),
        phase(pattern.phase), amount(normal.amount), zero(0.0), one(1.0);
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        const Double px = get(p.x, i), py = get(p.y, i), pz = get(p.z, i);
        Double nx = get(n.x, i), ny = get(n.y, i), nz = get(n.z, i);
        for (std::size_t source = 0; source < set.wave_sources.size(); ++source) {
            const glm::dvec3& at = set.wave_sources[source];
            const Double x = px - Double(at.x), y = py - Double(at.y), z = pz - Double(at.z);
            const Double length = xsimd::sqrt(x * x + y * y + z * z), l = xsimd::select(length == zero, one, length);
            const Double f(waves ? set.wave_frequencies[source] : 1.0), v = l * frequency * f + phase;
            const Double by = amount * cycle(v) / (f * l * count);
            nx = nx + by * x;
            ny = ny + by * y;
            nz = nz + by * z;
        }
        nx.store_aligned(n.x.data() + i);
        ny.store_aligned(n.y.data() + i);
        nz.store_aligned(n.z.data() + i);
    }
}

void bend_by_quilt(const Normal& normal, const Pattern& pattern, const Points& p, Points& n)
{
    const Double amount(normal.amount);
    for (std::size_t i = 0; i < p.size(); i += kLanes) {
        const Double x = quilt_offset(get(p.x, i)), y = quilt_offset(get(p.y, i)), z = quilt_offset(get(p.z, i));
        const Double by = amount *
                          quilt_height(xsimd::sqrt(x * x + y * y + z * z), pattern.numbers[0], pattern.numbers[1]);
        (get(n.x, i) + by * x).store_aligned(n.x.data() + i);
        (get(n.y, i) + by * y).store_aligned(n.y.data() + i);
        (get(n.z, i) + by * z).store_aligned(n.z.data() + i);
    }
}

void bend(const TextureSet& set, const Normal& normal, const Pattern& pattern, const Points& p, const Around& around,
          Points& n)
{
    switch (pattern.kind) {
    case PatternKind::Bumps: return bend_by_bumps(normal, p, n);
    case PatternKind::Dents: return bend_by_dents(normal, pattern, p, n);
    case PatternKind::Wrinkles: return bend_by_wrinkles(normal, p, n);
    case PatternKind::Ripples: return bend_by_waves(set, normal, pattern, p, false, n);
    case PatternKind::Waves: return bend_by_waves(set, normal, pattern, p, true, n);
    case PatternKind::Quilted: return bend_by_quilt(normal, pattern, p, n);
    case PatternKind::Facets:  // whose cells stand in lanes
        for (std::size_t i = 0; i < p.size(); ++i) n.set(i, facet_normal(pattern, n.at(i), p.at(i)));
        return n.pad();
    default: return bend_by_height(set, normal, pattern, p, around, n);
    }
}

/// m * n of each.
void multiply(const glm::dmat3& m, Points& n)
{
    for (std::size_t i = 0; i < n.size(); i += kLanes) normals_at(n, i).times(m).store(n, i);
}

}  // namespace

void normals_into(const TextureSet& set, const Pattern& pattern, bool keep_length, Points& n)
{
    if (!keep_length) normalize_points(n);
    for (std::uint32_t i = 0; i < pattern.warp_count; ++i)
        if (const auto* t = std::get_if<Affine>(&set.warps[pattern.first_warp + i])) multiply(t->normal_into, n);
    if (!keep_length) normalize_points(n);
}

void normals_out_of(const TextureSet& set, const Pattern& pattern, bool keep_length, Points& n)
{
    if (!keep_length) normalize_points(n);
    for (std::uint32_t i = pattern.warp_count; i-- > 0;)
        if (const auto* t = std::get_if<Affine>(&set.warps[pattern.first_warp + i]))
            multiply(glm::transpose(t->linear), n);
    if (!keep_length) normalize_points(n);
}

void normals_out_of(const TextureSet& set, std::span<const std::uint32_t> textures, const Values& reached, Points& n)
{
    for (std::size_t k = textures.size(); k-- > 0;) {
        const Texture& map = set.textures[textures[k]];
        const Pattern& pattern = set.patterns[map.pattern];
        for (std::size_t i = 0; i < n.size(); i += kLanes) {
            const auto within = get(reached, i) > Double(static_cast<double>(k));
            if (!xsimd::any(within)) continue;
            const Normals before = normals_at(n, i);
            Normals after = map.no_bump_scale ? before : before.of_unit_length();
            for (std::uint32_t w = pattern.warp_count; w-- > 0;)
                if (const auto* t = std::get_if<Affine>(&set.warps[pattern.first_warp + w]))
                    after = after.times(glm::transpose(t->linear));
            if (!map.no_bump_scale) after = after.of_unit_length();
            after.x = xsimd::select(within, after.x, before.x);
            after.y = xsimd::select(within, after.y, before.y);
            after.z = xsimd::select(within, after.z, before.z);
            after.store(n, i);
        }
    }
}

namespace {

/// by_map of normal.cpp for an average.
void average_normals(const TextureSet& set, const Normal& normal, const Points& p, const Around& around, Points& n)
{
    Points sum, child;
    sum.count = n.count;
    double weights = 0.0;
    for (Values* v : {&sum.x, &sum.y, &sum.z}) std::fill_n(v->data(), kMostPoints, 0.0);
    for (std::uint32_t i = normal.first; i < normal.first + normal.count; ++i) {
        const auto w = static_cast<double>(set.keys[i]);
        child.take(n);
        perturb_points(set, set.children[i], p, around, child);
        move(
            sum, [&](std::size_t) { return Double(w); }, child);
        weights += w;
    }
    for (std::size_t i = 0; i < n.size(); i += kLanes) {
        (get(sum.x, i) / Double(weights)).store_aligned(n.x.data() + i);
        (get(sum.y, i) / Double(weights)).store_aligned(n.y.data() + i);
        (get(sum.z, i) / Double(weights)).store_aligned(n.z.data() + i);
    }
}

/// The same for a map: each entry for the points that show it, then the mixture.
void mix_normals(const TextureSet& set, const Normal& normal, const Pattern& pattern, const Points& p,
                 const Around& around, Points& n)
{
    Values values;
    pattern_values(set, pattern, p, around, values);
    std::array<Blend, kMostPoints> blends;
    std::uint32_t first = normal.first + normal.count, last = normal.first;
    for (std::size_t i = 0; i < p.size(); ++i) {
        blends[i] = blend_at(set, normal.first, normal.count, values[i]);
        first = std::min(first, blends[i].lower);
        last = std::max(last, blends[i].upper);
    }
    std::array<glm::dvec3, kMostPoints> lower, upper;
    for (std::uint32_t entry = first; entry <= last; ++entry) {
        Points places, bent;
        Around those;
        std::array<std::uint8_t, kMostPoints> owner;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (blends[i].lower != entry && blends[i].upper != entry) continue;
            those[places.size()] = around[i];
            owner[places.size()] = static_cast<std::uint8_t>(i);
            places.add(p.at(i));
            bent.add(n.at(i));
        }
        if (places.count == 0) continue;
        places.pad();
        bent.pad();
        perturb_points(set, set.children[entry], places, those, bent);
        for (std::size_t k = 0; k < places.size(); ++k)
            (blends[owner[k]].upper == entry ? upper : lower)[owner[k]] = bent.at(k);
    }
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double share = blends[i].share;
        n.set(i, blends[i].lower == blends[i].upper ? upper[i] : (1.0 - share) * lower[i] + share * upper[i]);
    }
    n.pad();
}

}  // namespace

void perturb_points(const TextureSet& set, std::uint32_t index, const Points& p, const Around& around, Points& n)
{
    using Map = Normal::Map;
    const Normal& normal = set.normals[index];
    Points q;
    if (normal.map == Map::Uv) {
        for (std::size_t i = 0; i < p.size(); ++i) q.add({around[i]->uv.x, around[i]->uv.y, 0.0});
        q.pad();
        return perturb_points(set, set.children[normal.first], q, around, n);
    }
    const Pattern& pattern = set.patterns[normal.pattern];
    q.take(p);
    warp_points(set, pattern, q, kAllLive);
    normals_into(set, pattern, normal.no_bump_scale, n);
    if (normal.map == Map::Normals) mix_normals(set, normal, pattern, q, around, n);
    else if (normal.map == Map::Average) average_normals(set, normal, q, around, n);
    else if (normal.map == Map::Image) image_bumps(set.images[pattern.data], normal.amount, q, n);
    else bend(set, normal, pattern, q, around, n);
    normals_out_of(set, pattern, normal.no_bump_scale, n);
    if (!normal.no_bump_scale || normal.map == Map::Normals) normalize_points(n);
}

}  // namespace texture
