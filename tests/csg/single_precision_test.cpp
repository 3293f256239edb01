#include "numbers/single_precision.h"

#include <catch2/catch.hpp>

namespace {

struct Pair {
    double a, b;
};

/// Two numbers side by side, which the compiler sees in one piece.
[[gnu::noinline]] void round_both(const Pair& from, Pair& to)
{
    to.a = numbers::single(from.a);
    to.b = numbers::single(from.b);
}

}  // namespace

TEST_CASE("numbers side by side are rounded to single precision", "[csg]")
{
    Pair rounded;
    round_both({0.2, 0.0005}, rounded);
    CHECK(rounded.a == 0x1.99999ap-3);
    CHECK(rounded.b == 0x1.0624dep-11);
    const glm::dvec3 p = numbers::single(glm::dvec3(0.1, -0.3, 7.7));
    CHECK(p.x == 0x1.99999ap-4);
    CHECK(p.y == -0x1.333334p-2);
    CHECK(p.z == 0x1.ecccccp+2);
}
