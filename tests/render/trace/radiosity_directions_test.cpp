// Where rays of radiosity's samples go (spec 6, 4.4), and in which order they are traced.
#include "render/picture/passes/directions/directions.h"
#include "render/kernel/radiosity/sorted_rays.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

TEST_CASE("directions are POV-Ray's", "[trace][radiosity]")
{
    const auto usual = trace::radiosity::directions(1600), own = trace::radiosity::directions(1599);
    REQUIRE((usual.size() == 1600 && own.size() == 1599));
    CHECK(glm::distance(usual[0], {-0.353553, 0.707107, 0.612372}) < 1e-5);
    CHECK(glm::distance(usual[2], {0.663414, 0.5, 0.556670}) < 1e-5);
    // A plane under x^2: means of the first rays (spec 6, 4.4).
    const auto mean = [](const std::vector<glm::dvec3>& of, std::size_t first) {
        double sum = 0;
        for (std::size_t i = first; i < first + 20; ++i) sum += of[i].x * of[i].x;
        return sum / 20;
    };
    CHECK(mean(usual, 0) == Approx(0.2179).margin(1e-4));
    CHECK(mean(usual, 40) == Approx(0.2331).margin(1e-4));
    CHECK(mean(own, 0) == Approx(0.2878).margin(1e-4));
    CHECK(mean(own, 40) == Approx(0.3287).margin(1e-4));
}

TEST_CASE("rays of a sample are sorted: each of its directions once, neighbours alike", "[trace][radiosity]")
{
    namespace radiosity = trace::radiosity;
    const auto scratch = std::make_unique<radiosity::GatherScratch>();
    radiosity::Gathering frame;
    frame.x = {0, 0, 1}, frame.y = {1, 0, 0}, frame.z = {0, 1, 0};
    for (const int size : {1599, 1600, 2000}) {
        const std::vector<glm::dvec3> pool = radiosity::directions(size);
        const radiosity::DirectionOrder order(pool);
        for (const std::size_t count : {5u, 64u, 100u, 400u, 1599u})
            for (const std::size_t first : {std::size_t{0}, std::size_t{400}, pool.size() - 3}) {
                radiosity::SortedRays sorted(order, first, count, *scratch);
                std::vector<int> seen(count, 0);
                double apart = 0;
                for (glm::dvec3 last(0, 0, 0); sorted.next(frame);)
                    for (int k = 0; k < scratch->rays.count; ++k) {
                        const std::size_t number = scratch->number[static_cast<std::size_t>(k)];
                        REQUIRE(number < count);
                        ++seen[number];
                        const glm::dvec3 way = scratch->rays.ray(k).direction, v = pool[(first + number) % pool.size()];
                        REQUIRE(glm::distance(way, frame.x * v.x + frame.y * v.y + frame.z * v.z) < 1e-15);
                        if (k > 0) apart += glm::distance(way, last);
                        last = way;
                    }
                CHECK(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));
                // So many directions are about sqrt(2 pi / count) from each other.
                if (count >= 100)
                    CHECK(apart / static_cast<double>(count) < 3.0 / std::sqrt(static_cast<double>(count)));
            }
    }
}
