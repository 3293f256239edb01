#include "csg/tree/program.h"
#include "parser/parse.h"
#include "render/plan/compiled_scene.h"
#include "tests/support/share.h"

#include <catch2/catch.hpp>

#include <array>
#include <random>

// Copies that share their parts beside the same copies compiled each for itself.
namespace {

/// Copies of two objects, turned and stretched. `apart`: each a statement of its own.
std::string text_of(int copies, bool apart)
{
    const std::string tall =
        R"( difference { union { cylinder { -y, y, 0.4 } torus { 0.5, 0.1 } box { <-0.2, 0, -1>, <0.2, 0.3, 1> } }
        sphere { y, 0.35 } sphere { -y, 0.3 } sphere { x/2, 0.2 } sphere { -x/2, 0.2 } box { -0.1, 0.1 } pigment { rgb x } }
    )";
    const std::string loose =
        R"( union { sphere { 0, 0.3 } sphere { x, 0.2 } sphere { y, 0.2 } sphere { z, 0.2 } sphere { -x, 0.1 }
        box { -0.2, -0.1 pigment { rgbt 0.5 } } cone { -y, 0.3, -0.5*y, 0 } mesh { triangle { x, y, z } pigment { rgb z } } pigment { rgbt 0.7 } }
    )";
    const auto declared = [&](const std::string& name, const std::string& body) {
        return apart ? "#macro " + name + "() " + body + " #end\n" : "#declare " + name + " =" + body;
    };
    const std::string call = apart ? "()" : "";
    return "#version 3.7; camera { location -40*z }\n" + declared("Tall", tall) + declared("Loose", loose) +
           "#for (I, 0, " + std::to_string(copies - 1) + ") object { #if (mod(I, 2)) Tall" + call + " #else Loose" +
           call +
           " #end rotate <31*I, 17*I, 5*I> scale <1 + 0.3*sin(I), 1, 0.7> translate <mod(I, 30), mod(int(I/30), 30), "
           "int(I/900)>*1.5 - 20 } #end\n";
}

plan::CompiledScene compiled(int copies, bool apart)
{
    return plan::compile(parser::parse_text(text_of(copies, apart), "test.pov", {}).scene, {});
}

}  // namespace

TEST_CASE("copies beyond the first share the parts of an object", "[plan][instances]")
{
    const plan::CompiledScene few = compiled(600, false), many = compiled(900, false);
    CHECK(few.geometry.instances.size() == 600 - 2 * 256);
    CHECK(many.geometry.instances.size() == 900 - 2 * 256);
    CHECK(many.geometry.programs.size() == few.geometry.programs.size());
    CHECK(many.geometry.store.all<csg::Sphere>().size() == few.geometry.store.all<csg::Sphere>().size());
    CHECK(compiled(600, true).geometry.instances.empty());
}

TEST_CASE("large objects share their parts from fewer copies on", "[plan][instances]")
{
    const auto copies = [](int solids) {
        const std::string text = "#version 3.7; #declare T = union { #for (I, 1, " + std::to_string(solids) +
                                 ") sphere { I*y, 0.1 } #end }\n#for (I, 1, 5) object { T translate I*x } #end";
        return plan::compile(parser::parse_text(text, "test.pov", {}).scene, {}).geometry.instances.size();
    };
    CHECK(copies(70'000) == 2);
    if constexpr (test::kEvery > 1) return;
    CHECK(copies(50'000) == 0);
    CHECK(copies(140'000) == 4);
}

TEST_CASE("what looks at the scene's own axes or lengths is not shared", "[plan][instances]")
{
    const auto copies = [](const std::string& part) {
        std::string body = "union { " + part;
        for (int k = 0; k < 8; ++k) body += " sphere { " + std::to_string(k) + "*y, 0.1 }";
        return plan::compile(
            parser::parse_text("#version 3.7; #declare T = " + body +
                                   " }\n#for (I, 0, 299) object { T rotate 90*z scale 3 translate 20*I*x } #end",
                               "test.pov", {})
                .scene,
            {});
    };
    // A cube that is closed along x alone: turned, it holds what its inside_vector, which does not turn, says.
    const std::string open =
        R"(mesh { triangle { <-1, -1, -1>, <-1, 1, -1>, <-1, 1, 1> } triangle { <-1, -1, -1>, <-1, 1, 1>, <-1, -1, 1> }
        triangle { <1, -1, -1>, <1, 1, -1>, <1, 1, 1> } triangle { <1, -1, -1>, <1, 1, 1>, <1, -1, 1> } inside_vector x })";
    CHECK(copies("sphere { 0, 0.2 }").geometry.instances.size() == 300 - 256);
    CHECK(copies(open).geometry.instances.empty());
    CHECK(copies("parametric { function { u } function { v } function { u*v } <0, 0>, <1, 1> contained_by { sphere { "
                 "0, 2 } } }")
              .geometry.instances.empty());
}

TEST_CASE("rays meet copies that share their parts where they meet copies that do not", "[plan][instances]")
{
    const plan::CompiledScene shared = compiled(700, false), apart = compiled(700, true);
    const csg::World one = shared.world(), other = apart.world();
    csg::Scratch scratch;
    std::mt19937 random(5);
    std::normal_distribution<double> any;
    const auto direction = [&] { return glm::normalize(glm::dvec3(any(random), any(random), any(random))); };
    int hits = 0, filtered = 0, held = 0;
    for (int k = 0; k < 2000; ++k) {
        INFO("ray " << k);
        const glm::dvec3 aim = glm::dvec3(random() % 30u, random() % 24u, 0) * 1.5 - 20.0 + 0.5 * direction();
        const csg::Ray ray{aim - 60.0 * direction(), {}};
        const csg::Ray at{ray.origin, glm::normalize(aim - ray.origin)};
        const csg::Hit a = one.nearest(at, 1e-4, numbers::kInfinity, 1, scratch),
                       b = other.nearest(at, 1e-4, numbers::kInfinity, 1, scratch);
        REQUIRE(a.found() == b.found());
        if (a.found()) {
            ++hits;
            REQUIRE(std::abs(a.t - b.t) < 1e-9);
            const csg::HitDetails p = one.details(at, a), q = other.details(at, b);
            REQUIRE(glm::length(p.normal - q.normal) < 1e-6);
            REQUIRE(glm::length(p.uv - q.uv) < 1e-6);
            const plan::Surface &s = shared.surfaces[a.surface], &t = apart.surfaces[b.surface];
            REQUIRE(s.opaque == t.opaque);
        }
        std::vector<csg::Hit> met, beside;
        const csg::Shadow shadow = one.shadow_crossings(at, 1e-3, 200.0, scratch, met);
        REQUIRE(shadow == other.shadow_crossings(at, 1e-3, 200.0, scratch, beside));
        REQUIRE(one.shadow(at, 1e-3, 200.0, scratch) == shadow);
        if (shadow == csg::Shadow::Filtered) {
            ++filtered;
            REQUIRE(met.size() == beside.size());
            for (std::size_t i = 0; i < met.size(); ++i) REQUIRE(std::abs(met[i].t - beside[i].t) < 1e-9);
        }
        std::vector<std::uint32_t> in, within;
        one.containing(aim, in);
        other.containing(aim, within);
        REQUIRE(in.empty() == within.empty());
        held += in.empty() ? 0 : 1;
    }
    CHECK(hits > 1000);
    CHECK(filtered > 20);
    CHECK(held > 100);
}

TEST_CASE("a tile meets copies that share their parts as its rays do alone", "[plan][instances]")
{
    const plan::CompiledScene shared = compiled(700, false);
    const csg::World world = shared.world();
    csg::Scratch scratch;
    std::mt19937 random(6);
    std::normal_distribution<double> any;
    const auto vector = [&] { return glm::dvec3(any(random), any(random), any(random)); };
    int hits = 0, copies = 0, blocked = 0;
    for (int tile = 0; tile < 300; ++tile) {
        const bool common = tile % 2 == 0;
        const glm::dvec3 aim = glm::dvec3(random() % 30u, random() % 24u, 0) * 1.5 - 20.0;
        const glm::dvec3 origin = aim - 20.0 * glm::normalize(vector());
        csg::RayTile rays;
        rays.count = tile % 5 == 0 ? 7 : csg::kTileRays;
        rays.common_origin = common;
        for (std::size_t k = 0; k < csg::kTileRays; ++k) {
            const glm::dvec3 from = common ? origin : origin + 0.3 * vector();
            rays.set(k, {from, glm::normalize(aim + 0.4 * vector() - from)}, 1e-4, 60.0);
        }
        csg::HitTile met;
        std::array<csg::Shadow, csg::kTileRays> ending;
        world.nearest(rays, 1, scratch, met);
        world.shadow(rays, scratch, ending.data());
        for (int i = 0; i < rays.count; ++i) {
            INFO("tile " << tile << ", ray " << i);
            const auto k = static_cast<std::size_t>(i);
            const csg::Hit alone = world.nearest(rays.ray(i), 1e-4, 60.0, 1, scratch), together = met.at(i);
            REQUIRE(together.found() == alone.found());
            REQUIRE(ending[k] == world.shadow(rays.ray(i), 1e-4, 60.0, scratch));
            blocked += ending[k] == csg::Shadow::Blocked ? 1 : 0;
            if (!alone.found()) continue;
            ++hits;
            copies += alone.instance != csg::Hit::kNoInstance ? 1 : 0;
            REQUIRE(together.t == alone.t);
            REQUIRE(together.surface == alone.surface);
            REQUIRE(together.part == alone.part);
            REQUIRE(together.face == alone.face);
            REQUIRE(together.instance == alone.instance);
            REQUIRE(together.inverted == alone.inverted);
        }
    }
    CHECK(hits > 4000);
    CHECK(copies > 1000);
    CHECK(blocked > 1000);
}
