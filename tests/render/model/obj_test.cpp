#include "render/model/obj_reader.h"
#include "render/model/base/polygon_triangles.h"

#include <catch2/catch.hpp>

#include <chrono>
#include <cstdio>
#include <string>

using model::Model;
using Three = std::array<std::uint32_t, 3>;

namespace {

std::string failure(const std::string& text)
{
    try {
        (void)model::obj_of(text);
    } catch (const model::ModelError& error) {
        return std::to_string(error.line) + ": " + error.what();
    }
    return "none";
}

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

double area(const std::vector<glm::dvec3>& outline, const std::vector<Three>& triangles)
{
    glm::dvec3 sum(0.0);
    double sizes = 0.0;
    for (const Three& t : triangles) {
        const glm::dvec3 one = 0.5 * glm::cross(outline[t[1]] - outline[t[0]], outline[t[2]] - outline[t[0]]);
        sum += one;
        sizes += glm::length(one);
    }
    CHECK(glm::length(sum) == Approx(sizes));  // none is turned over
    return sizes;
}

}  // namespace

TEST_CASE("an OBJ file's lines become triangles", "[model][obj]")
{
    const Model plain = model::obj_of(kSquare + "f 1 2 3\nf -4 -2 -1");
    REQUIRE(plain.faces.size() == 2);
    CHECK(plain.faces[0].vertex == Three{0, 1, 2});
    CHECK(plain.faces[1].vertex == Three{0, 2, 3});
    CHECK((plain.faces[0].normal[0] == model::kNone && plain.faces[0].uv[0] == model::kNone));

    // As exporters write it: CRLF, groups, smoothing, normals, coordinates, materials, a continued line, a byte mark.
    const Model rich =
        model::obj_of("\xef\xbb\xbf# an exporter\r\nmtllib a.mtl\r\no Cube\r\nv 0 0 0 1 0.5 0.5\r\n"
                      "v  1.5e0\t0 0\r\nv +1 1 0\r\nv 0 1 0\r\nvt 0 0\r\nvt 1\r\nvt 1 1 0\r\n"
                      "vn 0 0 -1\r\ng side a\r\ns 1\r\nusemtl dark wood\r\nf 1/1/1 2/2/1 \\\r\n 3/3/1\r\n"
                      "s off\r\nusemtl b # not c\r\nf 1//1 3//1 4//1\r\nf 1/1 2/2 4/3\r\nusemtl dark wood\r\n"
                      "f 2 3 4\r\nl 1 2\r\np 1\r\n");
    REQUIRE(rich.faces.size() == 4);
    CHECK(rich.vertices[1] == glm::dvec3(1.5, 0, 0));
    CHECK(rich.vertices[2] == glm::dvec3(1, 1, 0));
    CHECK(rich.uvs[1] == glm::dvec2(1, 0));
    REQUIRE(rich.materials.size() == 2);
    CHECK((rich.materials[0].name == "dark wood" && rich.materials[1].name == "b" && !rich.materials[0].told));
    CHECK(rich.libraries == std::vector<std::string>{"a.mtl"});
    CHECK(
        (rich.faces[0].uv == Three{0, 1, 2} && rich.faces[0].normal == Three{0, 0, 0} && rich.faces[0].material == 0));
    CHECK(
        (rich.faces[1].uv[0] == model::kNone && rich.faces[1].normal == Three{0, 0, 0} && rich.faces[1].material == 1));
    CHECK((rich.faces[2].normal[0] == model::kNone && rich.faces[2].uv == Three{0, 1, 2}));
    CHECK(rich.faces[3].material == 0);
}

TEST_CASE("polygons become triangles that cover them", "[model][obj]")
{
    CHECK(model::obj_of(kSquare + "f 1 2 3 4").faces.size() == 2);
    std::vector<Three> triangles;
    // An L, a comb, both in a tilted plane.
    std::vector<glm::dvec3> outline;
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}})
        outline.push_back(glm::dvec3(x, y, 0.0));
    model::triangulate(outline, triangles);
    CHECK(triangles.size() == 4);
    CHECK(area(outline, triangles) == Approx(3.0));
    outline.clear();
    for (int i = 0; i < 20; ++i) outline.push_back({0.5 * i, i % 2 == 0 ? 0.0 : 1.0, 0.0});
    for (int i = 19; i >= 0; --i) outline.push_back({0.5 * i, (i % 2 == 0 ? 0.0 : 1.0) + 0.2, 0.0});
    model::triangulate(outline, triangles);
    CHECK(triangles.size() == outline.size() - 2);
    CHECK(area(outline, triangles) == Approx(0.2 * 9.5));
    // One that crosses itself, one without an area: as many triangles, and an end.
    outline = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 3, 0}};
    model::triangulate(outline, triangles);
    CHECK(triangles.size() == 3);
    outline.assign(5, glm::dvec3(1.0));
    model::triangulate(outline, triangles);
    CHECK(triangles.size() == 3);
}

TEST_CASE("what is wrong with an OBJ file is told with its line", "[model][obj]")
{
    CHECK(failure(kSquare + "f 1 2") == "5: a face needs at least three corners");
    CHECK(failure(kSquare + "f 1 2 5") == "5: there is no vertex 5: 4 are above this line");
    CHECK(failure(kSquare + "\n\nf 1 2 0") == "7: there is no vertex 0: 4 are above this line");
    CHECK(failure(kSquare + "f 1 2 -5") == "5: there is no vertex -5: 4 are above this line");
    CHECK(failure(kSquare + "f 1/1 2 3") == "5: there is no texture coordinate 1: 0 are above this line");
    CHECK(failure(kSquare + "f 1 2 x3") == "5: 'x3' is no index of a vertex");
    CHECK(failure(kSquare + "f 1/2/3/4 2 3") == "5: '1/2/3/4' has more than three indices");
    CHECK(failure(kSquare + "f //1 2 3") == "5: '//1' names no vertex");
    CHECK(failure("v 0 0\n") == "1: a vertex has too few numbers");
    CHECK(failure("v 0 0 0\nv 0 \\\n x 0\nv 1 1 1") == "2: 'x' is no number");
    CHECK(failure("v nan 0 0") == "1: 'nan' is no number");
    CHECK(failure("usemtl\n") == "1: usemtl without a name");
    CHECK(failure(kSquare) == "0: it has no faces");
    CHECK(failure("") == "0: it has no faces");
    CHECK(failure(std::string("ab\0c", 4)) == "1: this is no text file");
}

TEST_CASE("a large file is read in time that goes with its length", "[model][obj]")
{
    std::string text;
    constexpr int kSide = 318;  // 2 * 317^2 triangles, a fifth of a million
    char line[96];
    for (int i = 0; i < kSide * kSide; ++i)
        text.append(line,
                    static_cast<std::size_t>(std::snprintf(line, sizeof line, "v %.6f %.6f %.6f\n", i % kSide * 0.01,
                                                           i / kSide * 0.01, (i * 37 % 101) * 0.001)));
    for (int y = 1; y < kSide; ++y)
        for (int x = 1; x < kSide; ++x) {
            const int a = (y - 1) * kSide + x, b = a + kSide;
            text.append(line, static_cast<std::size_t>(std::snprintf(line, sizeof line, "f %d %d %d\nf %d %d %d\n", a,
                                                                     a + 1, b, a + 1, b + 1, b)));
        }
    const auto from = std::chrono::steady_clock::now();
    const Model read = model::obj_of(text);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - from;
    CHECK(read.faces.size() == 2u * (kSide - 1) * (kSide - 1));
    INFO(took.count() << " s");
    CHECK(took.count() < 10.0);  // 0.2 s on an idle machine, 1.3 s under the sanitizers; tests share theirs
}
