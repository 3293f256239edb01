#include "tests/parser/grammar_support.h"

#include <catch2/catch.hpp>

#include <sstream>

using grammar_test::error_of;

TEST_CASE("a missing parameter is named", "[parser][error]")
{
    CHECK(error_of("plane { <0,1,0> }") ==
          "1:17: error: expected the plane's distance from the origin (a number), found '}'");
    CHECK(error_of("plane { }") == "1:9: error: expected the plane's normal, as in <0, 1, 0>, found '}'");
    CHECK(error_of("sphere { <0,1,0> pigment { rgb 1 } }") ==
          "1:18: error: expected the radius (a number), found 'pigment'");
    CHECK(error_of("blob { cylinder { x, x, 1, 1 } }").find("the two ends of this cylinder are one point") !=
          std::string::npos);
    CHECK(error_of("sphere 1") == "1:8: error: expected '{' after sphere, found '1'");
    CHECK(error_of("sphere { 0, 1 finish { phong } }") == "1:30: error: expected a number, found '}'");
    CHECK(error_of("sphere { 0, 1 pigment { gradient } }") ==
          "1:34: error: expected the gradient's direction, as in x or <0, 1, 0>, found '}'");
}

TEST_CASE("an undeclared name brings the nearest known one", "[parser][error]")
{
    CHECK(error_of("shpere { 0, 1 }") == "1:1: error: 'shpere' is not declared; did you mean 'sphere'?");
    CHECK(error_of("#declare Gold = texture { pigment { rgb x } }\nsphere { 0, 1 texture { Glod } }") ==
          "2:25: error: 'Glod' is not declared; did you mean 'Gold'?");
}

TEST_CASE("an identifier of another kind does not fit", "[parser][error]")
{
    CHECK(error_of("#declare F = camera { location 0 }\nsphere { 0, 1 texture { F } }") ==
          "2:25: error: expected an item of 'texture' or '}', found 'F'");
    CHECK(error_of("#declare S = sphere { 0, 1 }\nlight_source { S }") ==
          "2:16: error: this identifier is no light_source");
}

TEST_CASE("an unclosed block is told at its brace", "[parser][error]")
{
    CHECK(error_of("sphere { 0, 1\n") ==
          "1:8: error: this block of 'sphere' is not closed: the text ends before its '}'");
}

TEST_CASE("where the brace stands that is not closed", "[parser][error]")
{
    CHECK(error_of("sphere { 0, 1\n pigment { rgb 1 }\nbox { 0, 1 }") ==
          "3:1: error: expected an item of 'sphere' or '}', found 'box'; the '{' of 'sphere' stands in line 1");
    CHECK(error_of("union {\n sphere { 0, 1 pigment {\n rgb 1 }\n box { 0, 1 } }") ==
          "4:2: error: expected an item of 'sphere' or '}', found 'box'; the '{' of 'sphere' stands in line 2");
    CHECK(error_of("sphere { 0, 1 pigment { rgb 1 }\n finish { phong ") ==
          "2:17: error: expected a number, found the end of the text; the '{' in line 2 is not closed");
    CHECK(error_of("#declare A = array[2] {\n1, 2,\n3 }") ==
          "3:1: error: expected '}' after 2 elements, found '3'; the '{' of the array stands in line 1");
    CHECK(error_of("#declare F = function {\n x + y\n#declare G = 1;") ==
          "3:16: error: expected an operator or '}' at the end of the function, found the end of the text; the '{' of "
          "the function stands in line 1");
    CHECK(error_of("sphere { 0, 1 box { 0, 1 } }") == "1:15: error: expected an item of 'sphere' or '}', found 'box'");
}

TEST_CASE("what cannot be built is an error at its place", "[parser][error]")
{
    CHECK(error_of("plane { 0, 1 }") == "1:1: error: this plane's normal is zero, so it has no direction");
    CHECK(error_of("cylinder { y, y, 1 }") == "1:1: error: this cylinder's ends are the same point");
    CHECK(error_of("cone { y, 1, y, 2 }") == "1:1: error: this cone's ends are the same point");
    CHECK(error_of("sphere { 0, 1 matrix <1,0,0, 1,0,0, 0,1,1, 0,0,0> }") ==
          "1:49: error: this matrix is singular: it flattens space and cannot be undone");
    CHECK(error_of("camera { location y look_at y }") ==
          "1:1: error: the camera's location and look_at are the same point");
    CHECK(error_of("camera { angle 180 }") == "1:16: error: the camera's angle must be below 180 degrees");
}

TEST_CASE("textures and flags refuse what POV-Ray refuses", "[parser][error]")
{
    CHECK(error_of("sphere { 0, 1 pigment { rgb 1 } uv_mapping }") ==
          "1:33: error: 'uv_mapping' must stand before the texture");
    CHECK(error_of("sphere { 0, 1 interior_texture { pigment { rgb 1 } } }") ==
          "1:1: error: an interior_texture needs a texture on the same object");
    CHECK(error_of("sphere { 0, 1 split_union off }") == "1:27: error: 'split_union' needs a union or merge");
    CHECK(error_of("#declare P = texture { checker texture { pigment { rgb 1 } } texture { pigment { rgb 0 } } }\n"
                   "sphere { 0, 1 texture { P } texture { pigment { rgbt 1 } } }") ==
          "2:29: error: a texture cannot be layered over a patterned texture");
    CHECK(error_of("union { sphere { 0, 1 } pigment { rgb 1 } sphere { 0, 2 } }") ==
          "1:43: error: expected an item of 'union' or '}', found 'sphere'");
}

TEST_CASE("several mistakes are told in one run where that is safe", "[parser][error]")
{
    const auto lines = [](const std::string& text) {
        std::string all;
        try {
            grammar_test::parsed(text);
        } catch (const parser::Error& error) {
            std::istringstream in(error.what());
            for (std::string line; std::getline(in, line);)
                if (line.rfind("test.pov:", 0) == 0) all += line.substr(9) + '\n';
        }
        return all;
    };
    CHECK(lines("shpere { 0, 1 }\nbox { 0, 1 rotat x }\nsphere { 0, 1 }\nplane { y }\n") ==
          "1:1: error: 'shpere' is not declared; did you mean 'sphere'?\n"
          "2:12: error: 'rotat' is not declared; did you mean 'rotate'?\n"
          "4:11: error: expected the plane's distance from the origin (a number), found '}'\n");
    // What is skipped might declare a name, or the block's end is not certain: the first mistake is the only one.
    CHECK(lines("shpere { 0, 1 #declare A = 1; }\nbox { 0, A rotat x }\n") ==
          "1:1: error: 'shpere' is not declared; did you mean 'sphere'?\n");
    CHECK(lines("#declare A = B;\nshpere { 0, 1 }\n") == "1:14: error: 'B' is not declared\n");
    CHECK(lines("#if (1) shpere { 0, 1 } #end\nbox { 0, 1 rotat x }\n") ==
          "1:9: error: 'shpere' is not declared; did you mean 'sphere'?\n");
}
