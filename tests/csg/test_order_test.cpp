#include "csg/items/test_order.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>
#include <string>

using namespace csg;
using csg_test::Rng;

namespace {

TestOrder::Box box(const glm::dvec3& lower, const glm::dvec3& upper) { return TestOrder::Box::of({lower, upper}); }

/// Items in the order in which they are asked, one asked for after the other.
std::vector<std::uint32_t> in_order(const TestOrder& order, const Ray& ray, std::vector<std::uint32_t> left)
{
    std::vector<std::uint32_t> out;
    while (!left.empty()) {
        out.push_back(order.first(ray, left));
        left.erase(std::find(left.begin(), left.end(), out.back()));
    }
    return out;
}

std::vector<std::uint32_t> all_in_order(const TestOrder& order, const Ray& ray, std::size_t count)
{
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    return in_order(order, ray, all);
}

}  // namespace

// spec 5a, 11.3: eight boxes with one extent, and what is taken for infinite, of which six planes were drawn by
// POV-Ray.
TEST_CASE("of boxes that a ray comes to at once the first declared is asked first, then the last", "[csg][test_order]")
{
    const Ray ray{{0.1, 0.2, -5.0}, {0.0, 0.0, 1.0}};
    const std::vector<TestOrder::Box> alike(4, box(glm::dvec3(-1.0), glm::dvec3(1.0)));
    CHECK(all_in_order(TestOrder(alike), ray, 4) == std::vector<std::uint32_t>{0, 3, 2, 1});
    const std::vector<TestOrder::Box> endless(4, box(glm::dvec3(-1e10), glm::dvec3(1e10)));
    CHECK(all_in_order(TestOrder(endless), ray, 4) == std::vector<std::uint32_t>{0, 3, 2, 1});
}

TEST_CASE("what has no end is asked before all boxes, and nearer boxes before farther ones", "[csg][test_order]")
{
    const std::vector<TestOrder::Box> boxes{
        box({-1.0, -1.0, 3.0}, {1.0, 1.0, 4.0}), box({-1.0, -1.0, 1.0}, {1.0, 1.0, 4.0}),
        box(glm::dvec3(-1e10), glm::dvec3(1e10)), box({-1.0, -1.0, 2.0}, {1.0, 1.0, 4.0})};
    const TestOrder order(boxes);
    CHECK(all_in_order(order, {{0.1, 0.2, -5.0}, {0.0, 0.0, 1.0}}, 4) == std::vector<std::uint32_t>{2, 1, 3, 0});
    // From behind they begin together.
    CHECK(order.first({{0.1, 0.2, 9.0}, {0.0, 0.0, -1.0}}, std::vector<std::uint32_t>{0, 2, 3}) == 2);
}

TEST_CASE("every box that a ray meets is found in the hierarchy, in the order of where it begins", "[csg][test_order]")
{
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        std::vector<TestOrder::Box> boxes;
        std::vector<Aabb> known;
        for (int left = 1 + rng.below(60); left > 0; --left) {
            const glm::dvec3 lower = rng.point(5.0);
            known.push_back({lower, lower + glm::dvec3(rng.uniform(0.1, 3.0), rng.uniform(0.1, 3.0), 1.0)});
            boxes.push_back(TestOrder::Box::of(known.back()));
        }
        const TestOrder order(boxes);
        const Ray ray{{rng.uniform(-5.0, 5.0), rng.uniform(-5.0, 5.0), -20.0}, {0.0, 1e-3, 1.0}};
        std::vector<std::uint32_t> met;
        for (std::uint32_t i = 0; i < known.size(); ++i) {
            const glm::dvec3 p = ray.at(known[i].lower.z - ray.origin.z);
            if (p.x > known[i].lower.x && p.x < known[i].upper.x && p.y > known[i].lower.y && p.y < known[i].upper.y)
                met.push_back(i);
        }
        if (met.empty()) continue;
        const auto nearest = std::min_element(met.begin(), met.end(), [&](std::uint32_t a, std::uint32_t b) {
            return known[a].lower.z < known[b].lower.z;
        });
        CHECK(order.first(ray, met) == *nearest);
        std::vector<std::uint32_t> arranged(met.rbegin(), met.rend());
        order.arrange(ray, arranged);
        CHECK(arranged == in_order(order, ray, met));
    }
}

TEST_CASE("items of one box are arranged where that box is asked, as they are declared", "[csg][test_order]")
{
    const std::vector<TestOrder::Box> boxes{box({-1.0, -1.0, 3.0}, {1.0, 1.0, 4.0}),
                                            box({-1.0, -1.0, 1.0}, {1.0, 1.0, 4.0}),
                                            box({-1.0, -1.0, 2.0}, {1.0, 1.0, 4.0})};
    const TestOrder order(boxes, Roundings::V37, {0, 1, 1, 2});
    std::vector<std::uint32_t> items{3, 2, 0, 1};
    order.arrange({{0.1, 0.2, -5.0}, {0.0, 0.0, 1.0}}, items);
    CHECK(items == std::vector<std::uint32_t>{1, 2, 3, 0});
}

TEST_CASE("boxes of which each is parted from all others do not take the square of their number", "[csg][test_order]")
{
    // Flat ones of rising size and distance: a part with the next of them costs more than one without.
    std::vector<TestOrder::Box> boxes;
    std::vector<std::uint32_t> all;
    double at = 0.0, size = 1e-3;
    for (std::uint32_t i = 0; i < 200000; ++i) {
        boxes.push_back(box({at, 0.0, 0.0}, {at + size, size, size}));
        all.push_back(i);
        at += 2.0 * size;
        size *= 1.00004;
    }
    const TestOrder order(boxes);
    CHECK(order.first({{-1.0, 1e-4, 1e-4}, {1.0, 0.0, 0.0}}, all) == 0);
}

// spec 5a, 11.3, and 7d, 9: what POV-Ray 3.7 drew of two boxes with one upper face, and that 3.8 drew the first.
TEST_CASE("of faces in one place 3.7 shows a grain, 3.8 a whole one", "[csg][test_order]")
{
    const std::vector<TestOrder::Box> boxes{box({-3.0, -2.0, -7.0}, {3.0, 0.0, -1.0}),
                                            box({-8.0, -0.5, -8.0}, {8.0, 0.0, 8.0}),
                                            box({-0.1, -0.1, 49.9}, {0.1, 0.1, 50.1})};
    const glm::dvec3 eye(-8.0, 4.0, -14.0), ahead = glm::normalize(glm::dvec3(-2.0, 0.0, -4.0) - eye),
                                            right = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), ahead)),
                                            up = glm::cross(ahead, right);
    const double distance = 2.0 / 3.0 / std::tan(glm::radians(20.0));
    const auto shown = [&](Roundings by) {
        const TestOrder order(boxes, by);
        std::string out;
        for (int column = 70; column < 118; ++column) {
            const double u = (column + 0.5) / 160.0 - 0.5, v = 0.5 - 60.5 / 120.0;
            const glm::dvec3 d = glm::normalize(distance * ahead + u * 4.0 / 3.0 * right + v * up);
            out += order.first({eye, d}, std::vector<std::uint32_t>{0, 1}) == 0 ? 'A' : 'B';
        }
        return out;
    };
    CHECK(shown(Roundings::V37) == "BAAABABAAAAAABABAAABBBABABBBAABBBAAAAABBBBAAAAAA");
    CHECK(shown(Roundings::V38) == std::string(48, 'A'));
}
