#include "render/model/three_mf_reader.h"
#include "tests/render/model/failure_of.h"

#include <catch2/catch.hpp>

#include <zlib.h>

#include <cstring>
#include <string>
#include <vector>

using model::Model;
using Three = std::array<std::uint32_t, 3>;

namespace {

void put_little(std::string& out, std::uint64_t value, int count)
{
    for (int i = 0; i < count; ++i) out += static_cast<char>(value >> 8 * i & 255);
}

std::string deflated(const std::string& text)
{
    z_stream stream{};
    REQUIRE(deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) == Z_OK);
    std::string out(text.size() + 100, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    stream.avail_in = static_cast<uInt>(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

/// The first file is stored, others are deflated; `large`: with numbers of 64 bits.
std::string zip_of(const std::vector<std::pair<std::string, std::string>>& files, bool large = false)
{
    std::string out, directory;
    for (const auto& [name, text] : files) {
        const bool stored = out.empty();
        const std::string packed = stored ? text : deflated(text);
        const auto sum = crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
        std::string extra;
        if (large) {
            put_little(extra, 1, 2), put_little(extra, 24, 2), put_little(extra, text.size(), 8);
            put_little(extra, packed.size(), 8), put_little(extra, out.size(), 8);
        }
        directory += "PK\1\2";
        put_little(directory, 45, 2), put_little(directory, 45, 2), put_little(directory, 0, 2);
        put_little(directory, stored ? 0 : 8, 2), put_little(directory, 0, 4), put_little(directory, sum, 4);
        put_little(directory, large ? 0xffffffffu : packed.size(), 4),
            put_little(directory, large ? 0xffffffffu : text.size(), 4);
        put_little(directory, name.size(), 2), put_little(directory, extra.size(), 2), put_little(directory, 0, 8),
            put_little(directory, 0, 2);
        put_little(directory, large ? 0xffffffffu : out.size(), 4);
        directory += name + extra;
        out += "PK\3\4";
        put_little(out, 45, 2), put_little(out, 0, 2), put_little(out, stored ? 0 : 8, 2), put_little(out, 0, 4);
        put_little(out, sum, 4), put_little(out, packed.size(), 4), put_little(out, text.size(), 4);
        put_little(out, name.size(), 2), put_little(out, 0, 2);
        out += name + packed;
    }
    const std::size_t begin = out.size();
    out += directory;
    if (large) {
        const std::size_t tail = out.size();
        out += "PK\6\6";
        put_little(out, 44, 8), put_little(out, 45, 4), put_little(out, 0, 8), put_little(out, files.size(), 8);
        put_little(out, files.size(), 8), put_little(out, directory.size(), 8), put_little(out, begin, 8);
        out += "PK\6\7";
        put_little(out, 0, 4), put_little(out, tail, 8), put_little(out, 1, 4);
    }
    out += "PK\5\6";
    put_little(out, 0, 4), put_little(out, large ? 0xffff : files.size(), 2),
        put_little(out, large ? 0xffff : files.size(), 2);
    put_little(out, directory.size(), 4), put_little(out, large ? 0xffffffffu : begin, 4), put_little(out, 0, 2);
    return out;
}

const std::string kRelations =
    "<Relationships><Relationship Target=\"/3D/a.model\" Id=\"r\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";

std::string package(const std::string& xml, bool large = false)
{
    return zip_of({{"_rels/.rels", kRelations}, {"3D/a.model", xml}}, large);
}

const std::string kMesh = "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x='1' y='0' z='0'/>\n"
                          "<vertex x=\"0\" y=\"2\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"3\"/></vertices>\n<triangles>",
                  kEnd = "</triangles></mesh>";

std::string model_of(const std::string& resources, const std::string& build, const std::string& unit = "millimeter")
{
    return "<?xml version=\"1.0\"?>\n<!-- > --><model unit=\"" + unit + "\"><resources>" + resources +
           "</resources><build>" + build + "</build></model>";
}

std::string three_mf_failure(const std::string& bytes)
{
    return failure_of([](const std::string& all) { return model::three_mf_of(all); }, bytes);
}

}  // namespace

TEST_CASE("a 3MF file becomes triangles in millimetres, y up", "[model][3mf]")
{
    const std::string xml = model_of("<object id=\"1\" type=\"model\">" + kMesh +
                                         "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/>" + kEnd + "</object>",
                                     "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 10 20 30\"/><item "
                                     "objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>",
                                     "inch");
    for (const bool large : {false, true}) {
        const Model read = model::three_mf_of(package(xml, large));
        REQUIRE(read.faces.size() == 2);
        CHECK(read.vertices[0] == glm::dvec3(254, 762, 508));
        CHECK(read.vertices[2] == glm::dvec3(254, 762, 22 * 25.4));
        CHECK(read.faces[0].vertex == Three{0, 1, 2});
        CHECK(read.vertices[5] == glm::dvec3(-25.4, 0, 0));
        CHECK(read.faces[1].vertex == Three{4, 6, 5});
    }
}

TEST_CASE("materials and colours of a 3MF file", "[model][3mf]")
{
    const Model read = model::three_mf_of(package(model_of(
        "<basematerials id=\"5\"><base name=\"a &lt; b\" displaycolor=\"#FF0000\"/><base name=\"b\" "
        "displaycolor=\"#00ff0080\"/>"
        "</basematerials><m:colorgroup id=\"6\"><m:color color=\"#0000FF\"/><m:color color=\"#FFFFFF\"/></m:colorgroup>"
        "<object id=\"1\" pid=\"5\" pindex=\"1\">" +
            kMesh +
            "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\" pid=\"5\" p1=\"0\"/>"
            "<triangle v1=\"0\" v2=\"3\" v3=\"2\" pid=\"6\" p1=\"0\" p2=\"1\" p3=\"0\"/>" +
            kEnd + "</object>",
        "<item objectid=\"1\"/>")));
    REQUIRE(read.materials.size() == 2);
    CHECK(
        (read.materials[0].name == "a < b" && read.materials[0].color == glm::vec3(1, 0, 0) && read.materials[0].told));
    CHECK(read.materials[1].opacity == Approx(128 / 255.0));
    CHECK(read.colors == std::vector<glm::vec3>{{0, 0, 1}, {1, 1, 1}});
    CHECK((read.faces[0].material == 1 && read.faces[1].material == 0 && read.faces[2].material == model::kNone));
    CHECK(read.faces[2].color == Three{0, 0, 1});
    CHECK_FALSE(read.linear);
}

TEST_CASE("components of a 3MF file, also in other parts", "[model][3mf]")
{
    const std::string object = "<object id=\"1\">" + kMesh + "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/>" + kEnd +
                               "</object>";
    const Model read = model::three_mf_of(
        zip_of({{"_rels/.rels", kRelations},
                {"3D/a.model",
                 model_of("<object id=\"2\"><components><component objectid=\"1\" p:path=\"/3D/b.model\" "
                          "transform=\"1 0 0 0 1 0 0 0 1 0 0 1\"/><component p:path=\"/3D/b.model\" objectid=\"1\"/>"
                          "</components></object>",
                          "<item objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 2 0 0 0\"/>")},
                {"3D/b.model", model_of(object, "")}}));
    REQUIRE(read.faces.size() == 2);
    CHECK(read.vertices[0] == glm::dvec3(0, 2, 0));
    CHECK(read.vertices[5] == glm::dvec3(2, 0, 0));
}

TEST_CASE("what is wrong with a 3MF file is told", "[model][3mf]")
{
    const auto of_object = [](const std::string& inner) {
        return package(model_of("\n<object id=\"1\">" + inner + "</object>", "<item objectid=\"1\"/>"));
    };
    const std::string good = of_object(kMesh + "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/>" + kEnd);
    CHECK(three_mf_failure(good) == "none");
    CHECK(three_mf_failure(good.substr(0, good.size() - 30)) ==
          "byte " + std::to_string(good.size() - 30) + ": its ZIP directory is missing: it may be cut off");
    std::string changed = good;
    changed[400] = static_cast<char>(changed[400] ^ 1);
    CHECK(three_mf_failure(changed) != "none");
    CHECK(three_mf_failure(zip_of({{"a", "b"}})) == "it is a ZIP file, but no 3MF file: it has no '_rels/.rels'");
    CHECK(three_mf_failure(zip_of({{"_rels/.rels", kRelations}})) == "there is no '3D/a.model' in it");
    CHECK(three_mf_failure(of_object(kMesh + "\n<triangle v1=\"0\" v2=\"4\" v3=\"1\"/>" + kEnd)) ==
          "'3D/a.model', line 6: there is no vertex 4: 4 are above");
    CHECK(three_mf_failure(of_object("<mesh><vertices><vertex x=\"0\" y=\"0\"/>")) ==
          "'3D/a.model', line 3: 'vertex' has no z");
    CHECK(three_mf_failure(of_object("<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"x\"/>")) ==
          "'3D/a.model', line 3: 'x' is no number that can stand here");
    CHECK(three_mf_failure(package("<model><build><item objectid=\"1\"/></build></model>")) ==
          "'3D/a.model': there is no object 1");
    CHECK(three_mf_failure(package("<model>")) == "'3D/a.model', line 1: it ends before </model>");
    CHECK(three_mf_failure(package("<model><a")) == "'3D/a.model', line 1: it ends within a tag");
    CHECK(three_mf_failure(package("<model unit=\"ell\"/>")) == "'3D/a.model', line 1: there is no unit 'ell'");
    CHECK(three_mf_failure(package("<model></model>")) == "its build has no triangles");
    // Each object shows the one before twice.
    std::string doubled = "<object id=\"1\">" + kMesh + kEnd + "</object>";
    for (int i = 2; i < 60; ++i)
        doubled += "<object id=\"" + std::to_string(i) + "\"><components><component objectid=\"" +
                   std::to_string(i - 1) + "\"/><component objectid=\"" + std::to_string(i - 1) +
                   "\"/></components></object>";
    CHECK(three_mf_failure(package(model_of(doubled, "<item objectid=\"59\"/>"))).find("is shown too often") !=
          std::string::npos);
    // A megabyte of nothing is packed in a kilobyte.
    CHECK(three_mf_failure(package("<model>" + std::string(4'000'000, ' ') + "</model>"))
              .find("is too long for a file of this size") != std::string::npos);
}
