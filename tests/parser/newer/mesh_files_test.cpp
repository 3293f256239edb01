#include "tests/parser/grammar_support.h"

#include <catch2/catch.hpp>

#include <cstdio>
#include <fstream>

// mesh { file "..." }: what is read, which of it is a solid, and where the word is a name.
namespace {

using grammar_test::error_of;
using grammar_test::parsed;

/// A file in the current folder that goes with the test.
struct MeshFile {
    MeshFile(const char* named, const std::string& bytes) : name(named) { std::ofstream(name) << bytes; }
    ~MeshFile() { std::remove(name); }
    const char* name;
};

std::string stl_facet(const char* a, const char* b, const char* c)
{
    std::string out = "facet normal 0 0 0\nouter loop\n";
    for (const char* corner : {a, b, c}) out += std::string("vertex ") + corner + "\n";
    return out + "endloop\nendfacet\n";
}

const std::string kOpenStl = "solid\n" + stl_facet("0 0 0", "0 1 0", "1 0 0") + stl_facet("0 0 0", "1 0 0", "0 0 1") +
                             stl_facet("0 0 0", "0 0 1", "0 1 0");

std::shared_ptr<const scene::MeshData> mesh_data_of(const std::string& text)
{
    return std::get<scene::Mesh>(parsed(text).objects.front().shape).data;
}

const std::string kOf37 = "#version 3.7;\n";

}  // namespace

TEST_CASE("a mesh takes its triangles from an STL file", "[parser][mesh]")
{
    const MeshFile file("mesh_files_test.stl", kOpenStl + stl_facet("1 0 0", "0 1 0", "0 0 1") + "endsolid\n");
    const std::string mesh = "mesh { file \"mesh_files_test.stl\" ";
    const auto closed = mesh_data_of(kOf37 + mesh + "pigment { rgb 1 } }");
    CHECK((closed->faces.size() == 4 && closed->vertices.size() == 4 && closed->has_inside_vector));
    // A vector that is written counts; triangles beside the file's are part of the mesh.
    CHECK(mesh_data_of(kOf37 + mesh + "inside_vector z }")->inside_vector == glm::dvec3(0, 0, 1));
    CHECK_FALSE(mesh_data_of(kOf37 + mesh + "triangle { 0, x, y } }")->has_inside_vector);
    CHECK(mesh_data_of(kOf37 + mesh + "file \"mesh_files_test.stl\" }")->faces.size() == 8);
    // In CSG without a warning; names that are declared go on to be names.
    const auto warnings = [](const std::string& text) {
        return parser::parse_text("#version 3.7;\nglobal_settings { assumed_gamma 1 }\n" + text, "test.pov", {})
            .messages;
    };
    CHECK(warnings("difference { " + mesh + "} sphere { 0, 0.5 } }").empty());
}

TEST_CASE("a mesh of a file that is open or turned over is no solid", "[parser][mesh]")
{
    {
        const MeshFile file("mesh_files_test.stl", kOpenStl + "endsolid\n");
        CHECK_FALSE(mesh_data_of("mesh { file \"mesh_files_test.stl\" }")->has_inside_vector);
        const auto messages = parser::parse_text("#version 3.7;\nglobal_settings { assumed_gamma 1 }\n"
                                                 "difference { mesh { file \"mesh_files_test.stl\" } sphere { 0, 1 } }",
                                                 "test.pov", {})
                                  .messages;
        REQUIRE(messages.size() == 1);
        CHECK(messages[0].text == "what has no inside cannot be cut or cut with; 3 of this mesh's edges have no second "
                                  "face, as that from <0, 0, 1> to <1, 0, 0>");
    }
    const MeshFile file("mesh_files_test.stl", kOpenStl + stl_facet("0 1 0", "1 0 0", "0 0 1") + "endsolid\n");
    CHECK_FALSE(mesh_data_of("mesh { file \"mesh_files_test.stl\" }")->has_inside_vector);
}

TEST_CASE("a closed mesh of an OBJ file is a solid too", "[parser][mesh]")
{
    const MeshFile file("mesh_files_test.obj",
                        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    for (const char* word : {"obj", "file"})
        CHECK(mesh_data_of(std::string("mesh { ") + word + " \"mesh_files_test.obj\" }")->has_inside_vector);
}

TEST_CASE("what a mesh file says of looks is textures", "[parser][mesh]")
{
    const MeshFile library("mesh_files_test.mtl", "newmtl a\nKd 1 0.5 0\nd 0.25\nKe 0 0 1\nnewmtl b\nKd 0 0 0\n");
    const MeshFile file("mesh_files_test.obj",
                        "mtllib mesh_files_test.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"
                        "usemtl b\nf 1 3 2\nusemtl c\nf 2 1 3\n");
    const std::string head = "global_settings { assumed_gamma 1 }\n", start = "mesh { file \"mesh_files_test.obj\" ";
    const auto mesh = mesh_data_of(head + start + "}");
    REQUIRE(mesh->textures.size() == 2);
    CHECK((mesh->faces[0].texture[2] == 0 && mesh->faces[1].texture[0] == 1));
    CHECK(mesh->faces[2].texture[0] == scene::MeshData::kNone);
    const scene::Layer& layer = std::get<std::vector<scene::Layer>>(mesh->textures[0]->kind).front();
    const auto color = std::get<scene::Color>(layer.pigment.kind);
    CHECK((color.red == 1.0f && color.green == Approx(0.21404).epsilon(1e-4) && color.transmit == 0.75f));
    CHECK(layer.finish->emission == glm::vec3(0, 0, 1));
    // Nothing of it where the statement says so, and of `obj`; else by name.
    CHECK(mesh_data_of(start + "texture_list { } }")->textures.empty());
    CHECK(mesh_data_of("mesh { obj \"mesh_files_test.obj\" }")->textures.empty());
    const auto named =
        mesh_data_of("#declare T_a = texture { pigment { rgb 1 } }\n" + start + "texture_list { prefix \"T_\" } }");
    CHECK((named->textures.size() == 1 && named->faces[0].texture[0] == 0));
}

TEST_CASE("colours of a mesh file's corners are the mesh's texture", "[parser][mesh]")
{
    const std::string
        head = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
               "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 2\n"
               "property list uchar int vertex_indices\nend_header\n",
        faces = "3 0 1 2\n3 0 2 3\n";
    const auto object_of = [](const std::string& more) {
        return parsed("global_settings { assumed_gamma 1 }\nmesh { file \"mesh_files_test.ply\" " + more + "}")
            .objects.front();
    };
    {
        const MeshFile file("mesh_files_test.ply",
                            head + "0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n0 1 0 9 9 9\n" + faces);
        const scene::Object object = object_of("finish { diffuse 0.9 }");
        const auto& mesh = *std::get<scene::Mesh>(object.shape).data;
        CHECK((mesh.textures.empty() && mesh.uvs.size() == 6 && mesh.faces[1].uv[2] == 5));
        const scene::Layer& layer = std::get<std::vector<scene::Layer>>(object.texture->kind).front();
        CHECK(layer.finish->diffuse == 0.9f);
        CHECK(std::get<scene::Shared<scene::PatternedPigment>>(layer.pigment.kind)->pattern.name == "uv_mapping");
    }
    {
        const MeshFile one("mesh_files_test.ply",
                           head + "0 0 0 255 0 0\n1 0 0 255 0 0\n1 1 0 255 0 0\n0 1 0 255 0 0\n" + faces);
        const scene::Object object = object_of("");
        CHECK(std::get<scene::Mesh>(object.shape).data->uvs.empty());
        const scene::Layer& layer = std::get<std::vector<scene::Layer>>(object.texture->kind).front();
        CHECK(std::get<scene::Color>(layer.pigment.kind) == scene::Color{1, 0, 0, 0, 0});
    }
}

TEST_CASE("'file' is a name where a scene declares it", "[parser][mesh]")
{
    const MeshFile file("mesh_files_test.stl", kOpenStl + "endsolid\n");
    CHECK(parsed(kOf37 + "#declare file = 2; sphere { 0, file } #undef file mesh { file \"mesh_files_test.stl\" }")
              .objects.size() == 2);
    CHECK(
        parsed(kOf37 + "#macro Ball(file) sphere { 0, file } #end Ball(2) #local file = <1, 2, 3>; sphere { file, 1 }")
            .objects.size() == 2);
    CHECK(parsed(kOf37 + "#ifdef (file) sphere { 0, 1 } #else box { 0, 1 } sphere { 0, 1 } #end").objects.size() == 2);
    CHECK_FALSE(error_of(kOf37 + "#declare file = 2; mesh { file \"mesh_files_test.stl\" }").empty());
}

TEST_CASE("what is wrong with a mesh file is told with its place", "[parser][mesh]")
{
    const MeshFile text("mesh_files_test.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 z\n");
    CHECK(error_of(kOf37 + "mesh { file \"mesh_files_test.stl\" }")
              .find("mesh_files_test.stl:4: 'z' is no number that can stand here") != std::string::npos);
    const MeshFile bytes("mesh_files_test.stl", std::string(100, '\1'));
    CHECK(error_of(kOf37 + "mesh { file \"mesh_files_test.stl\" }")
              .find("mesh_files_test.stl: byte 100: it ends within triangle 1 of 16843009") != std::string::npos);
    CHECK(error_of("mesh { file \"nothing.stl\" }").find("cannot find the mesh file 'nothing.stl'") !=
          std::string::npos);
}
