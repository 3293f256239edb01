#include "tests/render/solid/body_of.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

namespace {

std::string many(const char* kind, int count)
{
    std::string out;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> at(-1.0, 1.0);
    const auto vector = [&] {
        return "<" + std::to_string(at(random)) + "," + std::to_string(at(random)) + "," + std::to_string(at(random)) +
               ">";
    };
    for (int i = 0; i < count; ++i) {
        const std::string where = vector();
        out += kind == std::string("sphere")
                   ? "sphere { " + where + ", 0.2 } "
                   : "box { -0.15, 0.2 rotate 90 * " + vector() + " translate " + where + " } ";
    }
    return out;
}

/// Ends of chords within a range, as numbers that are compared to the bit.
std::vector<double> ends_within(const std::vector<csg::Chord>& chords, double from, double to)
{
    std::vector<double> out;
    for (const csg::Chord& chord : chords) {
        if (chord.out.t < from || chord.in.t > to) continue;
        out.push_back(std::max(from, chord.in.t));
        out.push_back(std::min(to, chord.out.t));
    }
    return out;
}

}  // namespace

TEST_CASE("many lines are told what each is told alone", "[solid]")
{
    const std::string scenes[] = {
        "sphere { 0, 1 }",
        "union { " + many("sphere", 60) + "}",
        "merge { " + many("box", 30) + "}",
        "difference { box { -1, 1 } cylinder { -2 * y, 2 * y, 0.5 } " + many("sphere", 20) + "}",
        "intersection { box { -1, 1 } sphere { 0, 1.2 } plane { x + y, 0.4 } }",
        "difference { union { " + many("box", 8) + " } sphere { 0.3, 0.5 } }",
        "union { cylinder { 0, y, 0.4 open } cone { 0, 0.5, -y, 0.2 } torus { 0.8, 0.2 } }",
        "difference { cylinder { -y, y, 1 open } torus { 0.8, 0.3 } }",
        "blob { threshold 0.5 sphere { 0, 1, 1 } sphere { 0.6, 0.8, 1 } cylinder { -x, x, 0.5, 0.7 } }",
        "lathe { linear_spline 5 <0.2, -0.5>, <0.8, -0.5>, <0.5, 0.1>, <0.9, 0.6>, <0.2, 0.6> }",
        "julia_fractal { <-0.2, 0.6, 0.2, 0.2> quaternion sqr max_iteration 5 precision 60 }",
        "isosurface { function { abs(sin(3 * x) * cos(3 * y) + sin(3 * z)) - 0.3 } contained_by { sphere { 0, 1 } } "
        "max_gradient 6 all_intersections }",
        "mesh { triangle { x, y, z } triangle { x, z, -y } triangle { x, -y, -z } triangle { x, -z, y } "
        "triangle { -x, z, y } triangle { -x, -y, z } triangle { -x, -z, -y } triangle { -x, y, -z } inside_vector x }",
        "quadric { <1, -1, 1>, 0, 0, -0.1 clipped_by { box { -1, 1 } } }",
        "#declare One = union { " + many("sphere", 40) +
            " } union { #for (I, 0, 299) object { One scale 0.1 "
            "rotate 31 * I * y translate <mod(I, 7) - 3, mod(I, 5) - 2, mod(I, 3) - 1> / 3 } #end }",
        "sphere { 0, 1 inverse }",
    };
    std::mt19937 random(3);
    std::uniform_real_distribution<double> at(-1.0, 1.0);
    const auto vector = [&] { return glm::dvec3(at(random), at(random), at(random)); };
    for (const std::string& scene : scenes) {
        INFO(scene);
        const solid::Body body = body_of(scene);
        std::size_t ends = 0;
        for (int tile = 0; tile < 40; ++tile) {
            csg::LineTile lines;
            csg::ChordTile together;
            const bool narrow = tile % 2 == 0, whole = body.bounds().finite() && tile % 4 < 2;
            const glm::dvec3 point = vector(), direction = vector();
            const auto count = static_cast<std::size_t>(tile % 5 == 4 ? 1 + tile % 7 : csg::kTileRays);
            for (std::size_t k = 0; k < count; ++k) {
                const glm::dvec3 along = narrow ? direction + 0.1 * vector() : vector();
                const double from = at(random);
                lines.add({narrow ? point + 0.1 * vector() : vector(), glm::normalize(along)},
                          whole ? -numbers::kInfinity : from, whole ? numbers::kInfinity : from + 0.7);
            }
            body.lines().chords(lines, together);
            for (std::size_t k = 0; k < count; ++k) {
                std::vector<csg::Chord> alone;
                body.lines().chords(lines.lines[k], lines.from[k], lines.to[k], alone);
                const auto wanted = ends_within(alone, lines.from[k], lines.to[k]);
                REQUIRE(ends_within(together[k], lines.from[k], lines.to[k]) == wanted);
                ends += wanted.size();
            }
        }
        CHECK(ends > 100);
    }
}

TEST_CASE("a short way through an isosurface is told what the whole is told, up to its accuracy", "[solid]")
{
    const solid::Body body = body_of("difference { isosurface { function { sin(9 * x) * cos(7 * y) + sin(8 * z) - 0.2 "
                                     "} contained_by { box { -1, 1 } } "
                                     "max_gradient 20 all_intersections } sphere { 0.2, 0.4 } }");
    std::mt19937 random(5);
    std::uniform_real_distribution<double> at(-1.0, 1.0);
    std::size_t ends = 0;
    std::vector<csg::Chord> whole, part;
    for (int i = 0; i < 4000; ++i) {
        const glm::dvec3 point(at(random), at(random), at(random)), along(at(random), at(random), at(random));
        constexpr double kReach = 0.05, kAccuracy = 4e-6;
        const csg::Ray line{point, glm::normalize(along)};
        body.lines().chords(line, -numbers::kInfinity, numbers::kInfinity, whole);
        body.lines().chords(line, -kReach, kReach, part);
        const auto told = ends_within(part, -kReach, kReach), wanted = ends_within(whole, -kReach, kReach);
        REQUIRE(told.size() == wanted.size());
        for (std::size_t k = 0; k < told.size(); ++k) CHECK(std::abs(told[k] - wanted[k]) < kAccuracy);
        ends += told.size();
    }
    CHECK(ends > 2000);
}
