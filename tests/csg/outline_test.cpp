#include "csg/freeform/sweep/conic_prism.h"
#include "csg/solids/shared/outline_crossings.h"
#include "csg/solids/extrusion.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstring>

// What is left out of a stretch of a line, and of a range of a ray, changes nothing within it.

using namespace csg;
using csg_test::Rng;
using csg_test::share;

namespace {

/// A ring of `corners` pieces, straight or curved, and its hole.
std::vector<OutlinePiece> wavy_ring(Rng& rng, int degree, int corners)
{
    std::vector<OutlinePiece> pieces;
    for (const double radius : {1.2, 0.4}) {
        std::vector<glm::dvec2> corner;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * 3.14159265358979 * i / corners;
            corner.push_back(radius * rng.uniform(0.6, 1.15) * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
        for (int i = 0; i < corners; ++i) {
            const auto at = [&](int k) { return corner[static_cast<std::size_t>((i + k + corners) % corners)]; };
            const glm::dvec2 p = at(-1), q = at(0), r = at(1), s = at(2);
            if (degree == 1) pieces.push_back(OutlinePiece::line(q, r));
            else if (degree == 2)
                pieces.push_back(OutlinePiece::quadratic(q, 0.55 * (q + r) + glm::dvec2(rng.uniform(-0.1, 0.1)), r));
            else
                pieces.push_back(
                    {-0.5 * p + 1.5 * q - 1.5 * r + 0.5 * s, p - 2.5 * q + 2.0 * r - 0.5 * s, 0.5 * (r - p), q, q, r});
        }
    }
    return pieces;
}

struct Met {
    double w;
    std::uint32_t piece;
    bool operator==(const Met& other) const { return std::memcmp(&w, &other.w, sizeof w) == 0 && piece == other.piece; }
};

struct Drawn {
    double t;
    std::uint32_t face;
    bool operator==(const Drawn& other) const { return std::memcmp(&t, &other.t, sizeof t) == 0 && face == other.face; }
};

/// OutlineEnds that are drawn in a range, in the order they are told; `first`: the nearest alone, of equal ones the
/// last.
class OutlineEnds {
public:
    OutlineEnds(double from, double to, bool first) : from_(from), to_(to), first_(first) {}
    void operator()(double in, std::uint32_t in_face, double out, std::uint32_t out_face)
    {
        add(in, in_face);
        add(out, out_face);
    }
    std::vector<Drawn> all;

private:
    void add(double t, std::uint32_t face)
    {
        if (!(t >= from_ && t <= to_) || face == kUndrawnFace) return;
        if (!first_ || all.empty()) all.push_back({t, face});
        else if (t <= all[0].t) all[0] = {t, face};
    }
    double from_, to_;
    bool first_;
};

/// `tell(ray, from, to, first, ends)` for a range, for the nearest end in it, and for all of the ray.
template <class Tell>
int check_ranges(Rng& rng, const Tell& tell)
{
    Ray ray = rng.below(60) == 0 ? csg_test::hostile_ray(rng)
                                 : csg_test::ray_near(rng, glm::dvec3(0.0), 1.2,
                                                      rng.below(8) == 0 ? 1e6
                                                      : rng.coin()      ? 6.0
                                                                        : 0.5);
    if (rng.below(8) == 0) ray.direction[rng.below(3)] = 0.0;
    if (rng.below(8) == 0) ray.direction[rng.below(3)] *= 1e-9;
    const double from = rng.below(3) == 0 ? 0.0 : rng.uniform(-2.0, 7.0),
                 to = rng.coin() ? kInfinity : from + rng.uniform(0.0, 4.0);
    int ends = 0;
    for (const bool first : {false, true}) {
        OutlineEnds whole(from, to, first), asked(from, to, first);
        tell(ray, -kInfinity, kInfinity, false, whole);
        tell(ray, from, to, first, asked);
        REQUIRE(asked.all == whole.all);
        ends += static_cast<int>(whole.all.size());
    }
    return ends;
}

}  // namespace

TEST_CASE("outline: a stretch of a line holds the same crossings as the whole line, and before it an odd number or an "
          "even one",
          "[csg][outline]")
{
    int found = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(share(4000)); ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const OutlineShape shape(wavy_ring(rng, 1 + rng.below(3), 3 + rng.below(60)));
        const glm::dvec2 side(rng.uniform(-1, 1), rng.uniform(-1, 1));
        const OutlineLine whole{side, rng.uniform(-1, 1), {-side.y, side.x}};
        std::vector<Met> all;
        OutlineLine line = whole;
        REQUIRE_FALSE(outline_crossings(shape, line, [&](double w, std::uint32_t piece) {
            all.push_back({w, piece});
        }));
        REQUIRE(all.size() % 2 == 0);
        // The same piece by piece: a joint counts to one side, and what crosses lies on the line.
        std::size_t joints = 0;
        for (const OutlinePiece& piece : shape.pieces())
            joints += (glm::dot(side, piece.start) < whole.level) != (glm::dot(side, piece.end) < whole.level);
        REQUIRE(all.size() >= joints);
        for (const Met& one : all)
            REQUIRE(std::abs(glm::dot(side, shape.pieces()[one.piece].at(one.w)) - whole.level) < 1e-13);

        line.lo = rng.uniform(-1.5, 1.0);
        line.hi = line.lo + rng.uniform(0.0, 1.0);
        std::vector<Met> kept;
        const auto along = [&](const Met& one) { return glm::dot(whole.along, shape.pieces()[one.piece].at(one.w)); };
        bool odd = outline_crossings(shape, line, [&](double w, std::uint32_t piece) {
            if (const Met one{w, piece}; along(one) >= line.lo) kept.push_back(one);
        });
        OutlineLine before = line;  // those near the stretch's start that were told and not only counted
        before.hi = kInfinity;
        outline_crossings(shape, before, [&](double w, std::uint32_t piece) { odd ^= along({w, piece}) < line.lo; });
        REQUIRE(odd ==
                (std::count_if(all.begin(), all.end(), [&](const Met& one) { return along(one) < line.lo; }) % 2 == 1));
        std::erase_if(kept, [&](const Met& one) { return along(one) > line.hi; });
        std::erase_if(all, [&](const Met& one) { return along(one) < line.lo || along(one) > line.hi; });
        REQUIRE(kept == all);
        found += static_cast<int>(all.size());
    }
    CHECK(found > share(4000) / 4);
}

TEST_CASE("extrusion: a range of a ray has the ends that the whole ray has there", "[csg][outline]")
{
    int ends = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(share(20000)); ++seed) {
        INFO("seed " << seed);
        Rng rng(seed / 50);
        Extrusion solid;
        solid.shape = std::make_shared<OutlineShape>(wavy_ring(rng, 1 + rng.below(3), 3 + rng.below(40)));
        solid.low = -0.4;
        solid.high = 0.5;
        solid.open = rng.coin();
        rng = Rng(seed + 77);
        ends += check_ranges(rng, [&](const Ray& ray, double from, double to, bool first, OutlineEnds& out) {
            solid.each_span(
                ray,
                [&](double in, std::uint32_t in_face, double end, std::uint32_t end_face) {
                    out(in, in_face, end, end_face);
                },
                from, to, first);
        });
    }
    CHECK(ends > share(20000) / 2);
}

TEST_CASE("conic prism: a range of a ray has the ends that the whole ray has there", "[csg][outline]")
{
    constexpr double kHeights[][2] = {{0.25, 1.0}, {0.0, 1.0}, {-0.8, 1.0}, {-1.5, -0.1}, {-1.0, 0.0}};
    int ends = 0;
    for (std::uint32_t seed = 0; seed < static_cast<std::uint32_t>(share(20000)); ++seed) {
        INFO("seed " << seed);
        Rng rng(seed / 50);
        const auto outline = std::make_shared<OutlineShape>(wavy_ring(rng, 1 + rng.below(3), 3 + rng.below(40)));
        const glm::dvec2 reach[2] = {outline->lower(), outline->upper()};
        const auto& height = kHeights[rng.below(5)];
        const ConicPrism solid(outline, height[0], height[1], rng.coin(), reach);
        rng = Rng(seed + 77);
        ends += check_ranges(rng, [&](const Ray& ray, double from, double to, bool first, OutlineEnds& out) {
            IntersectionList record(from, to, first);
            solid.intersect(ray, record);
            record.each_span([&](double in, std::uint32_t in_face, double end, std::uint32_t end_face) {
                out(in, in_face, end, end_face);
            });
        });
    }
    CHECK(ends > share(20000) / 4);
}
