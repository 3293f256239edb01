#include "csg/bvh/bvh.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <cstring>

using namespace csg;

namespace {

/// Small boxes of all kinds in heaps of different size, some of them in one place.
std::vector<BvhInput> heaps(std::uint32_t count)
{
    csg_test::Rng rng(7);
    std::vector<BvhInput> inputs;
    glm::dvec3 heap(0.0);
    for (std::uint32_t i = 0; i < count; ++i) {
        if (rng.below(5000) == 0) heap = rng.point(100.0);
        const glm::dvec3 at = rng.below(50) == 0 ? heap : heap + rng.point(3.0);
        inputs.push_back({{at, at + glm::abs(rng.point(0.1))}, static_cast<LeafKind>(rng.below(3)), i});
    }
    return inputs;
}

}  // namespace

TEST_CASE("the hierarchy is the same whatever the number of threads that build it", "[csg][bvh]")
{
    const std::vector<BvhInput> inputs = heaps(150'000);  // so many that up to five threads take part
    const Bvh one = build_bvh(inputs);
    REQUIRE(one.nodes.size() > 10'000);
    for (const int threads : {2, 3, 8}) {
        INFO(threads << " threads");
        const Bvh many = build_bvh(inputs, threads);
        REQUIRE(many.nodes.size() == one.nodes.size());
        CHECK(std::memcmp(many.nodes.data(), one.nodes.data(), one.nodes.size() * sizeof(BvhNode)) == 0);
        CHECK(many.sphere_members == one.sphere_members);
        CHECK(many.sphere_first == one.sphere_first);
        CHECK(many.triangle_members == one.triangle_members);
        CHECK(many.triangle_first == one.triangle_first);
        CHECK(many.depth == one.depth);
    }
}
