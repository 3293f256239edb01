#include "render/solid/measure/measure.h"
#include "render/solid/mesh/check.h"
#include "render/solid/remesh/crossings.h"
#include "render/solid/remesh/foot.h"
#include "render/solid/remesh/half_edges.h"
#include "render/solid/mesh/mesher.h"
#include "render/solid/remesh/remesh.h"
#include "tests/render/solid/body_of.h"

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

namespace {

solid::TriangleMesh good_mesh(const solid::Body& body, const solid::RefineOptions& options, solid::MeshFacts& facts)
{
    double error = 0.0;
    std::uint64_t rays = 0;
    const csg::Aabb extent = solid::require_extent(body, error, rays);
    return solid::good_mesh_of(body, extent, options, facts, [](const solid::TriangleMesh&) { return true; });
}

solid::TriangleMesh remeshed(const char* scene, double tolerance)
{
    solid::RefineOptions options;
    options.tolerance = tolerance;
    solid::MeshFacts facts;
    return good_mesh(body_of(scene), options, facts);
}

double least_angle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const auto at = [](const glm::dvec3& u, const glm::dvec3& v) {
        return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)) * 57.29577951308232;
    };
    return std::min(at(b - a, c - a), std::min(at(c - b, a - b), at(a - c, b - c)));
}

/// The share of triangles whose least angle is below ten degrees.
double thin_share(const solid::TriangleMesh& mesh)
{
    std::size_t thin = 0;
    for (const auto& t : mesh.triangles)
        thin += least_angle(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]) < 10.0 ? 1 : 0;
    return static_cast<double>(thin) / static_cast<double>(mesh.triangles.size());
}

/// Six times the volume of a tetrahedron, with its sign.
double volume(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
    return glm::dot(glm::cross(b - a, c - a), d - a);
}

using Corners = std::array<glm::dvec3, 3>;

/// Whether a side of one runs through the other: its ends lie on either side, and the tetrahedra of it with the other's
/// three sides turn alike.
bool runs_through(const Corners& one, const Corners& other)
{
    const auto& [a, b, c] = other;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 &p = one[k], &q = one[(k + 1) % 3];
        const double x = volume(p, q, a, b), y = volume(p, q, b, c), z = volume(p, q, c, a);
        if (volume(a, b, c, p) * volume(a, b, c, q) < 0.0 && x * y > 0.0 && y * z > 0.0) return true;
    }
    return false;
}

std::size_t crossings_by_volumes(const solid::TriangleMesh& mesh)
{
    const auto corners = [&](std::size_t i) {
        const auto& t = mesh.triangles[i];
        return Corners{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    };
    std::size_t found = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            found += runs_through(corners(i), corners(k)) || runs_through(corners(k), corners(i)) ? 1 : 0;
    return found;
}

/// The corners of a tetrahedron, an octahedron's and more: a closed mesh to change.
solid::TriangleMesh octahedron()
{
    solid::TriangleMesh mesh;
    mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    return mesh;
}

/// The mesh of a body that has to be made anew, closed and without thin triangles.
solid::TriangleMesh remeshed(const solid::Body& body, double tolerance)
{
    solid::RefineOptions options;
    options.tolerance = tolerance;
    solid::MeshFacts facts;
    solid::TriangleMesh mesh = good_mesh(body, options, facts);
    CHECK(facts.remeshed);
    CHECK(solid::check(mesh).good());
    CHECK(thin_share(mesh) < 0.01);
    return mesh;
}

}  // namespace

TEST_CASE("connections change and the mesh stays closed", "[solid]")
{
    solid::HalfEdges mesh;
    REQUIRE(mesh.take(octahedron()));
    const double volume = solid::check(mesh.mesh()).volume;
    for (std::uint32_t h = 0; h < 24; ++h) {
        mesh.split(h, 0.5 * (mesh.places[mesh.tail(h)] + mesh.places[mesh.head(h)]));
        const solid::MeshCheck found = solid::check(mesh.mesh());
        REQUIRE(found.good());
        REQUIRE(found.volume == Approx(volume));
    }
    std::size_t flipped = 0, collapsed = 0;
    for (std::uint32_t h = 0; h < 3 * mesh.triangles(); h += 7) {
        if (!mesh.can_flip(h)) continue;
        mesh.flip(h);
        ++flipped;
        REQUIRE(solid::check(mesh.mesh()).good());
    }
    CHECK(flipped > 5);
    for (std::uint32_t h = 0; h < 3 * mesh.triangles(); ++h) {
        if (!mesh.has_triangle(h / 3) || !mesh.can_collapse(h)) continue;
        mesh.collapse(h);
        ++collapsed;
        REQUIRE(solid::check(mesh.mesh()).open_edges == 0);
        REQUIRE(solid::check(mesh.mesh()).crowded_edges == 0);
        REQUIRE(solid::check(mesh.mesh()).crowded_vertices == 0);
    }
    CHECK(collapsed > 15);
    CHECK(mesh.mesh().triangles.size() >= 4);
}

TEST_CASE("a ball's triangles have their corners on it, its normals and no slivers", "[solid]")
{
    const solid::TriangleMesh mesh = remeshed("sphere { <1, 2, 3>, 2 }", 0.01);
    CHECK(solid::check(mesh).good());
    CHECK(mesh.triangles.size() < 6000);
    CHECK(thin_share(mesh) == 0.0);
    double off = 0.0, turned = 0.0, away = 1.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::dvec3 a = mesh.vertices[mesh.triangles[i][0]], b = mesh.vertices[mesh.triangles[i][1]],
                         c = mesh.vertices[mesh.triangles[i][2]];
        away = std::min(away, glm::dot(glm::normalize(glm::cross(b - a, c - a)),
                                       glm::normalize((a + b + c) / 3.0 - glm::dvec3(1, 2, 3))));
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 d = glm::dvec3(mesh.vertices[mesh.triangles[i][k]]) - glm::dvec3(1, 2, 3);
            off = std::max(off, std::abs(glm::length(d) - 2.0));
            turned = std::max(turned, glm::length(glm::dvec3(mesh.normals[mesh.normal_of[i][k]]) - 0.5 * d));
        }
    }
    CHECK(off < 2e-6);
    CHECK(turned < 1e-5);
    CHECK(away > std::cos(3.0 / 57.3));
}

TEST_CASE("a corner's normals are those of its sides where a round face runs out in it", "[solid]")
{
    // The ball cuts the lower corners of the prism off, in patches that end where it leaves the faces.
    const solid::TriangleMesh mesh = remeshed("intersection { #for (I, 0, 5) plane { x, 1.5 rotate 60*I*y } #end "
                                              "plane { y, 0.3 } plane { -y, 0.7 } sphere { <0, 1, 0>, 2.35 } }",
                                              0.01);
    double turned = 0.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        const glm::dvec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 normal = mesh.normals[mesh.normal_of[i][k]];
            turned = std::max(turned, std::acos(glm::dot(glm::normalize(glm::cross(b - a, c - a)), normal)));
        }
    }
    CHECK(turned < 0.3);  // radians
}

TEST_CASE("threads make no difference to a mesh", "[solid]")
{
    const char* const scene = "difference { sphere { 0, 1 } torus { 0.7, 0.4 } }";
    const solid::TriangleMesh many = remeshed(scene, 0.02);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const solid::TriangleMesh alone = remeshed(scene, 0.02);
    CHECK(many.triangles == alone.triangles);
    CHECK(many.vertices == alone.vertices);
    CHECK(many.normals == alone.normals);
}

TEST_CASE("crossings are counted", "[solid]")
{
    solid::TriangleMesh mesh = octahedron();
    CHECK(solid::crossings(mesh) == 0);
    solid::TriangleMesh other = mesh;
    for (glm::vec3& v : other.vertices) mesh.vertices.push_back(v + glm::vec3(0.5f, 0.1f, 0.2f));
    for (const auto& t : other.triangles) mesh.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
    CHECK(solid::crossings(mesh) > 3);
}

TEST_CASE("crossings are those that every triangle finds with every other", "[solid]")
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f), side(-0.25f, 0.25f);
    for (const std::uint32_t count : {1u, 5u, 60u, 400u}) {
        solid::TriangleMesh mesh;
        for (std::uint32_t i = 0; i < count; ++i) {
            const glm::vec3 middle{place(random), place(random), place(random)};
            for (int k = 0; k < 3; ++k)
                mesh.vertices.push_back(middle + glm::vec3{side(random), side(random), side(random)});
            mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        CHECK(solid::crossings(mesh) == crossings_by_volumes(mesh));
        CHECK((count < 400 || solid::crossings(mesh) > 20));
    }
}

// Tetrahedra give these rims handles a few edges wide, whose triangles lie over each other and which no collapse opens.
TEST_CASE("folds that no step unfolds are cut out", "[solid]")
{
    const solid::Body body = body_of(
        "difference { union { cylinder { <0, 0, 0>, <0, 0.5, 0>, 3 } cone { <0, 0.5, 0>, 1.6, <0, 1.5, 0>, 1.2 } } "
        "cylinder { <0, -1, 0>, <0, 2, 0>, 0.8 } cylinder { <0, 1.25, 0>, <0, 2, 0>, 0.95 } "
        "#for (I, 0, 7) cylinder { <2.3, -1, 0>, <2.3, 1, 0>, 0.3 rotate 45 * I * y } #end }");
    solid::MeshFacts facts;
    const solid::TriangleMesh mesh = good_mesh(body, solid::RefineOptions{}, facts);
    REQUIRE(facts.remeshed);
    CHECK(solid::check(mesh).good());
    CHECK(solid::crossings(mesh) == 0);
    CHECK(thin_share(mesh) < 0.01);
    CHECK(mesh.triangles.size() < 15'000);  // tetrahedra alone give 120,000
}

// Corners where a tooth's side, the wheel's round wall and the flat top meet came out with triangles across them.
TEST_CASE("no triangle of a toothed wheel looks away from its surface", "[solid]")
{
    const solid::Body body =
        body_of("difference { union { cylinder { <0, -0.5, 0>, <0, 0.5, 0>, 2.3 } "
                "#for (I, 0, 15) prism { linear_spline -0.5, 0.5, 5, <2.2, -0.34>, <3, -0.16>, <3, 0.16>, <2.2, 0.34>, "
                "<2.2, -0.34> rotate 22.5 * I * y } #end cylinder { <0, -0.9, 0>, <0, 0.9, 0>, 1 } } "
                "cylinder { <0, -1, 0>, <0, 1, 0>, 0.6 } box { <-0.15, -1, 0>, <0.15, 1, 0.8> } }");
    solid::MeshFacts facts;
    const solid::TriangleMesh mesh = good_mesh(body, solid::RefineOptions{}, facts);
    REQUIRE(facts.remeshed);
    std::size_t away = 0;
    for (const auto& t : mesh.triangles) {
        const glm::dvec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
        const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
        const solid::Foot foot = solid::foot_of(body, (a + b + c) / 3.0, normal, 0.1);
        away += foot.found && glm::dot(foot.at.normal, normal) > std::cos(15.0 / 57.3) ? 0 : 1;
    }
    CHECK(away == 0);
}

TEST_CASE("julia sets are made anew, and what is late is not", "[solid]")
{
    const solid::Body body = body_of("julia_fractal { <-0.1, 0.3, 0.1, 0.1> quaternion sqr max_iteration 3 }");
    remeshed(body, 0.03);
    solid::RefineOptions options;
    options.tolerance = 0.03;
    solid::MeshFacts facts;
    options.deadline = std::chrono::steady_clock::now();
    CHECK(solid::check(good_mesh(body, options, facts)).good());
    CHECK(!facts.remeshed);
}

TEST_CASE("isosurfaces and height fields have triangles of a good shape with corners on them", "[solid]")
{
    const char* const scenes[] = {
        "intersection { isosurface { function { abs(sin(3 * x) * cos(3 * y) + sin(3 * y) * cos(3 * z) + sin(3 * z) * "
        "cos(3 * x)) "
        "- 0.45 } contained_by { box { -1.05, 1.05 } } max_gradient 6 all_intersections } sphere { 0, 1 } }",
        "intersection { height_field { function 24, 24 { 0.4 + 0.2 * sin(9 * x) * cos(7 * y) } translate <-0.5, 0, "
        "-0.5> scale <4, "
        "1.5, 4> } box { <-1.9, -0.3, -1.9>, <1.9, 3, 1.9> } }",
    };
    for (const char* scene : scenes) {
        INFO(scene);
        const solid::Body body = body_of(scene);
        const solid::TriangleMesh mesh = remeshed(body, 0.02);
        std::size_t off = 0;
        for (const glm::vec3& v : mesh.vertices) {
            double nearest = 1.0;
            for (const glm::dvec3& along : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}) {
                std::vector<solid::Chord> chords;
                body.chords(glm::dvec3(v) - 1e-4 * glm::dvec3(v), along, -0.1, 0.1, chords);
                for (const solid::Chord& chord : chords)
                    nearest = std::min({nearest, std::abs(chord.in.t), std::abs(chord.out.t)});
            }
            off += nearest < 1e-3 ? 0 : 1;
        }
        CHECK(static_cast<double>(off) < 0.02 * static_cast<double>(mesh.vertices.size()));
    }
}

TEST_CASE("a height field's triangles are about as many as its facets", "[solid]")
{
    const auto triangles = [](const char* places) {
        return remeshed(("intersection { height_field { function " + std::string(places) +
                         " { 0.4 + 0.2 * sin(9 * x) * cos(7 * y) } translate <-0.5, 0, -0.5> scale <4, 1.5, 4> } "
                         "box { <-1.9, -0.3, -1.9>, <1.9, 3, 1.9> } }")
                            .c_str(),
                        0.01)
            .triangles.size();
    };
    CHECK(triangles("12, 12") < 12'000);
    CHECK(triangles("60, 60") < 12'000);
}
