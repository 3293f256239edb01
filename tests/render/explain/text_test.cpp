// What the text of a pixel says of small scenes whose answer is plain.
#include "render/explain/pixel.h"
#include "tests/parser/grammar_support.h"

#include <catch2/catch.hpp>

#include <string>

namespace {

using Catch::Matchers::Contains;

/// The middle of a picture of 9x9 pixels, seen from z = -5 along z.
std::string text_of(const std::string& scene)
{
    const scene::Description description = grammar_test::parsed(
        "#version 3.7; global_settings { assumed_gamma 1 }\ncamera { location -5*z look_at 0 }\n" + scene);
    plan::Options options;
    options.width = options.height = 9;
    plan::CompiledScene compiled = plan::compile(description, options);
    const explain::Pixel pixel = explain::explain_pixel(compiled, {}, 4, 4);
    CHECK(pixel.sum == pixel.rendered);
    return explain::pixel_text(pixel, description, compiled, {1, 2, 3});
}

const std::string kLamp = "light_source { -5*z rgb 1 }\n", kWhite = "pigment { rgb 1 }",
                  kMatte = "finish { ambient 0 diffuse .5 }";

}  // namespace

TEST_CASE("a lamp and one layer", "[explain]")
{
    const std::string text = text_of(kLamp + "sphere { 0, 1 " + kWhite + kMatte + " }");
    CHECK_THAT(text, Contains("pixel 4,4 of 9x9: 1 2 3 of 255, light <0.5, 0.5, 0.5>") &&
                         Contains("camera ray, level 1, from <0, 0, -5> towards <0, 0, 1>") &&
                         Contains("meets solid test.pov:4:1 at t 4, <0, 0, -1>") && Contains("normal <0, 0, -1>") &&
                         Contains("pigment rgbft <1, 1, 1, 0, 0>") &&
                         Contains("light 1 at <0, 0, -5>: diffuse <0.5, 0.5, 0.5>\n") &&
                         Contains("sum <0.5, 0.5, 0.5>, off the picture's by 0\n"));
}

TEST_CASE("why a lamp gives nothing", "[explain]")
{
    const std::string ball = "sphere { 0, 1 " + kWhite + kMatte + " }";
    CHECK_THAT(text_of("light_source { 5*z rgb 1 }" + ball), Contains("nothing, the surface faces away from it"));
    CHECK_THAT(
        text_of("light_source { <0,9,-5> rgb 1 spotlight point_at <0,9,0> radius 5 falloff 9 } sphere { 9*y, 1 }" +
                ball),
        Contains("nothing, it does not shine here: outside of its cone, or faded"));
    CHECK_THAT(text_of("light_source { <0,5,-6> rgb 1 }\nsphere { <0,2.5,-3.5>, .5 " + kWhite + " }\n" + ball),
               Contains("nothing, in the shadow of the object of test.pov:4:1, 3."));
    CHECK_THAT(
        text_of("light_source { <0,5,-6> rgb 1 }\nsphere { <0,2.5,-3.5>, .5 pigment { rgbf <1,0,0,1> } }\n" + ball),
        Contains("diffuse <0.") && Contains(", dimmed by the object of test.pov:4:1 that light passes"));
    CHECK_THAT(text_of("light_source { <0,5,-6> rgb 1 area_light x, y, 3, 3 }\nsphere { <0,2.5,-3.5>, .5 " + kWhite +
                       " }\n" + ball),
               Contains(" of its ") && Contains(" places are in the shadow of the object of test.pov:4:1"));
    CHECK_THAT(text_of("light_group { light_source { -5*z rgb 1 } sphere { 9, 1 } }" + ball),
               Contains("nothing, its light_group has no part in this surface"));
}

TEST_CASE("layers, highlights and entries of a texture map", "[explain]")
{
    const std::string shiny = "finish { ambient 0 diffuse .5 specular .25 }";
    CHECK_THAT(text_of(kLamp + "sphere { 0, 1 " + kWhite + shiny + " }"),
               Contains("diffuse <0.5, 0.5, 0.5>, highlight <0.25, 0.25, 0.25>"));
    CHECK_THAT(text_of(kLamp + "sphere { 0, 1 texture { " + kWhite + kMatte +
                       " } texture { pigment { rgbt <1,0,0,.5> } " + kMatte + " } }"),
               Contains("layer 1 from the top: pigment rgbft <1, 0, 0, 0, 0.5>, 0.5 of it its own") &&
                   Contains("layer 2 from the top: pigment rgbft <1, 1, 1, 0, 0>") &&
                   Contains("layers above let through <0.5, 0.5, 0.5>"));
    CHECK_THAT(text_of(kLamp + "sphere { 0, 1 texture { gradient z texture_map { [0 " + kWhite +
                       "] [1 pigment { rgb x }] } "
                       "translate .25*z } }"),
               Contains("of a texture_map, entry 1, weight 0.25:") && Contains("entry 2, weight 0.75:"));
    CHECK_THAT(text_of(kLamp + "sphere { 0, 1 texture { checker texture { " + kWhite +
                       " } texture { pigment { rgb x } } "
                       "translate .5 } }"),
               Contains("of a texture_map, entry ") && Contains(", weight 1:"));
}

TEST_CASE("rays that go on, and those that are cut off", "[explain]")
{
    const std::string mirror = "finish { ambient 0 diffuse 0 reflection .5 }";
    CHECK_THAT(text_of("background { rgb 1 } sphere { 0, 1 " + kWhite + mirror + " }"),
               Contains("reflects <0.5, 0.5, 0.5> of:") && Contains("reflected ray, level 2") &&
                   Contains("sees nothing but the background: <1, 1, 1>"));
    CHECK_THAT(text_of("background { rgb 1 } sphere { 0, 1 pigment { rgbt 1 } interior { ior 1.5 } }"),
               Contains("refracts <1, 1, 1> of:") && Contains("refracted ray, level 2"));
    CHECK_THAT(text_of("global_settings { max_trace_level 2 } box { -1, 1 " + kWhite + mirror +
                       " } box { <-1,-1,-9>, <1,1,-7> " + kWhite + mirror + " }"),
               Contains("of nothing, cut off: max_trace_level 2 is reached"));
    CHECK_THAT(text_of("global_settings { adc_bailout .3 } box { -1, 1 " + kWhite + mirror +
                       " } box { <-1,-1,-9>, <1,1,-7> " + kWhite + mirror + " }"),
               Contains("of nothing, cut off: its share 0.25 of the pixel is below adc_bailout 0.3"));
}

TEST_CASE("what fills the air", "[explain]")
{
    CHECK_THAT(text_of("fog { distance 4 rgb .5 }" + kLamp + "sphere { 0, 1 " + kWhite + kMatte + " }"),
               Contains("fog: <0.36788, 0.36788, 0.36788> comes through, <0.31606, 0.31606, 0.31606> is added"));
    CHECK_THAT(text_of("media { absorption .25 }" + kLamp + "sphere { 0, 1 " + kWhite + kMatte + " }"),
               Contains("media all over: <0.36788, 0.36788, 0.36788> comes through, <0, 0, 0> is added"));
}

TEST_CASE("light that comes from no lamp", "[explain]")
{
    CHECK_THAT(text_of("global_settings { radiosity { count 20 } } background { rgb 1 } sphere { 0, 1 " + kWhite +
                       kMatte + " }"),
               Contains("light of the surroundings <0."));
    CHECK_THAT(text_of("global_settings { photons { count 2000 } } light_source { <0,3,-3> rgb 1 } plane { z, 0 " +
                       kWhite + kMatte +
                       " } sphere { <0,1.5,-1.5>, .5 pigment { rgbt 1 } interior { ior 1.5 } "
                       "photons { target refraction on } }"),
               Contains("photons <"));
}
