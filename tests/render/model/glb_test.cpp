#include "render/model/glb_reader.h"
#include "tests/render/model/failure_of.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <string>

using model::Model;
using Three = std::array<std::uint32_t, 3>;

namespace {

void put_word(std::string& out, std::uint32_t value)
{
    out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string glb_file(std::string json, std::string binary)
{
    while (json.size() % 4 != 0) json += ' ';
    while (binary.size() % 4 != 0) binary += '\0';
    std::string out = "glTF";
    put_word(out, 2);
    put_word(out, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size()));
    put_word(out, static_cast<std::uint32_t>(json.size()));
    out += "JSON" + json;
    put_word(out, static_cast<std::uint32_t>(binary.size()));
    return out + std::string("BIN\0", 4) + binary;
}

/// A square of four vertices with everything, 4 * 12 positions, 4 * 12 normals, 4 * 8 coordinates, 4 * 4 colours, 6 * 2
/// indices.
std::string square_bytes()
{
    std::string out;
    const auto put = [&](std::initializer_list<float> all) {
        for (const float one : all) out.append(reinterpret_cast<const char*>(&one), sizeof one);
    };
    put({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    put({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
    put({0, 1, 1, 1, 1, 0, 0, 0});
    for (int i = 0; i < 4; ++i) out += std::string("\xff\x33\0\xff", 4);
    for (const int one : {0, 1, 2, 0, 2, 3}) {
        const auto index = static_cast<std::uint16_t>(one);
        out.append(reinterpret_cast<const char*>(&index), sizeof index);
    }
    return out;
}

const std::string kViews = R"("buffers":[{"byteLength":156}],"bufferViews":[{"buffer":0,"byteLength":48},
{"buffer":0,"byteOffset":48,"byteLength":48},{"buffer":0,"byteOffset":96,"byteLength":32},
{"buffer":0,"byteOffset":128,"byteLength":16},{"buffer":0,"byteOffset":144,"byteLength":12}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
{"bufferView":1,"componentType":5126,"count":4,"type":"VEC3"},{"bufferView":2,"componentType":5126,"count":4,"type":"VEC2"},
{"bufferView":3,"componentType":5121,"normalized":true,"count":4,"type":"VEC4"},
{"bufferView":4,"componentType":5123,"count":6,"type":"SCALAR"}])";

std::string square_file(const std::string& nodes, const std::string& primitive, const std::string& more = "")
{
    return glb_file(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" + nodes +
                        R"(],"meshes":[{"primitives":[)" + primitive + "]}]," + more + kViews + "}",
                    square_bytes());
}

const std::string kIndexed = R"({"attributes":{"POSITION":0},"indices":4})";

std::string glb_failure(const std::string& bytes)
{
    return failure_of([](const std::string& all) { return model::glb_of(all); }, bytes);
}

}  // namespace

TEST_CASE("a GLB file becomes triangles with what its corners have, z turned round", "[model][glb]")
{
    const Model read = model::glb_of(
        square_file(R"({"mesh":0})",
                    R"({"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"COLOR_0":3},"indices":4,"material":0})",
                    R"("materials":[{"name":"red","emissiveFactor":[0,0,0.5],"alphaMode":"BLEND",
"pbrMetallicRoughness":{"baseColorFactor":[0.5,1,1,0.25]}}],)"));
    CHECK(read.linear);
    REQUIRE(read.faces.size() == 2);
    CHECK(read.vertices[2] == glm::dvec3(1, 1, 0));
    CHECK(read.normals[0] == glm::dvec3(0, 0, -1));
    CHECK(read.uvs[0] == glm::dvec2(0, 0));
    CHECK(read.colors[0].x == 0.5f);
    CHECK(read.colors[0].y == Approx(0.2));
    for (const Three& of : {read.faces[0].vertex, read.faces[0].normal, read.faces[0].uv, read.faces[0].color})
        CHECK(of == Three{0, 2, 1});
    REQUIRE(read.materials.size() == 1);
    const Model::Material& material = read.materials[0];
    CHECK((material.name == "red" && material.told && material.opacity == 0.25f && !material.opaque));
    CHECK((material.color == glm::vec3(0.5f, 1, 1) && material.emission == glm::vec3(0, 0, 0.5f)));
    CHECK(read.faces[1].material == 0);
}

TEST_CASE("nodes of a GLB file put their meshes where they say", "[model][glb]")
{
    // A quarter turn about y, twice as large, moved; below it a mirror, which keeps the outside out.
    const Model read = model::glb_of(square_file(
        R"({"children":[1,2],"translation":[10,0,0],"rotation":[0,0.7071067811865476,0,0.7071067811865476],"scale":[2,2,2]},
{"mesh":0},{"mesh":0,"matrix":[-1,0,0,0,0,1,0,0,0,0,1,0,0,0,5,1]})",
        R"({"attributes":{"POSITION":0,"NORMAL":1},"indices":4})"));
    REQUIRE(read.faces.size() == 4);
    const auto near = [](const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a - b) < 1e-12; };
    CHECK(near(read.vertices[1], {10, 0, 2}));
    CHECK(near(glm::normalize(read.normals[1]), {1, 0, 0}));
    CHECK(near(read.vertices[5], {20, 0, -2}));
    CHECK(near(glm::normalize(read.normals[5]), {1, 0, 0}));
    CHECK(read.faces[0].vertex == Three{0, 2, 1});
    CHECK(read.faces[2].vertex == Three{4, 5, 6});
}

TEST_CASE("strips, fans and lists without indices of a GLB file", "[model][glb]")
{
    const auto faces = [](const std::string& primitive) {
        return model::glb_of(square_file(R"({"mesh":0})", primitive)).faces;
    };
    CHECK(faces(R"({"attributes":{"POSITION":0}})").size() == 1);
    const auto strip = faces(R"({"attributes":{"POSITION":0},"mode":5})");
    REQUIRE(strip.size() == 2);
    CHECK(strip[1].vertex == Three{2, 3, 1});
    const auto fan = faces(R"({"attributes":{"POSITION":0},"mode":6})");
    REQUIRE(fan.size() == 2);
    CHECK(fan[1].vertex == Three{0, 3, 2});
    CHECK(glb_failure(square_file(R"({"mesh":0})", R"({"attributes":{"POSITION":0},"mode":1})")) ==
          "it has no triangles");
}

TEST_CASE("pictures of a GLB file's materials", "[model][glb]")
{
    const Model read = model::glb_of(
        square_file(R"({"mesh":0})", R"({"attributes":{"POSITION":0,"TEXCOORD_0":2,"COLOR_0":3},"material":0})",
                    R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}},
{"pbrMetallicRoughness":{"baseColorTexture":{"index":1}}}],"textures":[{"source":0},{"source":1}],
"images":[{"bufferView":3,"mimeType":"image/png"},{"uri":"a%20b.png"}],)"));
    REQUIRE(read.pictures.size() == 1);
    CHECK(read.pictures[0].size() == 16);
    CHECK((read.materials[0].picture == 0 && read.materials[0].opaque && read.materials[0].name == "material 0"));
    CHECK(read.materials[1].picture_path == "a b.png");
    CHECK(read.colors.empty());  // the picture stays alone
}

TEST_CASE("what is wrong with a GLB file is told", "[model][glb]")
{
    const std::string whole = square_file(R"({"mesh":0})", kIndexed);
    CHECK(glb_failure(whole) == "none");
    CHECK(glb_failure("glTF") == "byte 4: it ends within its head");
    CHECK(glb_failure(whole.substr(0, whole.size() - 9)) == "byte " + std::to_string(whole.size() - 9) +
                                                                ": it ends before the " + std::to_string(whole.size()) +
                                                                " bytes that it says it has");
    std::string first = whole;
    first[4] = 1;
    CHECK(glb_failure(first) == "byte 4: it is glTF of version 1, not 2");
    CHECK(glb_failure(glb_file("{\"a\":}", "")) == "byte 25: its JSON is broken");
    CHECK(glb_failure(glb_file("[]", "")) == "byte 20: its JSON is no object");
    CHECK(glb_failure(glb_file("{}", "")) == "it has no triangles");
    CHECK(glb_failure(square_file(R"({"mesh":3})", kIndexed)) == "mesh 3: there is no element 3 of meshes: they are 1");
    CHECK(glb_failure(square_file(R"({"mesh":0,"children":[0]})", kIndexed)) == "node 0: it stands at two places");
    CHECK(glb_failure(square_file(R"({"mesh":-1})", kIndexed)) == "node 0: its mesh is no whole number");
    CHECK(glb_failure(square_file(R"({"mesh":0,"scale":[1,2]})", kIndexed)) ==
          "node 0: its scale is no list of 3 numbers");
    CHECK(glb_failure(square_file(R"({"mesh":0})", R"({"attributes":{"POSITION":2}})")) ==
          "accessor 2: it has 2 numbers a row, 3 are needed");
    CHECK(glb_failure(square_file(R"({"mesh":0})", R"({"attributes":{"POSITION":0},"indices":0})")) ==
          "accessor 0: indices are whole numbers of 0 or more");
    CHECK(glb_failure(
              square_file(R"({"mesh":0})", kIndexed, R"("extensionsRequired":["KHR_draco_mesh_compression"],)")) ==
          "it needs the extension 'KHR_draco_mesh_compression', which is not read");
    std::string many = whole;
    many.replace(many.find("\"count\":6"), 9, "\"count\":7");
    CHECK(glb_failure(many) == "accessor 4: its 7 rows end behind its bufferView");
    std::string beyond = whole;
    beyond[beyond.size() - 2] = 4;
    CHECK(glb_failure(beyond) == "mesh 0: there is no vertex 4: they are 4");
}
