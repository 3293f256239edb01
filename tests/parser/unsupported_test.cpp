#include "tests/parser/grammar_support.h"

#include "render/scene/solids.h"
#include "render/scene/unsupported_features.h"

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
    CHECK(std::get<scene::Blob>(d.objects[0].details->written->parameters).components.size() == 2);
    CHECK(d.objects[0].details->photons != nullptr);
    CHECK(d.objects[0].transform->offset == glm::dvec3(0, 1, 0));
    CHECK((d.media.size() == 1 && d.rainbows.size() == 1));
    CHECK((d.global.radiosity && d.global.photons && !d.global.subsurface));
    CHECK(d.camera.bokeh);
    CHECK(d.objects[3].details->interior->media.size() == 1);
    std::set<std::string> told;
    for (const scene::Unsupported& u : d.unsupported) CHECK(told.insert(u.what).second);
}

namespace {

/// First lines of the warnings about a scene, without "test.pov:".
std::vector<std::string> told(const std::string& text)
{
    std::vector<std::string> lines;
    for (const parser::Message& message :
         parser::parse_text("#version 3.7; global_settings { assumed_gamma 1 } sphere { 0, 1 }\n" + text, "test.pov",
                            {})
             .messages) {
        CHECK(message.severity == parser::Severity::Warning);
        const std::string all = message_text(message);
        std::string line = all.substr(9, all.find('\n') - 9);
        lines.push_back(line);
    }
    return lines;
}

}  // namespace

TEST_CASE("what is not rendered is told once, at its first place", "[parser][unsupported]")
{
    scene::Description d;
    for (const char* const kind : {"sphere_dream", "cube_dream", "sphere_dream"}) {
        scene::Object object;
        object.details.edit().unsupported = kind;
        object.source.offset = static_cast<std::uint32_t>(d.unsupported_objects.size() + 3);
        d.unsupported_objects.push_back(object);
    }
    const std::vector<scene::Unsupported> found = scene::unsupported_features(d);
    REQUIRE(found.size() == 2);
    CHECK((found[0].what == "sphere_dream" && found[0].source.offset == 3));
    CHECK((found[1].what == "cube_dream" && found[1].source.offset == 4));
}

TEST_CASE("effects of the language are rendered: no word of them", "[parser][unsupported]")
{
    for (const char* const text : {
             "global_settings { radiosity { } }",
             "global_settings { photons { count 100 } }",
             "media { emission 1 }\nmedia { emission 2 }",
             "rainbow { angle 42 width 5 distance 10 direction z color_map { [0 rgb 0] [1 rgb 1] } }",
             "sphere { 0, 1 interior {\n media { emission 1 } } }",
             "camera { bokeh { pigment { rgb 1 } } }",
             "light_source { y, 1 media_attenuation on }\nlight_group { light_source { y, 1 media_interaction off } "
             "sphere { 0, 1 } }",
             "sphere { 0, 1 photons { target } }",
         }) {
        INFO(text);
        CHECK(told(text).empty());
    }
}

TEST_CASE("what media cannot be sampled by is refused", "[parser][media]")
{
    for (const std::string wrong :
         {"intervals 0", "samples 0", "samples 3, 2", "method 4", "method 0", "aa_level 0", "aa_threshold 0",
          "confidence 1", "confidence -0.1", "scattering { 1, 1 eccentricity 0.3 }"}) {
        INFO(wrong);
        CHECK(grammar_test::error_of("media { emission 1 " + wrong + " }").starts_with("1:"));
    }
    for (const std::string right : {"samples 2, 2", "aa_level 1", "confidence 0", "confidence 0.9999", "variance 0",
                                    "ratio 2", "intervals 1.5"}) {
        INFO(right);
        CHECK(grammar_test::error_of("media { emission 1 " + right + " }").empty());
    }
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
