#include "csg/packet/lanes/torus_looks.h"
#include "tests/csg/tube_ray.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace csg;
using csg_test::Rng;

TEST_CASE("what looks say of rays and a torus is what its crossings say", "[csg][lanes]")
{
    constexpr auto kAtOnce = static_cast<std::uint32_t>(csg::lanes::kDoubles);
    std::uint32_t said = 0, all = 0;
    for (const double minor : {0.02, 0.25, 0.6, 0.999, 1.2, 3.0}) {
        const Torus torus{1.0, minor, {}};
        const TorusLooks looks(torus);
        for (std::uint32_t seed = 0; seed < 20000; seed += kAtOnce) {
            std::array<Ray, kAtOnce> rays;
            alignas(64) std::array<double, kAtOnce> o[3], d[3], t_min, limit;
            for (std::uint32_t k = 0; k < kAtOnce; ++k) {
                Rng rng(seed + k);
                rays[k] = tube_ray(rng, torus, (seed + k) % 4 == 0);
                double t[4];
                const int n = torus.roots(rays[k], t);
                if (rng.below(3) == 0 && n > 0) rays[k].origin = rays[k].at(t[rng.below(n)]);  // leaves the torus
                const double farther = rng.below(4) == 0 ? std::pow(10.0, rng.uniform(0.0, 5.0)) : 0.0;
                if (rng.coin()) rays[k].origin -= farther * rays[k].direction;
                if (rng.below(3) == 0) rays[k].direction *= 3.0;
                t_min[k] = 1e-3, limit[k] = rng.coin() ? rng.uniform(0.0, 8.0) : farther + 100.0;
                for (int axis = 0; axis < 3; ++axis) {
                    o[axis][k] = rays[k].origin[axis];
                    d[axis][k] = rays[k].direction[axis];
                }
            }
            const auto load = [](const auto& lanes) { return csg::lanes::Double::load_aligned(lanes.data()); };
            TorusRays own{{load(o[0]), load(o[1]), load(o[2])}, {load(d[0]), load(d[1]), load(d[2])}, {}};
            own.square = TorusRays::length2(own.d);
            const std::uint32_t by = csg::lanes::mask(looks.passes_by(own));
            const auto [meets, misses] = looks.look(own, load(t_min), load(limit), (1u << kAtOnce) - 1);
            for (std::uint32_t k = 0; k < kAtOnce; ++k) {
                INFO("minor " << minor << ", seed " << seed + k);
                double t[4];
                const int n = torus.roots(rays[k], t);
                bool between = false, after = false;
                for (int i = 0; i < n; ++i) {
                    after |= t[i] > t_min[k];
                    between |= t[i] > t_min[k] && t[i] < limit[k];
                }
                if (by >> k & 1) REQUIRE(n == 0);
                if (meets >> k & 1) REQUIRE(between);
                if (misses >> k & 1) REQUIRE(!after);
                said += (meets | misses) >> k & 1;
                ++all;
            }
        }
    }
    CHECK(said > 0.6 * all);
}
