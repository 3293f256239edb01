#include "parser/parse.h"
#include "render/plan/compiled_scene.h"

#include <catch2/catch.hpp>

#include <string>

// What many objects wear in places of their own is compiled once, but for what tells the places apart.
namespace {

/// So many objects, each with the item that `worn` makes of its number.
plan::CompiledScene wearing(const std::string& declared, int objects, const std::string& worn)
{
    const std::string text = "#version 3.7; camera { location -9*z }\n" + declared + "\nunion { #for (I, 1, " +
                             std::to_string(objects) + ") sphere { I*x, 0.4 " + worn + " } #end translate <1, 2, 3> }";
    return plan::compile(parser::parse_text(text, "test.pov", {}).scene, {});
}

/// Compiled with 50 objects and with 200: each object adds one pattern and one step of its warps, and no object adds
/// any of the rest.
void check_growth(const std::string& declared, const std::string& worn)
{
    const texture::TextureSet few = wearing(declared, 50, worn).textures, many = wearing(declared, 200, worn).textures;
    CHECK(many.textures.size() - few.textures.size() == 150);
    CHECK(many.patterns.size() - few.patterns.size() == 150);
    CHECK(many.warps.size() - few.warps.size() == 150);
    CHECK(many.keys.size() == few.keys.size());
    CHECK(many.children.size() == few.children.size());
    CHECK(many.finishes.size() == few.finishes.size());
    CHECK(many.images.size() == few.images.size());
}

const std::string kNested = "checker pigment { granite scale 2 } pigment { bozo rotate 20*y } scale 3";

}  // namespace

TEST_CASE("moved copies of a nest of pigments share what is inside", "[plan][textures]")
{
    check_growth("#declare P = pigment { " + kNested + " }", "pigment { P scale I }");
    check_growth("#declare P = pigment { average pigment_map { [1 granite] [2 bozo scale 3] } }",
                 "pigment { P translate I*x }");
    check_growth("#declare P = pigment { pigment_pattern { " + kNested + " } color_map { [0 rgb x] [1 rgb y] } }",
                 "pigment { P translate I*x }");
}

TEST_CASE("moved copies of maps share their entries", "[plan][textures]")
{
    check_growth("#declare P = pigment { wood color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } }",
                 "pigment { P scale I }");
    check_growth("#declare N = normal { wood normal_map { [0 granite] [1 bumps scale 2] } }", "normal { N scale I }");
    check_growth("#declare N = normal { wood slope_map { [0 <0, 1>] [1 <1, 0>] } }", "normal { N scale I }");
    check_growth("#declare T = texture { marble texture_map { [0 pigment { rgb x }] [1 pigment { " + kNested +
                     " } finish { phong 1 }] } }",
                 "texture { T scale I }");
}

TEST_CASE("maps that differ in one bit are two", "[plan][textures]")
{
    const auto entries = [](const std::string& second) {
        return wearing("", 2, "pigment { wood color_map { [0 rgb x] [1 " + second + "] } }").textures.keys.size();
    };
    CHECK(entries("rgb y") == entries("rgb z"));
    CHECK(entries("rgb I") == entries("rgb y") + 2);
    CHECK(entries("rgbf <0, 1, 0, I/1e6>") == entries("rgb y") + 2);
}

TEST_CASE("copies share their textures where they stand in the same place", "[plan][textures]")
{
    const auto textures = [&](int copies, const std::string& place) {
        const std::string text =
            "#version 3.7; camera { location -9*z }\n"
            "#declare U = union { sphere { 0, 1 pigment { granite } } box { 0, 1 pigment { bozo } } }\n"
            "#for (I, 1, " +
            std::to_string(copies) + ") object { U " + place + " } #end";
        return plan::compile(parser::parse_text(text, "test.pov", {}).scene, {}).textures.textures.size();
    };
    CHECK(textures(20, "translate 5*y") == textures(10, "translate 5*y"));
    CHECK(textures(20, "translate I*y") == textures(10, "translate I*y") + 20);
}

TEST_CASE("a nest that names what is inside of it twice is gone through once", "[plan][textures]")
{
    constexpr int kDepth = 60;  // 2^60 leaves
    const std::string loop = "#for (I, 1, " + std::to_string(kDepth) + ") ";
    const std::string declared = "#declare P = pigment { slope y } #declare N = normal { bumps } " + loop +
                                 "#declare P = pigment { checker pigment { P } pigment { P } scale 1/2 } #end " + loop +
                                 "#declare N = normal { wood normal_map { [0 N] [1 N] } } #end";
    const plan::CompiledScene scene = wearing(declared, 3, "pigment { P scale I } normal { N scale I }");
    CHECK(scene.textures.pigments.size() < 3 * kDepth);
    CHECK(scene.textures.normals.size() < 3 * kDepth);
    CHECK(scene.traits.surfaces[0].looked_around);
}
