#include "parser/parse.h"
#include "render/plan/compiled_scene.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

// Which surfaces a shadow ray may stop at (render/plan/geometry/light_stops.h).
namespace {

/// By surface.
std::vector<bool> stops(const std::string& objects)
{
    const auto parsed = parser::parse_text("#version 3.7;\n" + objects, "test.pov", {});
    std::vector<bool> out;
    for (const plan::Surface& surface : plan::compile(parsed.scene, {}).surfaces) out.push_back(surface.opaque);
    return out;
}

const std::string kRed = "texture { pigment { color rgb <1, 0, 0> } }",
                  kGlass = "texture { pigment { color rgbt <1, 1, 1, 0.5> } }";

std::string checkered(const std::string& first, const std::string& second)
{
    return "texture { checker " + first + ", " + second + " }";
}

}  // namespace

TEST_CASE("textures that let no light through at any place stop it", "[plan]")
{
    CHECK(stops("sphere { 0, 1 " + kRed + " }") == std::vector{true});
    CHECK(stops("sphere { 0, 1 " + kGlass + " }") == std::vector{false});
    CHECK(stops("sphere { 0, 1 " + checkered(kRed, kRed) + " }") == std::vector{true});
    CHECK(stops("sphere { 0, 1 " + checkered(kRed, kGlass) + " }") == std::vector{false});
    CHECK(stops("sphere { 0, 1 " + checkered(kRed, checkered(kRed, kRed)) + " }") == std::vector{true});
    CHECK(stops("sphere { 0, 1 " + checkered(kRed, checkered(kGlass, kRed)) + " }") == std::vector{false});
    CHECK(stops("box { 0, 1 texture { uv_mapping pigment { brick rgb 1, rgb 0.5 } } }") == std::vector{true});
    CHECK(stops("box { 0, 1 texture { average texture_map { [1 " + kRed + "] [1 " + kGlass + "] } } }") ==
          std::vector{false});
    CHECK(stops("sphere { 0, 1 " + kRed + " interior_" + kGlass + " }") == std::vector{false});
    CHECK(stops("sphere { 0, 1 " + checkered(kRed, kRed) + " interior_" + kRed + " }") == std::vector{true});
}

TEST_CASE("a map beside something clear stops no shadow ray: the one behind the clear surface may miss it", "[plan]")
{
    const std::string board = "box { 0, 1 " + checkered(kRed, kRed) + " }\n";
    CHECK(stops(board + "sphere { <0.5, 1.5, 0.5>, 0.5 " + kGlass + " }") == std::vector{false, false});
    CHECK(stops(board + "sphere { <0.5, 1.6, 0.5>, 0.5 " + kGlass + " }") == std::vector{true, false});
    CHECK(stops(board + "sphere { <0.5, 1.5, 0.5>, 0.5 " + kGlass + " no_shadow }") == std::vector{true, false});
    CHECK(stops(board + "plane { y, 5 " + kGlass + " }") == std::vector{false, false});
    // POV-Ray's own class of opaque surfaces stops it wherever it stands.
    CHECK(stops("box { 0, 1 " + kRed + " }\nplane { y, 5 " + kGlass + " }") == std::vector{true, false});
    // More places than are kept one by one.
    std::string many = board;
    for (int i = 0; i < 100; ++i) many += "sphere { <" + std::to_string(10 + 3 * i) + ", 0, 0>, 1 " + kGlass + " }\n";
    CHECK(stops(many).front());
    CHECK(!stops(many + "sphere { 1, 1 " + kGlass + " }").front());
}
