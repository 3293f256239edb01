#include "render/model/read_model.h"
#include "render/model/stl_reader.h"
#include "tests/render/model/failure_of.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

using model::Model;
using Three = std::array<std::uint32_t, 3>;

namespace {

struct StlTriangle {
    glm::vec3 corner[3];
};

std::string binary_of(const std::vector<StlTriangle>& triangles, const std::string& head = "solid, as some begin")
{
    std::string out = head;
    out.resize(80, ' ');
    const auto put = [&](const void* from, std::size_t count) { out.append(static_cast<const char*>(from), count); };
    const auto count = static_cast<std::uint32_t>(triangles.size());
    put(&count, sizeof count);
    for (const StlTriangle& one : triangles) {
        const glm::vec3 normal(0.0f);
        put(&normal, sizeof normal);
        put(one.corner, sizeof one.corner);
        out.append(2, '\0');
    }
    return out;
}

const std::vector<StlTriangle> kTetrahedron = {{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}},
                                               {{{0, 0, 0}, {1, 0, 0}, {0, 0, 2}}},
                                               {{{0, 0, 0}, {0, 0, 2}, {0, 1, 0}}},
                                               {{{1, 0, 0}, {0, 1, 0}, {-0.0f, 0, 2}}}};

std::string stl_failure(const std::string& bytes)
{
    return failure_of([](const std::string& all) { return model::stl_of(all); }, bytes);
}

}  // namespace

TEST_CASE("binary STL becomes triangles with common vertices, y up", "[model][stl]")
{
    const Model read = model::stl_of(binary_of(kTetrahedron));
    CHECK(read.vertices == std::vector<glm::dvec3>{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 2, 0}});
    REQUIRE(read.faces.size() == 4);
    CHECK(read.faces[0].vertex == Three{0, 2, 1});
    CHECK(read.faces[3].vertex == Three{2, 3, 1});
    CHECK((read.faces[0].normal[0] == model::kNone && read.faces[0].uv[0] == model::kNone));
}

TEST_CASE("STL as text is what it is as bytes", "[model][stl]")
{
    // A file of several solids; what stands on the line of `facet` is passed over where it is the normal alone.
    const Model read = model::stl_of("solid a name with words\n"
                                     "facet normal 0 0 -1\n outer loop\n  vertex 0 0 0\n  vertex 0 1 0\n"
                                     "  vertex 1 0 0\n endloop\nendfacet\nendsolid a name\n\nsolid\n"
                                     "  FACET NORMAL nan nan nan\r\nOUTER LOOP\r\nVERTEX 0 0 0\r\nVERTEX +1.0e0 0 0\r\n"
                                     "VERTEX 0 0 2\r\nENDLOOP\r\nENDFACET\r\n"
                                     "facet normal -1 0 0\nouter loop vertex 0 0 0 vertex 0 0 2 vertex 0 1 0 endloop "
                                     "endfacet\nfacet normal 1 1 1\nouter loop\nvertex 1 0 0\nvertex 0 1 0\n"
                                     "vertex -0 1e-60 2\nendloop\nendfacet\nendsolid");
    const Model bytes = model::stl_of(binary_of(kTetrahedron));
    CHECK(read.vertices == bytes.vertices);
    REQUIRE(read.faces.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) CHECK(read.faces[i].vertex == bytes.faces[i].vertex);
}

TEST_CASE("what is wrong with an STL file is told with its place", "[model][stl]")
{
    const std::string whole = binary_of(kTetrahedron, "a head");
    CHECK(stl_failure(whole.substr(0, 83)) ==
          "byte 83: it ends before its number of triangles, which stands at byte 80");
    CHECK(stl_failure(whole.substr(0, 84 + 70)) == "byte 154: it ends within triangle 2 of 4");
    CHECK(stl_failure(whole + "x") == "byte 284: something stands behind the last of its 4 triangles");
    CHECK(stl_failure(binary_of({})) == "it has no triangles");
    std::vector<StlTriangle> broken = kTetrahedron;
    broken[1].corner[2].y = std::numeric_limits<float>::quiet_NaN();
    CHECK(stl_failure(binary_of(broken)) == "byte 174: a coordinate of triangle 2 is no number");
    CHECK(stl_failure("") == "byte 0: it ends before its number of triangles, which stands at byte 80");

    CHECK(stl_failure("solid\nendsolid\n") == "it has no triangles");
    CHECK(stl_failure("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n") ==
          "5: expected 'vertex', found the end");
    CHECK(stl_failure("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 x\n") ==
          "5: 'x' is no number that can stand here");
    CHECK(stl_failure("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 inf\n") ==
          "4: 'inf' is no number that can stand here");
    CHECK(stl_failure("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1e99\n") ==
          "4: '1e99' is no number that can stand here");
    CHECK(stl_failure(
              "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\n") ==
          "7: expected 'endloop', found 'vertex'");
    CHECK(stl_failure(
              "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet") ==
          "8: it ends without 'endsolid'");
    CHECK(stl_failure("solid\nwhat\n") == "2: expected 'facet' or 'endsolid', found 'what'");
}

TEST_CASE("the kind of a file is told by its bytes, then by its name", "[model][stl]")
{
    const std::string bytes = binary_of(kTetrahedron), text = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                                                              "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid";
    CHECK(model::model_of(bytes, "a.obj").faces.size() == 4);
    CHECK(model::model_of(text, "a").faces.size() == 1);
    CHECK(model::model_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", "a.OBJ").faces.size() == 1);
    CHECK_THROWS_WITH(model::model_of(bytes.substr(0, 100), "a.Stl"), "it ends within triangle 1 of 4");
    CHECK_THROWS_AS(model::model_of("what is this", "a.txt"), model::ModelError);
}

TEST_CASE("a large STL file is read in time that goes with its length", "[model][stl]")
{
    constexpr int kSide = 318;  // 2 * 317^2 triangles, a fifth of a million
    std::vector<StlTriangle> triangles;
    const auto at = [](int x, int y) {
        return glm::vec3(static_cast<float>(x) * 0.01f, static_cast<float>(y) * 0.01f,
                         static_cast<float>((x * 37 + y * 11) % 101) * 0.001f);
    };
    for (int y = 1; y < kSide; ++y)
        for (int x = 1; x < kSide; ++x) {
            triangles.push_back({{at(x - 1, y - 1), at(x, y - 1), at(x, y)}});
            triangles.push_back({{at(x - 1, y - 1), at(x, y), at(x - 1, y)}});
        }
    const std::string bytes = binary_of(triangles);
    const auto from = std::chrono::steady_clock::now();
    const Model read = model::stl_of(bytes);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - from;
    CHECK(read.faces.size() == triangles.size());
    CHECK(read.vertices.size() == kSide * kSide);
    INFO(took.count() << " s");
    CHECK(took.count() < 5.0);  // 0.02 s on an idle machine; under the sanitizers tests share theirs
}
