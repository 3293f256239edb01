#include "render/model/ply_reader.h"
#include "tests/render/model/failure_of.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstring>
#include <string>

using model::Model;
using Three = std::array<std::uint32_t, 3>;

namespace {

const std::string kVertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n",
                  kFaces = "element face 1\nproperty list uchar int vertex_indices\n",
                  kSquare4 = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string ply_head_of(const std::string& elements, const char* format = "ascii")
{
    return std::string("ply\nformat ") + format + " 1.0\ncomment by hand\n" + elements + "end_header\n";
}

std::string ply_failure(const std::string& bytes)
{
    return failure_of([](const std::string& all) { return model::ply_of(all); }, bytes);
}

template <class Number>
void put(std::string& out, Number value, bool big)
{
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (big) std::reverse(raw, raw + sizeof value);
    out.append(raw, sizeof value);
}

}  // namespace

TEST_CASE("a PLY file as text becomes triangles, y up", "[model][ply]")
{
    const Model read = model::ply_of(ply_head_of(kVertices + kFaces) + kSquare4 + "4 0 1 2 3\n");
    CHECK(read.vertices == std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}});
    REQUIRE(read.faces.size() == 2);
    CHECK(read.faces[0].vertex == Three{0, 2, 1});
    CHECK(read.faces[1].vertex == Three{0, 3, 2});
    CHECK((read.faces[0].normal[0] == model::kNone && read.faces[0].color[0] == model::kNone));
}

TEST_CASE("a PLY file has normals, coordinates, colours, what else stands there is passed over", "[model][ply]")
{
    const std::string text = "element camera 1\nproperty float view\nproperty list uchar float more\n"
                             "element nothing 99999999999\n"
                             "element vertex 3\nproperty double x\nproperty float quality\nproperty float z\n"
                             "property float y\nproperty float nx\nproperty float ny\nproperty float nz\n"
                             "property uchar red\nproperty ushort green\nproperty float blue\nproperty uchar alpha\n"
                             "property float s\nproperty float t\n"
                             "element face 1\nproperty uchar flags\nproperty list uint8 uint32 vertex_index\n"
                             "property list uchar float texcoord\n";
    const Model read = model::ply_of("ply\r\nformat ascii 1.0\r\nobj_info x\r\n" + text +
                                     "end_header\r\n1 2 7 8\r\n"
                                     "1 9 3 2 0 0 1 255 65535 0.5 255 0.25 0.75\n0 9 1 2 0 1 0 0 0 0 255 0 0\n"
                                     "0 0 0 0 1 0 0 0 0 0 255 1 1\n7 3 0 1 2 6 0 0 1 0 1 1\n");
    CHECK(read.vertices[0] == glm::dvec3(1, 3, 2));
    CHECK(read.normals[0] == glm::dvec3(0, 1, 0));
    CHECK(read.uvs[0] == glm::dvec2(0.25, 0.75));
    CHECK(read.colors[0] == glm::vec3(1, 1, 0.5f));
    REQUIRE(read.faces.size() == 1);
    for (const Three& of : {read.faces[0].vertex, read.faces[0].normal, read.faces[0].uv, read.faces[0].color})
        CHECK(of == Three{0, 2, 1});
}

TEST_CASE("colours of a PLY file's faces, and strips", "[model][ply]")
{
    const Model read = model::ply_of(
        ply_head_of(kVertices + "element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\n"
                                "property uchar green\nproperty uchar blue\n") +
        kSquare4 + "3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n");
    REQUIRE(read.faces.size() == 2);
    CHECK(read.colors == std::vector<glm::vec3>{{1, 0, 0}, {0, 0, 1}});
    CHECK((read.faces[0].color == Three{0, 0, 0} && read.faces[1].color == Three{1, 1, 1}));

    const Model strips =
        model::ply_of(ply_head_of(kVertices + "element tristrips 1\nproperty list int int vertex_indices\n") +
                      kSquare4 + "9 0 1 2 3 -1 1 2 2 0\n");
    REQUIRE(strips.faces.size() == 2);
    CHECK(strips.faces[0].vertex == Three{0, 2, 1});
    CHECK(strips.faces[1].vertex == Three{2, 3, 1});
}

TEST_CASE("a binary PLY file of either byte order is what its text is", "[model][ply]")
{
    const std::string elements = kVertices + "property short red\nproperty double extra\n" + kFaces;
    const Model text = model::ply_of(ply_head_of(kVertices + kFaces) + kSquare4 + "4 0 1 2 3\n");
    for (const bool big : {false, true}) {
        std::string bytes = ply_head_of(elements, big ? "binary_big_endian" : "binary_little_endian");
        for (const auto& [x, y] : {std::pair{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}}) {
            for (const float v : {x, y, 0.0f}) put(bytes, v, big);
            put(bytes, std::int16_t(-3), big);
            put(bytes, 7.0, big);
        }
        bytes += '\4';
        for (const std::int32_t i : {0, 1, 2, 3}) put(bytes, i, big);
        const Model read = model::ply_of(bytes);
        CHECK(read.vertices == text.vertices);
        REQUIRE(read.faces.size() == 2);
        CHECK(read.faces[1].vertex == text.faces[1].vertex);
        const std::size_t head = bytes.size() - 17 - 4 * 22;
        CHECK(ply_failure(bytes.substr(0, head + 30)) ==
              "byte " + std::to_string(head + 30) + ": in vertex 2 of 4: it ends");
        bytes[bytes.size() - (big ? 1 : 4)] = 9;
        CHECK(ply_failure(bytes) ==
              "byte " + std::to_string(bytes.size() - 4) + ": face 1 has a vertex that is none of 4");
    }
}

TEST_CASE("what is wrong with a PLY file is told with its place", "[model][ply]")
{
    const std::string head = ply_head_of(kVertices + kFaces);
    CHECK(ply_failure(head + "0 0 0\n1 0 0\nx 0 0\n") == "13: in vertex 3 of 4: 'x' is no number that can stand here");
    CHECK(ply_failure(head + kSquare4 + "3 0 1 4\n") == "15: face 1 has a vertex that is none of 4");
    CHECK(ply_failure(head + kSquare4 + "3 0 1 -1\n") == "15: face 1 has a vertex that is none of 4");
    CHECK(ply_failure(head + kSquare4 + "2 0 1\n") == "15: a face has 2 corners");
    CHECK(ply_failure(head + kSquare4) == "15: in face 1 of 1: a number is missing: it ends");
    CHECK(ply_failure("ply\nformat ascii 1.0\nwhat 3\nend_header\n") == "3: 'what' is no word of a PLY header");
    CHECK(ply_failure("ply\nformat middle 1.0\nend_header\n") == "2: 'middle' is no format of PLY");
    CHECK(ply_failure("ply\nelement vertex x\nend_header\n") == "2: 'x' is no number that can stand here");
    CHECK(ply_failure("ply\nproperty float x\nend_header\n") == "2: a property before any element");
    CHECK(ply_failure("ply\nelement a 1\nproperty text x\nend_header\n") == "3: 'text' is no type of PLY");
    CHECK(ply_failure("ply\nend_header\n") == "2: its header names no format");
    CHECK(ply_failure("ply\nformat ascii 1.0\n") == "3: it ends within its header");
    CHECK(ply_failure(ply_head_of("element vertex 1\nproperty float x\n") + "1\n") ==
          "7: its vertices have no x, y and z");
    CHECK(ply_failure(ply_head_of(kFaces + kVertices)) == "11: its faces stand before its vertices");
    CHECK(ply_failure(ply_head_of(kVertices) + kSquare4) == "it has no faces");
}
