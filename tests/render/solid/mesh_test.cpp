#include "render/solid/mesh/check.h"
#include "render/solid/mesh/deviation.h"
#include "render/solid/mesh/mesher.h"
#include "render/solid/measure/measure.h"
#include "render/solid/remesh/crossings.h"
#include "tests/render/solid/body_of.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>

namespace {

solid::TriangleMesh mesh_of_text(const char* scene, solid::RefineOptions options, solid::MeshFacts& facts)
{
    const solid::Body body = body_of(scene);
    double error = 0.0;
    std::uint64_t rays = 0;
    const csg::Aabb extent = solid::require_extent(body, error, rays);
    return solid::mesh_of(body, extent, options, facts);
}

}  // namespace

TEST_CASE("meshes close, lie near the body and hold its volume", "[solid]")
{
    const char* const scenes[] = {
        "sphere { 0, 1 }",
        "box { -1, 1 rotate <20, 30, 40> }",
        "difference { box { -1, 1 } cylinder { -2 * y, 2 * y, 0.5 } }",
        // Faces in one plane, and an edge where two boxes touch.
        "difference { box { -1, 1 } difference { box { <-0.5, -1, -1>, <0.5, 1, 1> } box { <-0.2, -1, -1>, <0.2, 1, 1> "
        "} } }",
        "union { box { 0, 1 } box { <1, 0, 0>, <2, 1, 1> } }",
        // Ends that are not drawn have no normal: this one crashed.
        "intersection { height_field { function 8, 8 { 0.4 + 0.2 * x } translate <-0.5, 0, -0.5> scale 2 } box { "
        "<-0.9, -0.3, "
        "-0.9>, <0.9, 3, 0.9> } }",
        "difference { sphere { 0, 1 } sphere { 0, 0.95 } cylinder { 0, 2 * y, 0.4 } }",
    };
    for (const char* const scene : scenes) {
        INFO(scene);
        const solid::Body body = body_of(scene);
        double error = 0.0;
        std::uint64_t rays = 0;
        const csg::Aabb extent = solid::require_extent(body, error, rays);
        solid::RefineOptions options;
        options.tolerance = 0.02;
        solid::MeshFacts facts;
        const solid::TriangleMesh mesh = solid::mesh_of(body, extent, options, facts);
        const solid::MeshCheck found = solid::check(mesh);
        CHECK(found.complaint().empty());
        const solid::Deviation off = solid::deviation(body, extent, mesh, 5000, options.tolerance, nullptr);
        CHECK(off.from_mesh <= options.tolerance);
        CHECK(off.from_body <= options.tolerance);
        solid::MeasureOptions measuring;
        measuring.precision = 1e-3;
        const solid::Measures exact = solid::measure(body, measuring);
        CHECK(std::abs(found.volume - exact.volume.value) <=
              exact.volume.error + 0.5 * options.tolerance * found.surface);
    }
}

TEST_CASE("the check finds what does not close", "[solid]")
{
    solid::TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    CHECK(solid::check(mesh).good());
    CHECK(solid::check(mesh).volume == Approx(1.0 / 6.0));
    solid::TriangleMesh open = mesh;
    open.triangles.pop_back();
    CHECK(solid::check(open).open_edges == 3);
    solid::TriangleMesh turned = mesh;
    std::swap(turned.triangles[0][1], turned.triangles[0][2]);
    CHECK(solid::check(turned).open_edges == 3);
    solid::TriangleMesh pinched = mesh;  // two that share a corner
    for (const glm::vec3 v : {glm::vec3(-1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(0, 0, -1)})
        pinched.vertices.push_back(v);
    for (const std::array<std::uint32_t, 3> t :
         {std::array<std::uint32_t, 3>{0, 4, 5}, {0, 6, 4}, {4, 6, 5}, {0, 5, 6}})
        pinched.triangles.push_back(t);
    CHECK(solid::check(pinched).crowded_vertices == 1);
}

TEST_CASE("no triangle passes through another", "[solid]")
{
    for (const char* const scene :
         {"sphere { 0, 1 }", "difference { box { -1, 1 rotate <20, 30, 40> } cylinder { -2 * y, 2 * y, 0.5 } }",
          "torus { 1, 0.3 }", "merge { box { 0, 1 } sphere { 1, 0.6 } }"}) {
        INFO(scene);
        solid::RefineOptions options;
        options.tolerance = 0.2;
        options.cells = 6;
        solid::MeshFacts facts;
        const solid::TriangleMesh mesh = mesh_of_text(scene, options, facts);
        REQUIRE(mesh.triangles.size() > 100);
        REQUIRE(mesh.triangles.size() < 20000);
        CHECK(solid::check(mesh).good());
        CHECK(solid::crossings(mesh) == 0);
    }
}

TEST_CASE("a mesh that has no time to get finer closes all the same", "[solid]")
{
    solid::RefineOptions options;
    options.tolerance = 1e-4;
    options.deadline = std::chrono::steady_clock::now();
    solid::MeshFacts facts;
    const solid::TriangleMesh mesh = mesh_of_text("difference { sphere { 0, 1 } torus { 0.7, 0.4 } }", options, facts);
    CHECK(facts.late);
    CHECK(facts.rounds == 0);
    CHECK(solid::check(mesh).good());
}
