#include "numbers/functions/unit_again.h"
#include "render/texture/points/angle.h"
#include "render/texture/evaluate_points.h"
#include "render/texture/noise/nearest_cells.h"
#include "render/texture/noise/noise.h"
#include "render/texture/normal/normal_height.h"
#include "render/texture/quilt.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace texture {
namespace {

/// glm::normalize(), number by number.
glm::dvec3 unit(const glm::dvec3& n)
{
    const double x = n.x, y = n.y, z = n.z, inverse = glm::inversesqrt(x * x + y * y + z * z);
    return {x * inverse, y * inverse, z * inverse};
}

/// Component i of the result is n . (image of axis i under the forward transformation), the forward one being
/// the inverse of what the warp holds (spec 4, 15.1).
glm::dvec3 into(const Affine& t, const glm::dvec3& n) { return t.normal_into * n; }
glm::dvec3 out_of(const Affine& t, const glm::dvec3& n) { return glm::transpose(t.linear) * n; }

glm::dvec3 by_height(const TextureSet& set, const Normal& normal, const Pattern& pattern, const glm::dvec3& n,
                     const glm::dvec3& p, const Surroundings& around)
{
    const double strength = height_strength(normal);
    // The corners are near each other: mostly in one cell of what the pattern is made of.
    Points corners;
    Around all;
    for (const glm::dvec3& corner : kHeightCorners) {
        all[corners.size()] = &around;
        corners.add(p + normal.accuracy * corner);
    }
    corners.pad();
    Values values;
    pattern_values(set, pattern, corners, all, values);
    glm::dvec3 out = n;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double v = values[i];
        out += strength * (normal.map == Normal::Map::Slopes ? slope_height(set, normal, v) : v) * kHeightCorners[i];
    }
    return out;
}

glm::dvec3 by_waves(const TextureSet& set, const Normal& normal, const Pattern& pattern, glm::dvec3 n,
                    const glm::dvec3& p, bool waves)
{
    const auto count = static_cast<double>(set.wave_sources.size());
    for (std::size_t i = 0; i < set.wave_sources.size(); ++i) {
        const glm::dvec3 from = p - set.wave_sources[i];
        double l = glm::length(from);
        if (l == 0.0) l = 1.0;
        const double f = waves ? set.wave_frequencies[i] : 1.0;
        n += normal.amount * cycle(l * pattern.frequency * f + pattern.phase) / (f * l * count) * from;
    }
    return n;
}

glm::dvec3 wrinkled(const Normal& normal, glm::dvec3 n, const glm::dvec3& p)
{
    double scale = 1.0;
    for (int i = 0; i < 10; ++i) {
        n += normal.amount / scale * glm::abs(vector_noise(scale * p));
        scale *= 2.0;
    }
    return n;
}

glm::dvec3 by_pattern(const TextureSet& set, const Normal& normal, const Pattern& pattern, const glm::dvec3& n,
                      const glm::dvec3& p, const Surroundings& around)
{
    switch (pattern.kind) {
    case PatternKind::Bumps: return n + normal.amount * vector_noise(p);
    case PatternKind::Dents: {
        const double d = noise(p, pattern.noise_generator);
        return n + normal.amount * d * d * d * vector_noise(p);
    }
    case PatternKind::Wrinkles: return wrinkled(normal, n, p);
    case PatternKind::Ripples: return by_waves(set, normal, pattern, n, p, false);
    case PatternKind::Waves: return by_waves(set, normal, pattern, n, p, true);
    case PatternKind::Quilted: {
        const glm::dvec3 u = quilt_offset(p);
        return n + normal.amount * quilt_height(glm::length(u), pattern.numbers[0], pattern.numbers[1]) * u;
    }
    case PatternKind::Facets: return facet_normal(pattern, n, p);
    default: return by_height(set, normal, pattern, n, p, around);
    }
}

/// The blend of the normals of a map; each starts from the same `n`.
glm::dvec3 by_map(const TextureSet& set, const Normal& normal, const Pattern& pattern, const glm::dvec3& n,
                  const glm::dvec3& p, Surroundings& around)
{
    if (normal.map == Normal::Map::Average) {
        glm::dvec3 sum(0);
        double weights = 0;
        for (std::uint32_t i = normal.first; i < normal.first + normal.count; ++i) {
            const auto w = static_cast<double>(set.keys[i]);
            sum += w * perturb(set, set.children[i], n, p, around);
            weights += w;
        }
        return sum / weights;
    }
    const Blend b = blend_at(set, normal.first, normal.count, pattern_value(set, pattern, p, around));
    // The upper one first: a slope in the lower one sees the normal that it leaves.
    const glm::dvec3 upper = perturb(set, set.children[b.upper], n, p, around);
    if (b.lower == b.upper) return upper;
    return (1.0 - b.share) * perturb(set, set.children[b.lower], n, p, around) + b.share * upper;
}

}  // namespace

// numbers: size, coords, metric
glm::dvec3 facet_normal(const Pattern& pattern, const glm::dvec3& raw, const glm::dvec3& p)
{
    const glm::dvec3 n = glm::normalize(raw);
    const double size = pattern.numbers[0], coords = pattern.numbers[1], metric = pattern.numbers[2];
    const double scale = size < 1e-6 ? 1e6 : 1.0 / size;
    const glm::dvec3 t = (coords == 0.0 ? n : p) * scale;
    const glm::dvec3 nearest = nearest_cells(t, cell_points(glm::floor(t - kTiny)), metric, true, 1).point;
    if (coords == 0.0) return nearest;
    glm::dvec3 d = vector_noise(nearest);
    d -= glm::dot(d, n) * n;
    return n + coords * d;
}

// Nests of maps wait for one space after the other: what is of unit length as a rule is made so again without a root,
// and a number by itself stays in a register.

glm::dvec3 normal_into(const TextureSet& set, const Pattern& pattern, glm::dvec3 n, bool keep_length)
{
    if (!keep_length) n = numbers::unit_again(n);
    for (std::uint32_t i = 0; i < pattern.warp_count; ++i)
        if (const auto* t = std::get_if<Affine>(&set.warps[pattern.first_warp + i])) n = into(*t, n);
    if (!keep_length) n = unit(n);
    return n;
}

glm::dvec3 normal_out_of(const TextureSet& set, const Pattern& pattern, glm::dvec3 n, bool keep_length)
{
    if (!keep_length) n = numbers::unit_again(n);
    for (std::uint32_t i = pattern.warp_count; i-- > 0;)
        if (const auto* t = std::get_if<Affine>(&set.warps[pattern.first_warp + i])) n = out_of(*t, n);
    if (!keep_length) n = unit(n);
    return n;
}

glm::dvec3 perturb(const TextureSet& set, std::uint32_t index, const glm::dvec3& n, const glm::dvec3& p,
                   Surroundings& around)
{
    const Normal& normal = set.normals[index];
    if (normal.map == Normal::Map::Uv)
        return perturb(set, set.children[normal.first], n, {around.uv.x, around.uv.y, 0.0}, around);
    const Pattern& pattern = set.patterns[normal.pattern];
    glm::dvec3 local = normal_into(set, pattern, n, normal.no_bump_scale);
    const glm::dvec3 q = warp_point(set, pattern, p);
    const bool mapped = normal.map == Normal::Map::Normals || normal.map == Normal::Map::Average;
    if (normal.map == Normal::Map::Image) local = image_bump(set.images[pattern.data], normal.amount, local, q);
    else
        local = mapped ? by_map(set, normal, pattern, local, q, around)
                       : by_pattern(set, normal, pattern, local, q, around);
    const glm::dvec3 out = normal_out_of(set, pattern, local, normal.no_bump_scale);
    // Without bump scaling a lone normal stays unnormalised until the layer's own is done; the layer normalises. What a
    // map makes of two neighbours, not an average, is normalised all the same. A slope sees either as it is here (spec
    // 4, 15.1).
    around.normal = normal.no_bump_scale && normal.map != Normal::Map::Normals ? out : numbers::unit_again(out);
    return around.normal;
}

}  // namespace texture
