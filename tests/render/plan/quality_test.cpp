// What each quality has of a picture (spec 3, 16).
#include "render/plan/quality.h"

#include <catch2/catch.hpp>

#include <array>
#include <set>

TEST_CASE("a quality has what the ones below it have, and more at its steps")
{
    using plan::Quality;
    const auto parts = [](int level) {
        const Quality q = Quality::of(level);
        return std::array<bool, 8>{q.lights,       q.shadows,    q.area_lights, q.patterns,
                                   q.transmission, q.reflection, q.normals,     q.effects};
    };
    constexpr std::array<int, 8> kFrom{2, 4, 5, 6, 6, 8, 8, 9};
    std::set<unsigned> codes;
    for (int level = 0; level <= 11; ++level) {
        for (std::size_t i = 0; i < kFrom.size(); ++i) CHECK(parts(level)[i] == (level >= kFrom[i]));
        codes.insert(Quality::of(level).code());
    }
    CHECK(codes.size() == 7);  // 0-1, 2-3, 4, 5, 6-7, 8 and 9-11
    CHECK(Quality().code() == Quality::of(9).code());
}
