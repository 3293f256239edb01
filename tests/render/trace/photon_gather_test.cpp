// Photons that a tile of points gathers: what one point would find alone.
#include "render/kernel/gather/part_nearest.h"
#include "render/kernel/gather/photon_map.h"
#include "tests/render/trace/photon_support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

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
            glm::dvec3 low(numbers::kInfinity), high(-numbers::kInfinity);
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
                const trace::PhotonReach all =
                    map.reach(glm::dvec3(-numbers::kInfinity), glm::dvec3(numbers::kInfinity));
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

TEST_CASE("the nearest photons are parted from the others as if they were sorted", "[photons]")
{
    std::mt19937 random(31);
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    for (int i = 0; i < 4000; ++i) {
        INFO("set " << i);
        const std::size_t count = 1 + random() % 400, keep = 1 + random() % count;
        const float power = std::exp2(8.0f * share(random) - 3.0f), scale = std::exp2(40.0f * share(random) - 20.0f);
        const auto steps = static_cast<float>(i % 3 == 0 ? 1 + random() % 20 : 0);  // many as far as each other
        std::vector<float> distances(count);
        for (float& d2 : distances) {
            d2 = std::pow(share(random), power);
            if (steps > 0.0f) d2 = std::floor(d2 * steps) / steps;
            d2 *= scale;
        }
        std::vector<std::uint32_t> order(count);
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return distances[a] < distances[b]; });
        order.resize(keep);
        const float farthest = distances[order.back()], bound = std::max(scale, farthest);
        std::sort(order.begin(), order.end());

        const std::size_t room = count + trace::PartedPhotons::kRoom;
        std::vector<float> left = distances, scratch(room);
        std::vector<std::uint32_t> numbers(room);
        left.resize(room);
        std::iota(numbers.begin(), numbers.end(), 0u);
        trace::PartedPhotons photons(left.data(), numbers.data(), count, scratch.data());
        REQUIRE(photons.keep_nearest(keep, i % 2 == 0 ? bound : farthest + 0.5f * (bound - farthest)) == farthest);
        numbers.resize(keep);
        REQUIRE(numbers == order);
        for (std::size_t k = 0; k < keep; ++k) REQUIRE(left[k] == distances[order[k]]);
    }
}
