#include "csg/mesh/mesh_query.h"
#include "csg/mesh/mesh_edges.h"
#include "csg/solids/mesh.h"
#include "tests/csg/support.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace csg;
using csg_test::Rng;

namespace {

/// A closed bumpy sphere whose corners have round coordinates, so that rays can be aimed at corners and edges exactly.
MeshInput sphere(int rings, Rng& rng)
{
    MeshInput input;
    input.solid = true;
    const int around = 2 * rings;
    const auto rounded = [](const glm::dvec3& p) { return glm::round(p * 64.0) / 64.0; };
    input.vertices.push_back({0, 1, 0});
    for (int i = 1; i < rings; ++i)
        for (int j = 0; j < around; ++j) {
            const double a = 3.14159265 * i / rings, b = 6.2831853 * j / around, r = rng.uniform(0.7, 1.3);
            input.vertices.push_back(
                rounded({r * std::sin(a) * std::cos(b), std::cos(a), r * std::sin(a) * std::sin(b)}));
        }
    input.vertices.push_back({0, -1, 0});
    const auto at = [&](int i, int j) {
        return static_cast<std::uint32_t>(i == 0       ? 0
                                          : i == rings ? 1 + (rings - 1) * around
                                                       : 1 + (i - 1) * around + j % around);
    };
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < around; ++j) {
            if (i > 0) input.faces.push_back({.vertex = {at(i, j), at(i, j + 1), at(i + 1, j)}});
            if (i + 1 < rings) input.faces.push_back({.vertex = {at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)}});
        }
    return input;
}

Mesh mesh_of(const MeshInput& input, const Transform& frame = {})
{
    Mesh mesh;
    mesh.shape = std::make_shared<MeshShape>(input);
    mesh.frame = frame;
    mesh.surfaces = {0};
    mesh.inside_vector = {0.31, 0.9, 0.17};
    return mesh;
}

std::vector<std::pair<double, std::uint32_t>> all_met(const MeshShape& shape, const Ray& ray)
{
    std::vector<std::pair<double, std::uint32_t>> met;
    mesh_crossings(shape, ray, -kInfinity, kInfinity, [&](double t, std::uint32_t face) {
        met.emplace_back(t, face);
        return kInfinity;
    });
    std::sort(met.begin(), met.end());
    return met;
}

/// Whether the spans hold what contains() says, between every two ends and beyond.
void check_spans(const Mesh& mesh, const Ray& ray, bool inverted)
{
    std::vector<Span> memory(mesh.most_spans());
    SpanList spans(memory.data(), mesh.most_spans());
    mesh.spans(ray, inverted, spans);
    std::vector<double> ends{-50.0, 50.0};
    for (const Span& span : spans)
        for (const double t : {span.in.t, span.out.t})
            if (std::abs(t) < 50.0) ends.push_back(t);
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        for (const double share : {0.02, 0.3, 0.5, 0.98}) {
            if (ends[i + 1] - ends[i] < 1e-3) continue;
            const double t = ends[i] + share * (ends[i + 1] - ends[i]);
            INFO("t " << t);
            REQUIRE(spans.contains(t) == (inverted ? mesh.contains_inverted(ray.at(t)) : mesh.contains(ray.at(t))));
        }
}

}  // namespace

TEST_CASE("a ray through corners and along edges of a closed mesh meets an even number of faces", "[csg][mesh]")
{
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const MeshInput input = sphere(5, rng);
        const MeshShape shape(input);
        REQUIRE(shape.open_edges().empty());
        for (int i = 0; i < 200; ++i) {
            const auto corner = [&] {
                return input.vertices[static_cast<std::size_t>(rng.below(static_cast<int>(input.vertices.size())))];
            };
            const glm::dvec3 a = corner(), b = corner();
            const glm::dvec3 origin = rng.coin() ? glm::dvec3(rng.below(3) + 2, rng.below(3), rng.below(3))
                                                 : corner() * 4.0;
            for (const glm::dvec3& target : {a, 0.5 * (a + b), glm::dvec3(a.x, b.y, 0)}) {
                const Ray ray{origin, target - origin};
                if (ray.direction == glm::dvec3(0.0)) continue;
                REQUIRE(all_met(shape, ray).size() % 2 == 0);
            }
            REQUIRE(all_met(shape, {corner() * 2.0, {0, 0, 1}}).size() % 2 == 0);
        }
    }
}

TEST_CASE("a mesh meets what its triangles meet one by one", "[csg][mesh]")
{
    Rng rng(7);
    const MeshInput input = sphere(12, rng);
    const MeshShape shape(input);
    for (int i = 0; i < 3000; ++i) {
        const Ray ray = csg_test::ray_near(rng, {0, 0, 0}, 1.4, 5.0);
        std::vector<double> expected;
        for (const MeshInput::Face& face : input.faces) {
            double t = 0.0;
            const auto& v = input.vertices;
            if (Triangle::make({v[face.vertex[0]], v[face.vertex[1]], v[face.vertex[2]]}).crossing(ray, t))
                expected.push_back(t);
        }
        std::sort(expected.begin(), expected.end());
        const auto met = all_met(shape, ray);
        REQUIRE(met.size() == expected.size());
        for (std::size_t k = 0; k < met.size(); ++k) REQUIRE(met[k].first == Approx(expected[k]).margin(1e-9));
    }
}

TEST_CASE("spans of a mesh hold what its inside vector says", "[csg][mesh]")
{
    for (std::uint32_t seed = 0; seed < 60; ++seed) {
        INFO("seed " << seed);
        Rng rng(seed);
        const bool torn = seed % 2 == 1;
        MeshInput input = sphere(6, rng);
        for (int i = 0; torn && i < 3; ++i)
            input.faces.erase(input.faces.begin() + rng.below(static_cast<int>(input.faces.size())));
        const Mesh mesh = mesh_of(input, csg_test::random_transform(rng));
        REQUIRE(mesh.shape->open_edges().empty() != torn);
        REQUIRE(mesh.bounds().finite() != torn);
        for (int i = 0; i < 40; ++i)
            check_spans(mesh, csg_test::ray_near(rng, mesh.frame.offset, 1.5, 6.0), rng.coin());
    }
}

TEST_CASE("a mesh without an inside vector has no inside, inverted or not", "[csg][mesh]")
{
    Rng rng(3);
    Mesh mesh = mesh_of(sphere(4, rng));
    mesh.inside_vector = glm::dvec3(0.0);
    FixedSpans<4> spans;
    mesh.spans({{0, 0, -5}, {0, 0, 1}}, true, spans);
    CHECK(spans.empty());
    CHECK_FALSE(mesh.contains({0, 0, 0}));
    CHECK_FALSE(mesh.contains_inverted({9, 0, 0}));
}

TEST_CASE("edges of a mesh: a seam within rounding is closed, a missing face is not", "[csg][mesh]")
{
    MeshInput box{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1.0 + 2e-16, -1e-16, 0}},
                  .normals = {},
                  .uvs = {},
                  .faces = {}};
    box.faces = {{.vertex = {0, 1, 2}}, {.vertex = {0, 2, 3}}, {.vertex = {0, 3, 4}}, {.vertex = {4, 2, 3}}};
    CHECK(open_edges(box).empty());
    box.faces.pop_back();
    CHECK(open_edges(box).size() == 3);
}

TEST_CASE("edges of a mesh: a face that is turned over leaves it closed and not oriented", "[csg][mesh]")
{
    const std::vector<glm::dvec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}};
    std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {1, 4, 2}, {0, 0, 1}};
    const auto oriented = [&] {
        const MeshEdges edges = edges_of(vertices, faces);
        CHECK(edges.open.empty());
        return edges.oriented;
    };
    CHECK(oriented());
    std::swap(faces[2][0], faces[2][1]);
    CHECK_FALSE(oriented());
    faces.pop_back();
    CHECK_FALSE(oriented());
    for (auto& face : faces) std::swap(face[0], face[1]);  // the others
    std::swap(faces[2][0], faces[2][1]);
    CHECK(oriented());
    CHECK(edges_of({}, {}).open.empty());
}

TEST_CASE("a closed mesh holds what the boxes of the same shape hold", "[csg][mesh]")
{
    // An angle of two boxes as a prism over six corners, its faces in the planes of the axes.
    const glm::dvec2 outline[] = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    const std::array<std::uint32_t, 3> caps[] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}};
    MeshInput angle;
    angle.solid = true;
    for (const double z : {0.0, 2.0})
        for (const glm::dvec2& p : outline) angle.vertices.push_back({p, z});
    for (const auto& [a, b, c] : caps) {
        angle.faces.push_back({.vertex = {a, c, b}});
        angle.faces.push_back({.vertex = {a + 6, b + 6, c + 6}});
    }
    for (std::uint32_t i = 0; i < 6; ++i) {
        const std::uint32_t next = (i + 1) % 6;
        angle.faces.push_back({.vertex = {i, next, next + 6}});
        angle.faces.push_back({.vertex = {i, next + 6, i + 6}});
    }
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (const MeshInput::Face& face : angle.faces) faces.push_back(face.vertex);
    const MeshEdges edges = edges_of(angle.vertices, faces);
    REQUIRE((edges.open.empty() && edges.oriented));
    Rng rng(11);
    for (int frame = 0; frame < 8; ++frame) {
        Mesh mesh = mesh_of(angle, frame == 0 ? Transform{} : csg_test::random_transform(rng));
        mesh.inside_vector = kAnyInsideVector;
        for (int i = 0; i < 4000; ++i) {
            const glm::dvec3 p(rng.uniform(-1, 4), rng.uniform(-1, 4), rng.uniform(-1, 3));
            const bool held = p.z > 0 && p.z < 2 && p.x > 0 && p.y > 0 &&
                              ((p.x < 3 && p.y < 1) || (p.x < 1 && p.y < 3));
            REQUIRE(mesh.contains(mesh.frame.point(p)) == held);
        }
        for (int i = 0; i < 200; ++i)
            check_spans(mesh, csg_test::ray_near(rng, mesh.frame.point({1, 1, 1}), 2.0, 6.0), rng.coin());
    }
}

TEST_CASE("a smooth mesh bends its normals, three equal ones leave a face flat", "[csg][mesh]")
{
    MeshInput input{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                    .normals = {{0, 0, -2}, {0, 1, -1}, {0, 1, -1}},
                    .uvs = {{0, 0}, {2, 0}, {0, 3}},
                    .faces = {}};
    input.faces = {{.vertex = {0, 1, 2}, .normal = {0, 1, 1}, .uv = {0, 1, 2}}};
    const Mesh smooth = mesh_of(input);
    CHECK(glm::length(smooth.normal({0, 0, 0}, 0) - glm::dvec3(0, 0, -1)) < 1e-7);
    CHECK(glm::length(smooth.normal({1, 0, 0}, 0) - glm::normalize(glm::dvec3(0, 1, -1))) < 1e-7);
    CHECK(glm::length(smooth.uv({0.25, 0.5, 0}, 0) - glm::dvec2(0.5, 1.5)) < 1e-12);
    CHECK(glm::length(smooth.weights({0.25, 0.5, 0}, 0) - glm::dvec3(0.25, 0.25, 0.5)) < 1e-12);
    input.faces[0].normal = {1, 1, 1};
    CHECK(mesh_of(input).normal({0, 0, 0}, 0) == glm::dvec3(0, 0, -1));
}
