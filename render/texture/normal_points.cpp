#include "render/texture/evaluate_points.h"
#include "render/texture/noise_points.h"
#include "render/texture/normal_height.h"

namespace texture {
namespace {

/// by_height of normal.cpp: the pattern is asked at each corner for all points.
void bend_by_height(const TextureSet& set, const Normal& normal, const Pattern& pattern, const Points& p, const Around& around, Normals& n)
{
    const double strength = height_strength(normal);
    Points q;
    Values v;
    for (const glm::dvec3& corner : kHeightCorners) {
        q.count = 0;
        for (std::size_t i = 0; i < p.size(); ++i) q.add(p.at(i) + normal.accuracy * corner);
        q.pad();
        pattern_values(set, pattern, q, around, v);
        for (std::size_t i = 0; i < p.size(); ++i)
            n[i] += strength * (normal.map == Normal::Map::Slopes ? slope_height(set, normal, v[i]) : v[i]) * corner;
    }
}

void bend_by_bumps(const Normal& normal, const Points& p, Normals& n)
{
    Points v;
    vector_noise_points(p, kAllLive, v);
    for (std::size_t i = 0; i < p.size(); ++i) n[i] += normal.amount * v.at(i);
}

void bend_by_dents(const Normal& normal, const Pattern& pattern, const Points& p, Normals& n)
{
    Values d;
    noise_points(p, pattern.noise_generator, d);
    Points v;
    vector_noise_points(p, kAllLive, v);
    for (std::size_t i = 0; i < p.size(); ++i) n[i] += normal.amount * d[i] * d[i] * d[i] * v.at(i);
}

void bend_by_wrinkles(const Normal& normal, const Points& p, Normals& n)
{
    constexpr int kOctaves = 10;
    Points q, v;
    double scale = 1.0;
    for (int octave = 0; octave < kOctaves; ++octave) {
        q.count = 0;
        for (std::size_t i = 0; i < p.size(); ++i) q.add(scale * p.at(i));
        q.pad();
        vector_noise_points(q, kAllLive, v);
        for (std::size_t i = 0; i < p.size(); ++i) n[i] += normal.amount / scale * glm::abs(v.at(i));
        scale *= 2.0;
    }
}

/// False: this kind is asked point by point.
bool bend(const TextureSet& set, const Normal& normal, const Pattern& pattern, const Points& p, const Around& around, Normals& n)
{
    switch (pattern.kind) {
    case PatternKind::Bumps: bend_by_bumps(normal, p, n); return true;
    case PatternKind::Dents: bend_by_dents(normal, pattern, p, n); return true;
    case PatternKind::Wrinkles: bend_by_wrinkles(normal, p, n); return true;
    case PatternKind::Ripples:
    case PatternKind::Waves:
    case PatternKind::Quilted:
    case PatternKind::Facets: return false;
    default: bend_by_height(set, normal, pattern, p, around, n); return true;
    }
}

}  // namespace

void perturb_points(const TextureSet& set, std::uint32_t index, const Points& p, const Around& around, Normals& n)
{
    const Normal& normal = set.normals[index];
    const bool heights = normal.map == Normal::Map::None || normal.map == Normal::Map::Slopes;
    if (heights) {
        const Pattern& pattern = set.patterns[normal.pattern];
        Points q = p;
        warp_points(set, pattern, q, kAllLive);
        Normals local;
        for (std::size_t i = 0; i < p.size(); ++i) local[i] = normal_into(set, pattern, n[i], normal.no_bump_scale);
        if (bend(set, normal, pattern, q, around, local)) {
            for (std::size_t i = 0; i < p.size(); ++i) {
                const glm::dvec3 out = normal_out_of(set, pattern, local[i], normal.no_bump_scale);
                n[i] = normal.no_bump_scale ? out : glm::normalize(out);
            }
            return;
        }
    }
    for (std::size_t i = 0; i < p.size(); ++i) {
        Surroundings own = *around[i];
        n[i] = perturb(set, index, n[i], p.at(i), own);
    }
}

}  // namespace texture
