#include "render/solid/files/drawing.h"
#include "render/solid/measure/measure.h"
#include "render/solid/section/contour.h"
#include "render/solid/section/section_check.h"
#include "tests/render/solid/body_of.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

namespace {

constexpr double kHalfTurn = 3.14159265358979323846;

struct Cut {
    std::vector<solid::Loop> loops;
    solid::CuttingPlane plane;
    solid::SectionCheck check;
    csg::Aabb extent;
    solid::RefineFacts facts;
};

Cut cut_of(const solid::Body& body, int axis, double value, double tolerance)
{
    Cut out;
    double error = 0.0;
    std::uint64_t rays = 0;
    out.extent = solid::require_extent(body, error, rays);
    out.plane = solid::beside_faces(body, out.extent, {axis, value});
    solid::RefineOptions options;
    options.cells = solid::kContourCells;
    options.tolerance = tolerance;
    out.loops = solid::without_straight_points(solid::contour_of(body, out.extent, out.plane, options, out.facts),
                                               0.02 * tolerance);
    out.check = solid::check_section(body, out.extent, out.plane, out.loops, tolerance, nullptr);
    return out;
}

std::size_t points_of(const Cut& cut)
{
    std::size_t count = 0;
    for (const solid::Loop& loop : cut.loops) count += loop.size();
    return count;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// By the even-odd rule: how many sides a line to the right of the point passes.
bool filled(const std::vector<solid::Loop>& loops, const glm::dvec2& p)
{
    bool in = false;
    for (const solid::Loop& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 a = loop[i], b = loop[(i + 1) % loop.size()];
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
        }
    return in;
}

double distance_to(const std::vector<solid::Loop>& loops, const glm::dvec2& p)
{
    double best = 1e300;
    for (const solid::Loop& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const glm::dvec2 a = loop[i], along = loop[(i + 1) % loop.size()] - a;
            const double t = glm::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
            best = std::min(best, glm::length(p - a - t * along));
        }
    return best;
}

/// Sides that pass through each other, each against each.
std::size_t side_crossings(const std::vector<solid::Loop>& loops)
{
    std::vector<std::array<glm::dvec2, 2>> sides;
    for (const solid::Loop& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) sides.push_back({loop[i], loop[(i + 1) % loop.size()]});
    std::size_t found = 0;
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const auto& [a, b] = sides[i];
            const auto& [c, d] = sides[k];
            found += cross(b - a, c - a) * cross(b - a, d - a) < 0.0 && cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
        }
    return found;
}

}  // namespace

TEST_CASE("areas of cuts are those of the formulas", "[solid][section]")
{
    const double w = std::sqrt(0.0625 - 0.01);  // half the width of the torus at this height
    struct Known {
        const char* scene;
        int axis;
        double value, area, length;
        std::size_t loops;
    };
    const Known known[] = {
        {"sphere { <5, 1, 2>, 1 }", 1, 1.25, kHalfTurn * 0.9375, 2.0 * kHalfTurn * std::sqrt(0.9375), 1},
        {"sphere { <5, 1, 2>, 1 }", 0, 5.0, kHalfTurn, 2.0 * kHalfTurn, 1},
        {"torus { 1, 0.25 }", 1, 0.1, 4.0 * kHalfTurn * w, 4.0 * kHalfTurn, 2},
        {"torus { 1, 0.25 }", 0, 0.0, 2.0 * kHalfTurn * 0.0625, 4.0 * kHalfTurn * 0.25, 2},
        {"box { 0, <1, 2, 3> }", 2, 1.0, 2.0, 6.0, 1},
        // A plane through a cube across its diagonal: a regular hexagon of sides sqrt(2).
        {"box { -1, 1 rotate 45 * z rotate degrees(atan2(1, sqrt(2))) * x }", 1, 0.0, 3.0 * std::sqrt(3.0),
         6.0 * std::sqrt(2.0), 1},
        {"difference { box { -1, 1 } sphere { 0, 0.9 } }", 2, 0.5, 4.0 - kHalfTurn * 0.56,
         8.0 + 2.0 * kHalfTurn * std::sqrt(0.56), 2},
    };
    for (const Known& k : known)
        for (const double tolerance : {0.01, 1e-4}) {
            INFO(k.scene << " at " << k.value << " to " << tolerance);
            const solid::Body body = body_of(k.scene);
            const Cut cut = cut_of(body, k.axis, k.value, tolerance);
            CHECK(cut.loops.size() == k.loops);
            CHECK(std::abs(solid::area_of(cut.loops) - k.area) <= tolerance * k.length);
            CHECK(std::abs(solid::length_of(cut.loops) - k.length) <= 2.0 * tolerance * k.length);
            CHECK(std::abs(cut.check.area.value - k.area) <= cut.check.area.error + 1e-5);
            CHECK(cut.check.from_loops <= tolerance);
            CHECK(cut.check.from_body <= tolerance);
            CHECK(side_crossings(cut.loops) == 0);
        }
}

namespace {

struct Polygonal {
    const char* scene;
    int axis;
    double value, area;
    std::size_t points;
};

void check_corners(const Polygonal& k)
{
    INFO(k.scene);
    const Cut cut = cut_of(body_of(k.scene), k.axis, k.value, 0.01);
    CHECK(points_of(cut) == k.points);
    CHECK(solid::area_of(cut.loops) == Approx(k.area).margin(1e-3));
}

}  // namespace

TEST_CASE("corners stay sharp: a polygon has its corners and no other points", "[solid][section]")
{
    check_corners(
        {"difference { box { -1, 1 } box { <-0.5, -2, -0.5>, <0.5, 2, 0.5> rotate 10 * y } }", 1, 0.3, 3.0, 8});
    check_corners({"box { 0, <1, 2, 3> rotate 20 * z }", 2, 1.0, 2.0, 4});
    check_corners(
        {"box { -1, 1 rotate 45 * z rotate degrees(atan2(1, sqrt(2))) * x }", 1, 0.0, 3.0 * std::sqrt(3.0), 6});
}

TEST_CASE("faces in one place leave no skin in a cut", "[solid][section]")
{
    // Two bars stand; the faces of what was taken away lie in those of the block.
    const char* const bars = "difference { box { -1, 1 } box { <-0.5, -1, -1>, <0.5, 1, 1> } }";
    for (const double y : {0.0, 1.0, -1.0, 0.75}) {
        INFO(y);
        const Cut cut = cut_of(body_of(bars), 1, y, 0.01);
        CHECK(cut.loops.size() == 2);
        CHECK(points_of(cut) == 8);
        CHECK(solid::area_of(cut.loops) == Approx(2.0).margin(1e-3));
        CHECK(std::abs(cut.plane.value) <= 1.0);
    }
    const Cut joined = cut_of(body_of("union { box { 0, 1 } box { <1, 0, 0>, <2, 1, 1> } }"), 2, 0.5, 0.01);
    CHECK(joined.loops.size() == 1);
    CHECK(solid::area_of(joined.loops) == Approx(2.0).margin(1e-3));
}

TEST_CASE("what the loops fill is what is inside", "[solid][section]")
{
    struct Scene {
        const char* text;
        int axis;
        double value;
    };
    const Scene scenes[] = {
        {"blob { threshold 0.5 sphere { -0.6 * x, 1, 1 } sphere { 0.6 * x, 1, 1 } cylinder { -y, y, 0.4, -1 } }", 2,
         0.1},
        {"difference { sphere { 0, 1 } sphere { 0, 0.95 } cylinder { 0, 2 * y, 0.4 } }", 0, 0.05},
        {"intersection { torus { 1, 0.4 rotate 40 * x } box { -1, <1, 1, 0.8> } }", 1, 0.2},
        {"isosurface { function { sin(3 * x) * cos(3 * y) + sin(3 * y) * cos(3 * z) + sin(3 * z) * cos(3 * x) } "
         "contained_by { box { -1, 1 } } max_gradient 7 all_intersections }",
         1, 0.3},
        {"union { box { -1, <0, 1, 1> } sphere { 0, 0.7 } prism { -1, 1, 4, <0, 0>, <1.5, 0>, <1, 1>, <0, 0> } }", 1,
         0.25},
    };
    for (const Scene& s : scenes) {
        INFO(s.text);
        const solid::Body body = body_of(s.text);
        const Cut cut = cut_of(body, s.axis, s.value, 0.005);
        CHECK(cut.check.from_loops <= 0.005);
        CHECK(cut.check.from_body <= 0.005);
        CHECK(side_crossings(cut.loops) == 0);
        CHECK(std::abs(solid::area_of(cut.loops) - cut.check.area.value) <=
              cut.check.area.error + 0.005 * solid::length_of(cut.loops));
        std::mt19937 random(7);
        std::uniform_real_distribution<double> share;
        const glm::dvec2 lower = cut.plane.flat(cut.extent.lower), size = cut.plane.flat(cut.extent.upper) - lower;
        int looked = 0;
        for (int i = 0; i < 3000; ++i) {
            const glm::dvec2 p = lower + size * glm::dvec2(share(random), share(random));
            if (distance_to(cut.loops, p) <= 0.005) continue;
            ++looked;
            CHECK(filled(cut.loops, p) == body.inside(cut.plane.point(p), glm::dvec3(0.6, 0.64, 0.48)));
        }
        CHECK(looked > 2000);
    }
}

TEST_CASE("a cut is the same on every run and ends when it may not go on", "[solid][section]")
{
    const solid::Body body = body_of("difference { sphere { 0, 1 } torus { 0.7, 0.4 } }");
    CHECK(cut_of(body, 1, 0.2, 1e-3).loops == cut_of(body, 1, 0.2, 1e-3).loops);
    solid::RefineOptions options;
    options.cells = solid::kContourCells;
    options.tolerance = 1e-6;
    options.deadline = std::chrono::steady_clock::now();
    solid::RefineFacts facts;
    const csg::Aabb extent{glm::dvec3(-1), glm::dvec3(1)};
    CHECK(!solid::contour_of(body, extent, {1, 0.2}, options, facts).empty());
    CHECK(facts.late);
    const std::atomic<bool> cancel{true};
    options.cancel = &cancel;
    CHECK_THROWS(solid::contour_of(body, extent, {1, 0.2}, options, facts));
}

TEST_CASE("names of parts become names that files may have", "[solid][section]")
{
    const solid::Loop square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const std::vector<solid::DrawnPart> parts{{"a <b> & \"c\"", {1, 0, 0}, {square}},
                                              {"a <b> & \"c\"", {0, 0, 1}, {square}},
                                              {std::string(40, 'x'), {0, 0, 0}, {square}}};
    const std::string svg = solid::svg_text(parts, "t", 1e-3), dxf = solid::dxf_text(parts, 1e-3);
    CHECK_THAT(svg, Catch::Contains("<g id=\"a_&lt;b&gt;_&amp;_&quot;c&quot;\" fill=\"#ff0000\">"));
    CHECK_THAT(svg, Catch::Contains("<g id=\"a_&lt;b&gt;_&amp;_&quot;c&quot;_2\" fill=\"#0000ff\">"));
    CHECK_THAT(svg, Catch::Contains("<title>a &lt;b&gt; &amp; &quot;c&quot;</title>"));
    CHECK_THAT(dxf, Catch::Contains("  2\nA__B_____C_\n 70\n0\n 62\n1\n"));
    CHECK_THAT(dxf, Catch::Contains("  2\nA__B_____C__2\n 70\n0\n 62\n5\n"));
    CHECK_THAT(dxf, Catch::Contains("  8\n" + std::string(31, 'X') + "\n"));
}
