// Photons that a tile of points gathers: what one point would find alone.
#include "render/trace/photon/photon_map.h"
#include "tests/render/trace/photon_support.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <random>

TEST_CASE("photons are gathered alike alone and beside other points, few or many", "[photons]")
{
    std::mt19937 random(29);
    std::uniform_real_distribution<double> off(-1.0, 1.0);
    std::size_t nothing = 0, some = 0;
    for (const std::size_t count : {0u, 1u, 9u, 300u, 5000u}) {
        trace::PhotonMap map;
        map.build(random_photons(random, count, 0.2f));
        scene::PhotonSettings settings;
        for (int tile = 0; tile < 150; ++tile) {
            settings.radius = std::pow(10.0, 1.5 * off(random) - 1.0);
            trace::LibraryRandom library;
            map.find_radius(settings, false, library);
            const glm::dvec3 middle = 3.0 * glm::dvec3(off(random), off(random), off(random));
            const double wide = std::pow(10.0, 2.0 * off(random) - 1.0);
            std::array<glm::dvec3, 24> points;
            glm::dvec3 low(csg::kInfinity), high(-csg::kInfinity);
            for (glm::dvec3& point : points) {
                point = middle + wide * glm::dvec3(off(random), off(random), off(random));
                low = glm::min(low, point);
                high = glm::max(high, point);
            }
            const trace::PhotonReach reach = map.reach(low, high);
            const glm::dvec3 up(0, 1, 0);
            const glm::dvec3* const normal = tile % 2 == 0 ? &up : nullptr;
            trace::NearPhotons wider, found;
            for (const glm::dvec3& point : points) {
                INFO(count << " photons, tile " << tile);
                trace::NearPhotons alone_wider, alone;
                const trace::PhotonReach all = map.reach(glm::dvec3(-csg::kInfinity), glm::dvec3(csg::kInfinity));
                map.gather(point, normal, all, alone_wider, alone);
                map.gather(point, normal, reach, wider, found);
                REQUIRE(found.found.size() == alone.found.size());
                REQUIRE(found.radius2 == alone.radius2);
                for (std::size_t i = 0; i < found.found.size(); ++i) {
                    CHECK(found.found[i].photon == alone.found[i].photon);
                    CHECK(found.found[i].distance2 == alone.found[i].distance2);
                }
                if (reach.nothing) CHECK(alone.found.empty());
                some += alone.found.empty() ? 0 : 1;
            }
            nothing += reach.nothing ? 1 : 0;
        }
    }
    CHECK(nothing > 100);
    CHECK(some > 1000);
}
