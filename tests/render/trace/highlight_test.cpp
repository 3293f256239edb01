#include "render/kernel/light/highlight_lanes.h"

#include <catch2/catch.hpp>

#include <random>

// Highlights of a tile in vector lanes beside the formulas for one hit.
using namespace trace;

namespace {

glm::dvec3 unit(std::mt19937& random)
{
    std::normal_distribution<double> any;
    return glm::normalize(glm::dvec3(any(random), any(random), any(random)));
}

}  // namespace

TEST_CASE("powers in lanes are the library's", "[trace][highlight]")
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    alignas(64) std::array<double, 64> c, n, out;
    double worst = 0.0;
    for (int round = 0; round < 2000; ++round) {
        for (std::size_t i = 0; i < 64; ++i) {
            n[i] = static_cast<double>(static_cast<float>(std::exp2(16.0 * share(random) - 4.0)));
            c[i] = round % 2 ? share(random) : 1.0 - 30.0 * share(random) / std::max(n[i], 30.0);
        }
        using numbers::lanes::Double;
        for (std::size_t i = 0; i < 64; i += numbers::lanes::kDoubles)
            numbers::lanes::power(Double::load_aligned(&c[i]), Double::load_aligned(&n[i])).store_aligned(&out[i]);
        for (std::size_t i = 0; i < 64; ++i) {
            if (texture::highlight_vanishes(c[i], n[i])) continue;
            const double truth = std::pow(c[i], n[i]);
            if (truth > 1e-300) worst = std::max(worst, std::abs(out[i] / truth - 1.0));
        }
    }
    CHECK(worst < 1e-13);
}

TEST_CASE("highlights of a tile are those of its hits alone", "[trace][highlight]")
{
    std::mt19937 random(11);
    auto rays = std::make_unique<csg::RayTile>();
    auto hits = std::make_unique<TileHits>();
    auto light = std::make_unique<TileLight>();
    std::array<texture::Finish, 4> finishes;
    finishes[0].phong = 0.7f;
    finishes[0].phong_size = 65.0f;
    finishes[1].specular = 0.4f;
    finishes[1].specular_exponent = 50.0f;
    finishes[2].phong = finishes[2].specular = 0.5f;
    finishes[2].phong_size = 3.0f;
    finishes[2].specular_exponent = 2.0f;
    finishes[3].specular = 0.9f;
    auto shine = std::make_unique<SpecularLobe>();
    alignas(64) TileLanes strength;
    int met = 0;
    for (int round = 0; round < 200; ++round) {
        rays->count = round % csg::kTileRays + 1;
        const auto count = static_cast<std::size_t>(rays->count);
        for (std::size_t k = 0; k < csg::kTileRays; ++k) {
            rays->set(k, {glm::dvec3(0), unit(random)}, 0, 1);
            hits->set(k, glm::dvec3(0), unit(random));
            const glm::dvec3 l = unit(random);
            light->x[k] = l.x, light->y[k] = l.y, light->z[k] = l.z;
        }
        const double* const normals[3] = {hits->nx.data(), hits->ny.data(), hits->nz.data()};
        // Of one finish, then of all at once.
        for (std::size_t first = 0; first <= finishes.size(); ++first) {
            const auto finish_of = [&](std::size_t k) {
                return finishes[first < finishes.size() ? first : k % finishes.size()];
            };
            if (first < finishes.size()) shine->fill(finishes[first]);
            else
                for (std::size_t k = 0; k < csg::kTileRays; ++k) shine->set(k, finish_of(k));
            find_highlights(*rays, normals, *light, *shine, ~HitMask{0}, strength);
            for (std::size_t k = 0; k < count; ++k) {
                const texture::Finish finish = finish_of(k);
                const glm::dvec3 d = rays->ray(static_cast<int>(k)).direction, n = hits->normal(k),
                                 l = light->direction(k);
                double alone = 0.0;
                if (finish.phong > 0.0f) alone += texture::phong(finish, d, n, l);
                if (finish.specular > 0.0f) alone += texture::specular(finish, d, n, l);
                CHECK(strength[k] == Approx(alone).epsilon(1e-12).margin(1e-300));
                met += alone > 1e-6 ? 1 : 0;
            }
        }
    }
    CHECK(met > 2000);
}
