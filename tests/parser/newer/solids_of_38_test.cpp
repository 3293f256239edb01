#include "render/scene/solids.h"
#include "render/scene/textures/image_map.h"
#include "tests/parser/grammar_support.h"

#include <catch2/catch.hpp>

#include <cstdio>
#include <fstream>

// Solids, meshes, cameras that POV-Ray 3.8 added: what they are read as, and what is refused.
namespace {

using grammar_test::error_of;
using grammar_test::parsed;

const std::string k38 = "#version 3.8; global_settings { assumed_gamma 1 }\n", k37 = "#version 3.7;\n";

template <class Solid>
Solid solid38_of(const std::string& text)
{
    const scene::Description d = parsed(k38 + text);
    REQUIRE(d.objects.size() == 1);
    return std::get<Solid>(d.objects.front().details->written->parameters);
}

scene::Torus torus_of(const std::string& text)
{
    const scene::Description d = parsed(text);
    return std::get<scene::Torus>(d.objects.front().shape);
}

/// A file in the current folder that goes with the test.
struct WrittenFile {
    explicit WrittenFile(const std::string& text) { std::ofstream(name) << text; }
    ~WrittenFile() { std::remove(name); }
    static constexpr const char* name = "solids_of_38_test.obj";
};

}  // namespace

TEST_CASE("lemons and eggs of 3.8 have their parameters", "[parser][3.8]")
{
    const auto lemon =
        solid38_of<scene::Lemon>("lemon { <0, 0, 0>, 0.5, <0, 2, 0> 0.3, 2 open sturm pigment { rgb 1 } }");
    CHECK((lemon.base_radius == 0.5 && lemon.cap_radius == 0.3 && lemon.arc_radius == 2.0 && lemon.open));
    CHECK(lemon.cap == glm::dvec3(0, 2, 0));
    CHECK(solid38_of<scene::Lemon>("lemon { 0, 1, y, 1, 0.2 }").arc_radius == Approx(std::sqrt(1.25)));
    CHECK(error_of(k38 + "lemon { 0, -1, y, 1, 2 }").find("must not be negative") != std::string::npos);
    CHECK(error_of(k38 + "lemon { y, 1, y, 1, 2 }").find("the same point") != std::string::npos);

    const auto ovus = solid38_of<scene::Ovus>("ovus { 1, 0.5 precision 0.001 distance 2 radius 3 radius 4 sturm }");
    CHECK((ovus.radius == 4.0 && ovus.distance == 2.0));
    CHECK(error_of(k38 + "ovus { 1, 0.5 distance 0.5 }").find("below its first radius") != std::string::npos);
    CHECK(error_of(k38 + "ovus { 1, 0.5 radius 1 }").find("half of the sum") != std::string::npos);
    const auto shape = [](const std::string& text) { return parsed(text).objects.front().shape; };
    CHECK(std::get<scene::Sphere>(shape(k38 + "ovus { 1, 0 }")).radius == 2.0);
    CHECK(std::holds_alternative<scene::Freeform>(shape(k37 + "ovus { 1, 0 }")));
}

TEST_CASE("a torus of 3.8 says what its spindle is", "[parser][3.8]")
{
    using Spindle = scene::Torus::Spindle;
    CHECK(torus_of(k37 + "torus { 1, 2 }").spindle == Spindle::Usual);
    CHECK(torus_of(k38 + "torus { 1, 2 }").spindle == Spindle::Union);
    CHECK(torus_of(k38 + "torus { 1, 2 difference sturm }").spindle == Spindle::Difference);
    CHECK(torus_of(k38 + "torus { 1, 2 merge }").spindle == Spindle::Merge);
    CHECK(torus_of(k38 + "torus { 1, 2 intersection }").spindle == Spindle::Intersection);
    const scene::Description d = parsed(k38 + "torus { -1, 2 }");
    CHECK((d.objects.front().inverse && std::get<scene::Torus>(d.objects.front().shape).major == 1.0));
    CHECK_FALSE(parsed(k37 + "torus { -1, 2 }").objects.front().inverse);
}

TEST_CASE("a user-defined camera's rays are functions, or vectors written later", "[parser][3.8]")
{
    const std::string three = " { function { x } function { y }, function { 1 } } ";
    const scene::Camera camera =
        parsed(k38 + "camera { user_defined location" + three + "direction" + three + "}").camera;
    CHECK(camera.kind == scene::Camera::Kind::UserDefined);
    CHECK((camera.functions->location[0] && camera.functions->direction[2]));
    const scene::Camera vector =
        parsed(k38 + "camera { user_defined location" + three + "direction" + three + "location <1, 2, 3> }").camera;
    CHECK((!vector.functions->location[0] && vector.functions->direction[0] && vector.location == glm::dvec3(1, 2, 3)));
    CHECK_FALSE(parsed(k38 + "camera { user_defined location 0 }").camera.functions);
    CHECK(error_of(k38 + "camera { user_defined location { function { x } } }").find("'function' and its body") !=
          std::string::npos);
    CHECK_FALSE(error_of(k38 + "camera { location" + three + "}").empty());
}

TEST_CASE("a mesh takes its triangles from an OBJ file", "[parser][3.8]")
{
    const WrittenFile file(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\nusemtl c\nf 1 2 4\n");
    const std::string start = std::string("mesh { obj \"") + WrittenFile::name + "\" ";
    const auto mesh = [](const std::string& text) {
        return std::get<scene::Mesh>(parsed(text).objects.front().shape).data;
    };
    const auto plain = mesh(k38 + start + "inside_vector z pigment { rgb 1 } }");
    CHECK((plain->faces.size() == 3 && plain->vertices.size() == 4 && plain->textures.empty() &&
           plain->has_inside_vector));
    const auto dressed = mesh(k38 + "#declare M_b_s = texture { pigment { rgb 1 } }\n" + start +
                              "texture_list { \"a\" texture { pigment { rgb x } } prefix \"M_\" suffix \"_s\" } }");
    REQUIRE(dressed->textures.size() == 2);
    CHECK(dressed->faces[0].texture[0] == 0);
    CHECK(dressed->faces[1].texture[2] == 1);
    CHECK(dressed->faces[2].texture[0] == scene::MeshData::kNone);
    CHECK(error_of(k38 + "mesh { obj \"nothing.obj\" }").find("cannot find the mesh file 'nothing.obj'") !=
          std::string::npos);
    const WrittenFile broken("v 0 0 0\nv 1 0 0\nf 1 2 7\n");
    CHECK(error_of(k38 + start + "}").find("solids_of_38_test.obj:3: there is no vertex 7") != std::string::npos);
}

TEST_CASE("polarity and a text's character map are read", "[parser][3.8]")
{
    CHECK(solid38_of<scene::Isosurface>("isosurface { function { x } polarity on }").polarity == 1.0);
    CHECK(solid38_of<scene::Isosurface>("isosurface { function { x } polarity -2 }").polarity == -2.0);
    CHECK(error_of(k38 + "text { ttf \"/usr/share/povray-3.7/include/timrom.ttf\" cmap { 3, 0.5 } \"a\", 1, 0 }")
              .find("whole numbers") != std::string::npos);
}

TEST_CASE("a finish of 3.8 needs no number, and looks at its mirror when it ends", "[parser][3.8]")
{
    const auto finish = [](const std::string& version, const std::string& written) {
        const scene::Description d = parsed(version + "sphere { 0, 1 finish { " + written + " } }");
        return std::get<std::vector<scene::Layer>>(d.objects.front().texture->kind).front().finish;
    };
    CHECK(finish(k38, "fresnel use_alpha emission 0.5")->fresnel == 1.0f);
    CHECK(finish(k38, "fresnel use_alpha emission 0.5")->use_alpha);
    const auto head_on = [&](const std::string& version, const std::string& written) {
        return finish(version, written)->reflection.min.x;
    };
    CHECK(head_on(k38, "reflection { 0.5 fresnel }") == 0.0f);
    CHECK(head_on(k38, "reflection { 0.5, 0.5 fresnel }") == 0.0f);
    CHECK(head_on(k38, "reflection { 0.5 fresnel } fresnel off") == 0.5f);
    CHECK(head_on(k38, "reflection 0.5 fresnel on") == 0.0f);
    CHECK(head_on(k38, "reflection { 0.25, 0.5 } fresnel on") == 0.25f);
    CHECK(head_on(k37, "reflection { 0.5 fresnel }") == 0.0f);
    CHECK(head_on(k37, "reflection { 0.5, 0.5 fresnel }") == 0.5f);
}

TEST_CASE("a lamp's power counts alone where #version is 3.8 at the lamp", "[parser][3.8]")
{
    const auto alone = [](const std::string& before) {
        const scene::Description d = parsed(before + "light_source { 0, 1 fade_power 2 }");
        return std::get<scene::Shared<scene::Light>>(d.objects.front().shape)->fades_from_start;
    };
    CHECK(alone(k38));
    CHECK_FALSE(alone(k37));
    CHECK_FALSE(alone(k38 + "#version 3.7;"));
    CHECK_FALSE(alone("#version 3.79;"));
}

TEST_CASE("a picture follows the #version of the place that names it", "[parser][3.8]")
{
    const auto version = [](const std::string& before, const std::string& after) {
        const scene::Description d =
            parsed(before + "sphere { 0, 1 pigment { image_map { function 2, 2 { x } } } }" + after);
        const auto& layer = std::get<std::vector<scene::Layer>>(d.objects.front().texture->kind).front();
        const auto& pattern = std::get<scene::Shared<scene::PatternedPigment>>(layer.pigment.kind)->pattern;
        return std::get<std::shared_ptr<const scene::ImageMap>>(pattern.data)->source.version;
    };
    CHECK(version(k38, "") == 380);
    CHECK(version(k38, "#version 3.5;") == 380);
    CHECK(version("#version 3.5;", "#version 3.7;") == 350);
    CHECK(version("", "") == 362);
}

TEST_CASE("a pattern after another begins anew in 3.8 and keeps its place before", "[parser][3.8]")
{
    const char* const written[] = {"#default { pigment { granite scale 0.3 turbulence 0.5 frequency 3 noise_generator "
                                   "1 } }\nsphere { 0, 1 pigment { bozo } }",
                                   "#declare P = pigment { rgb 1 scale 0.3 turbulence 0.5 frequency 3 noise_generator "
                                   "1 }\nsphere { 0, 1 pigment { P bozo } }"};
    for (const char* text : written)
        for (const bool newer : {false, true}) {
            INFO(text << " " << newer);
            const scene::Description d = parsed((newer ? k38 : k37) + text);
            const auto& pigment = std::get<std::vector<scene::Layer>>(d.objects.front().texture->kind).front().pigment;
            const scene::Pattern& pattern = std::get<scene::Shared<scene::PatternedPigment>>(pigment.kind)->pattern;
            CHECK(pattern.name == "bozo");
            CHECK(pattern.warps.empty() == newer);
            CHECK(pattern.turbulence.has_value() != newer);
            CHECK(pattern.frequency == (newer ? 1 : 3));
            CHECK(pattern.noise_generator == (newer ? 0 : 1));
        }
}

TEST_CASE("a period without a member is an error wherever a name may stand", "[parser][language]")
{
    const std::string declared = "#version 3.8;\n#declare D = dictionary { .A: 1 }\n";
    for (const char* text :
         {"sphere { 0, 1 translate D.}", "sphere { 0, 1 translate local.}", "object { D.< }", "D."}) {
        INFO(text);
        CHECK_FALSE(error_of(declared + text).empty());
    }
}
