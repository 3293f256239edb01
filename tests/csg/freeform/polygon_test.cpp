#include "csg/freeform/surface/polygon.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <optional>
#include <random>

namespace {

using Loop = std::vector<glm::dvec2>;

/// Whether an odd number of edges lies to the right, in higher precision; nothing for a point beside an edge.
std::optional<bool> odd(const std::vector<Loop>& loops, const glm::dvec2& q)
{
    bool inside = false;
    for (const Loop& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
            if (std::abs(a.y - q.y) < 1e-9) return {};
            if ((a.y > q.y) == (b.y > q.y)) continue;
            const long double share = (static_cast<long double>(q.y) - a.y) / (static_cast<long double>(b.y) - a.y),
                              x = a.x + share * (static_cast<long double>(b.x) - a.x);
            if (std::abs(static_cast<double>(x) - q.x) < 1e-9) return {};
            if (x > q.x) inside = !inside;
        }
    return inside;
}

}  // namespace

TEST_CASE("a polygon holds what an odd number of its edges lies beside", "[csg][polygon]")
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (const std::size_t corners : {3u, 4u, 7u, 40u, 300u, 2000u})
        for (const double flat : {1.0, 1e-3, 1e6}) {  // stars whose edges cross everything, and curves of short ones
            std::vector<Loop> loops(1 + corners % 3);
            for (Loop& loop : loops)
                for (std::size_t i = 0; i < corners; ++i) {
                    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(corners),
                                 r = corners % 2 == 0 ? 0.5 + 0.5 * unit(random) : 0.9 + 0.1 * unit(random);
                    loop.push_back({r * std::cos(angle), flat * r * std::sin(angle)});
                }
            std::vector<glm::dvec3> all;
            for (const Loop& loop : loops) {
                for (const glm::dvec2& p : loop) all.emplace_back(p, 0.0);
                all.push_back(all[all.size() - loop.size()]);
            }
            const csg::Polygon polygon(all);
            const int points = corners > 100 ? 200 : 1000;
            int looked = 0;
            for (int i = 0; i < points; ++i) {
                const glm::dvec2 q{1.1 * unit(random), 1.1 * flat * unit(random)};
                const std::optional<bool> wanted = odd(loops, q);
                if (!wanted) continue;
                csg::IntersectionList found(0.0, numbers::kInfinity, false);
                polygon.intersect({glm::dvec3(q, -1.0), glm::dvec3(0.0, 0.0, 1.0)}, found);
                INFO(corners << " corners, " << flat << ", at " << q.x << ", " << q.y);
                bool met = false;
                found.each_touching([&](double, std::uint32_t) { met = true; });
                REQUIRE(met == *wanted);
                ++looked;
            }
            CHECK(looked > points / 2);
        }
}
