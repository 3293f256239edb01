#include "tests/parser/grammar_support.h"

#include <catch2/catch.hpp>

#include <set>

// Constructs that are not drawn yet are read whole, kept, and shown by the dump.
namespace {

const char* const kScene = R"(#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 50, 400 error_bound 0.5 } photons { count 1000 media 10 } mm_per_unit 5 }
media { emission 0.1 scattering { 2, rgb 0.5 extinction 0.25 } density { spherical color_map { [0 rgb 0] [1 rgb 1] } } translate x }
rainbow { direction x angle 42 width 5 distance 10 color_map { [0 rgb 0] [1 rgb 1] } }
blob { threshold 0.6 sphere { 0, 1, strength 2 } cylinder { 0, y, 1, -1 pigment { rgb x } } sturm translate y photons { target } }
union { sphere { 0, 1 } light_group { sphere { 0, 1 } } }
light_group { sphere { 0, 2 } global_lights off }
sphere { 0, 1 finish { subsurface { translucency rgb 0.5 } } interior { ior 1.5 media { absorption 1 } } }
camera { location -z bokeh { pigment { rgb 1 } } }
)";

}  // namespace

TEST_CASE("what is not drawn yet is kept", "[parser][undrawn]")
{
    const scene::Description d = grammar_test::parsed(kScene);
    REQUIRE(d.undrawn.size() == 2);
    CHECK(d.undrawn[0].undrawn == "light_group");
    CHECK(d.undrawn[1].undrawn == "light_group");
    REQUIRE(d.objects.size() == 3);
    CHECK(d.objects[0].shape_block->items.size() == 4);
    CHECK(d.objects[0].photons != nullptr);
    CHECK(d.objects[0].transform.offset == glm::dvec3(0, 1, 0));
    CHECK(d.effects.size() == 2);
    CHECK(d.global.effects.size() == 2);
    CHECK(d.camera.undrawn.size() == 1);
    CHECK(d.objects[2].interior->media.size() == 1);
    std::set<std::string> told;
    for (const scene::Unsupported& u : d.unsupported) CHECK(told.insert(u.what).second);
}

TEST_CASE("the dump shows it, the same each time", "[parser][undrawn]")
{
    const std::string text = scene::dump(grammar_test::parsed(kScene));
    CHECK(text == scene::dump(grammar_test::parsed(kScene)));
    for (const char* const line : {"count 50 400", "error_bound 0.5", "mm_per_unit 5", "threshold 0.6", "global_lights 0", "eccentricity",
                                   "translucency", "scattering", "not drawn yet", "bokeh", "angle 42"}) {
        INFO(line);
        CHECK((text.find(line) != std::string::npos) == (std::string(line) != "eccentricity"));
    }
}
