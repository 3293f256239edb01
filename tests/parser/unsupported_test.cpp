#include "tests/parser/grammar_support.h"

#include "render/scene/solids.h"

#include <catch2/catch.hpp>

#include <set>
#include <string>
#include <vector>

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

TEST_CASE("what is not drawn yet is kept", "[parser][unsupported]")
{
    const scene::Description d = grammar_test::parsed(kScene);
    CHECK(d.unsupported_objects.empty());
    REQUIRE(d.objects.size() == 4);
    CHECK(std::get<scene::Blob>(d.objects[0].written->parameters).components.size() == 2);
    CHECK(d.objects[0].photons != nullptr);
    CHECK(d.objects[0].transform.offset == glm::dvec3(0, 1, 0));
    CHECK((d.media.size() == 1 && d.rainbows.size() == 1));
    CHECK((d.global.radiosity && d.global.photons && !d.global.subsurface));
    CHECK(d.camera.bokeh);
    CHECK(d.objects[3].interior->media.size() == 1);
    std::set<std::string> told;
    for (const scene::Unsupported& u : d.unsupported) CHECK(told.insert(u.what).second);
}

namespace {

/// First lines of the warnings about a scene, without "test.pov:" and what all have in common.
std::vector<std::string> told(const std::string& text)
{
    std::vector<std::string> lines;
    const std::string common = ": not rendered yet, the picture is made without it";
    for (const parser::Message& message :
         parser::parse_text("#version 3.7; global_settings { assumed_gamma 1 } sphere { 0, 1 }\n" + text, "test.pov",
                            {})
             .messages) {
        CHECK(message.severity == parser::Severity::Warning);
        std::string line = message.text.substr(9, message.text.find('\n') - 9);
        if (line.ends_with(common)) line.resize(line.size() - common.size());
        lines.push_back(line);
    }
    return lines;
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("what is not rendered is told once, at its place", "[parser][unsupported]")
{
    CHECK(told("global_settings { radiosity { } }").empty());
    CHECK(told("global_settings { photons { count 100 } }") == Lines{"2:19: warning: photons"});
    CHECK(told("media { emission 1 }\nmedia { emission 2 }").empty());
    CHECK(told("sphere { 0, 1 interior {\n media { emission 1 } } }").empty());
    CHECK(told("sphere { 0, 1 finish { subsurface { translucency 0.5 } } }") == Lines{"2:24: warning: subsurface"});
    CHECK(told("#default { finish { subsurface { translucency 0.5 } } } sphere { 0, 1 }") ==
          Lines{"2:21: warning: subsurface"});
    CHECK(told("mesh { triangle { 0, x, y texture { finish { subsurface { translucency 0.5 } } } } }") ==
          Lines{"2:46: warning: subsurface"});
}

TEST_CASE("media and what lights do in them are rendered", "[parser][unsupported]")
{
    CHECK(told("light_source { y, 1 media_attenuation on }\nlight_group { light_source { y, 1 media_interaction off } "
               "sphere { 0, 1 } }")
              .empty());
    CHECK(told("light_source { y, 1 media_attenuation on }\nlight_group { sphere { 0, 1 hollow interior { media { "
               "emission 1 } } } }")
              .empty());
}

TEST_CASE("scattering after another keeps what it does not name", "[parser][media]")
{
    const scene::Description d = grammar_test::parsed(
        "media { scattering { 5, rgb 0.3 eccentricity 0.5 extinction 0.25 } scattering { 1, rgb 0.2 } }");
    REQUIRE(d.media.size() == 1);
    const scene::Media::Scattering& scattering = d.media[0].scattering;
    CHECK(scattering.phase == scene::Media::Phase::Isotropic);
    CHECK(scattering.color == glm::vec3(0.2f));
    CHECK((scattering.eccentricity == 0.5 && scattering.extinction == 0.25));
}

TEST_CASE("what is declared and used by no object is not told", "[parser][unsupported]")
{
    const std::string declared = "#declare T = texture { finish { subsurface { translucency 0.5 } } }\n";
    CHECK(told(declared).empty());
    CHECK(told(declared + "union { sphere { 0, 1 } object { sphere { 0, 1 } texture { T } } }") ==
          Lines{"2:33: warning: subsurface"});
    CHECK(told("sphere { 0, 1 photons { target } }")
              .empty());  // POV-Ray shoots none without the block of global_settings
}

TEST_CASE("the dump shows it, the same each time", "[parser][unsupported]")
{
    const std::string text = scene::dump(grammar_test::parsed(kScene));
    CHECK(text == scene::dump(grammar_test::parsed(kScene)));
    for (const char* const line : {"count 50 400", "error_bound 0.5", "mm_per_unit 5", "threshold 0.6", "light_group",
                                   "eccentricity", "translucency", "scattering", "bokeh", "angle 42"}) {
        INFO(line);
        CHECK((text.find(line) != std::string::npos) == (std::string(line) != "eccentricity"));
    }
}
