#pragma once

#include "csg/freeform/shared/ray_batch.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <memory>
#include <vector>

/// What a batch of rays is told, beside what each of them is told alone.
namespace csg_test {

inline bool same_number(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

struct Told {
    std::vector<double> t;
    std::vector<std::uint32_t> face;

    explicit Told(const csg::IntersectionList& record)
    {
        record.each_span([&](double in, std::uint32_t in_face, double out, std::uint32_t out_face) {
            add(in, in_face);
            add(out, out_face);
        });
        record.each_touching([&](double at, std::uint32_t of) { add(at, of); });
    }

private:
    void add(double at, std::uint32_t of)
    {
        t.push_back(at);
        face.push_back(of);
    }
};

/// Rays from outside, from inside and from far away, some along axes, some with a direction of another length.
inline csg::Ray ray_to(Rng& rng, double size)
{
    const double away[] = {0.5, 3.0, 3.0, 20.0, 1e7};
    csg::Ray ray = ray_near(rng, glm::dvec3(0.0), size, away[rng.below(5)] * size);
    if (rng.below(6) == 0) {
        const int axis = rng.below(3);
        ray.origin = rng.point(size);
        ray.origin[axis] = -3.0 * size;
        ray.direction = glm::dvec3(0.0);
        ray.direction[axis] = 1.0;
    }
    if (rng.below(4) == 0) ray.direction *= rng.uniform(0.01, 100.0);
    return ray;
}

/// Batches of 1 to 64 rays are told what each of them is told alone, for the nearest end and for all. Returns how many
/// ends were told.
template <class Many, class One>
int check_batch(double size, std::uint32_t seed, Many&& many_of, One&& one_of)
{
    Rng rng(seed);
    const auto batch = std::make_unique<csg::RayBatch>();
    const int count = rng.below(4) == 0 ? 1 + rng.below(4) : 1 + rng.below(csg::kTileRays);
    const bool first_only = rng.coin();
    for (int k = 0; k < count; ++k) {
        const csg::Ray ray = rng.below(40) == 0 ? hostile_ray(rng) : ray_to(rng, size);
        const double length = glm::length(ray.direction),
                     from = rng.coin() ? 0.0 : rng.uniform(-2.0, 4.0) * size / length;
        const double to = rng.coin() ? numbers::kInfinity : from + rng.uniform(0.0, 5.0) * size / length;
        batch->add(ray, static_cast<std::size_t>(k), from, to, first_only);
    }
    const auto rays = batch->rays;
    many_of(*batch);
    int ends = 0;
    for (std::size_t k = 0; k < batch->count; ++k) {
        const csg::IntersectionList& asked = batch->records[k];
        csg::IntersectionList alone(asked.from, asked.to, asked.first_only);
        one_of(rays[k], alone);
        const Told many(asked), one(alone);
        const csg::Ray& ray = rays[k];
        INFO("seed " << seed << ", ray " << k << " of " << count << ": origin " << ray.origin.x << ' ' << ray.origin.y
                     << ' ' << ray.origin.z << ", direction " << ray.direction.x << ' ' << ray.direction.y << ' '
                     << ray.direction.z << ", from " << asked.from << " to " << asked.to << ", first " << first_only);
        REQUIRE(many.face == one.face);
        for (std::size_t i = 0; i < one.t.size(); ++i) {
            INFO("end " << i << ": " << many.t[i] << ", alone " << one.t[i]);
            REQUIRE(same_number(many.t[i], one.t[i]));
        }
        ends += static_cast<int>(one.t.size());
    }
    return ends;
}

template <class Shape>
int check_many(const Shape& shape, double size, std::uint32_t seed)
{
    static_assert(csg::IntersectsMany<Shape>);
    REQUIRE(shape.intersects_many());
    return check_batch(
        size, seed, [&](csg::RayBatch& batch) { shape.intersect_many(batch.asked(), batch.records.data()); },
        [&](const csg::Ray& ray, csg::IntersectionList& out) { shape.intersect(ray, out); });
}

/// Whether this machine can run what the file is compiled for.
inline bool runs_here()
{
#if defined(__AVX512F__)
    return __builtin_cpu_supports("avx512f") != 0;
#elif defined(__AVX2__)
    return __builtin_cpu_supports("avx2") != 0;
#else
    return true;
#endif
}

}  // namespace csg_test
