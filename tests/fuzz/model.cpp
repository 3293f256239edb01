// Files of triangles: the first byte chooses the reader.
#include "render/model/glb_reader.h"
#include "render/model/mtl_reader.h"
#include "render/model/obj_reader.h"
#include "render/model/ply_reader.h"
#include "render/model/read_model.h"
#include "render/model/stl_reader.h"
#include "render/model/three_mf_reader.h"
#include "tests/fuzz/target.h"

#include <zlib.h>

#include <cmath>

namespace {

using model::Model;

constexpr std::size_t kReaders = 8;

void put_little(std::string& out, std::size_t value, int count)
{
    for (int i = 0; i < count; ++i) out += static_cast<char>(value >> 8 * i & 255);
}

/// A 3MF file whose model is this text; nothing is packed.
std::string packed(std::string_view model)
{
    const std::string relations = "<r><Relationship Target=\"/a\" Type=\"x/3dmodel\"/></r>";
    std::string out, directory;
    for (const auto& [name, text] :
         {std::pair<std::string_view, std::string_view>{"_rels/.rels", relations}, {"a", model}}) {
        const auto sum = crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
        const std::size_t at = out.size();
        for (std::string* to : {&out, &directory}) {
            *to += to == &out ? "PK\3\4" : "PK\1\2";
            put_little(*to, 20, to == &out ? 2 : 4), put_little(*to, 0, 8), put_little(*to, sum, 4);
            put_little(*to, text.size(), 4), put_little(*to, text.size(), 4), put_little(*to, name.size(), 2);
            put_little(*to, 0, to == &out ? 2 : 8);
            if (to == &directory) put_little(*to, 0, 4), put_little(*to, at, 4);
            *to += name;
        }
        out += text;
    }
    const std::size_t begin = out.size();
    out += directory + "PK\5\6";
    put_little(out, 0, 4), put_little(out, 2, 2), put_little(out, 2, 2), put_little(out, directory.size(), 4);
    put_little(out, begin, 4), put_little(out, 0, 2);
    return out;
}

Model read(std::size_t reader, std::string_view bytes)
{
    switch (reader) {
    case 0: return model::obj_of(bytes);
    case 1: return model::stl_of(bytes);
    case 2: return model::ply_of(bytes);
    case 3: return model::glb_of(bytes);
    case 4: {  // of materials
        Model model = model::obj_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3");
        model::dress(model, bytes);
        return model;
    }
    case 6: return model::three_mf_of(bytes);
    case 7: return model::three_mf_of(packed(bytes));
    default: return model::model_of(bytes, "name.stl");
    }
}

void check(const std::array<std::uint32_t, 3>& corners, std::size_t count, bool needed)
{
    for (const std::uint32_t corner : corners)
        fuzz::require(corner < count || (corner == model::kNone && !needed), "an index of nothing");
}

/// Of two forms that differ in one thing each, as bytes in place.
fuzz::Bytes with(std::size_t reader, std::string_view text)
{
    fuzz::Bytes bytes{static_cast<std::uint8_t>(reader)};
    bytes.insert(bytes.end(), text.begin(), text.end());
    return bytes;
}

std::string binary_stl()
{
    std::string bytes(80, 'h');
    bytes += std::string("\2\0\0\0", 4);
    for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 50; ++k) bytes += static_cast<char>(k < 48 && k % 4 == 3 ? 63 + (k + i) % 2 : 0);
    return bytes;
}

std::string binary_glb()
{
    std::string json = R"({"scenes":[{"nodes":[0]}],"nodes":[{"children":[1,2],"scale":[1,2,1]},{"mesh":0},
{"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,5,1]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1},
"indices":2,"material":0,"mode":5}]}],"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
"textures":[{"source":0}],"images":[{"bufferView":1}],"bufferViews":[{"buffer":0,"byteLength":48},
{"buffer":0,"byteOffset":48,"byteLength":4,"byteStride":1}],"buffers":[{}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
{"bufferView":0,"componentType":5121,"count":4,"type":"VEC3"},
{"bufferView":1,"componentType":5121,"count":4,"type":"SCALAR"}]})",
                binary(48, '\0');
    for (std::size_t i = 4; i < 44; i += 8) binary[i + 3] = '\x3f';
    binary += std::string("\0\1\2\3", 4);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto word = [](std::size_t n) {
        std::string out;
        for (int k = 0; k < 4; ++k) out += static_cast<char>(n >> 8 * k & 255);
        return out;
    };
    return "glTF" + word(2) + word(28 + json.size() + binary.size()) + word(json.size()) + "JSON" + json +
           word(binary.size()) + std::string("BIN\0", 4) + binary;
}

std::string ply_head(const char* format)
{
    return std::string("ply\nformat ") + format +
           " 1.0\ncomment c\nelement vertex 4\nproperty float x\nproperty float y\nproperty double z\nproperty float "
           "nx\n"
           "property float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
           "element face 2\nproperty list uchar int vertex_indices\nelement tristrips 1\n"
           "property list int int vertex_indices\nend_header\n";
}

std::string binary_ply(bool big)
{
    std::string bytes = ply_head(big ? "binary_big_endian" : "binary_little_endian");
    const auto put = [&](std::initializer_list<int> value, std::size_t from = 0) {
        std::string one(value.begin(), value.end());
        one = one.substr(from);
        bytes += big ? std::string(one.rbegin(), one.rend()) : one;
    };
    for (int i = 0; i < 4; ++i) {
        put({0, 0, i % 2 == 0 ? 128 : 0, i % 2 == 0 ? 63 : 0});
        put({0, 0, i < 2 ? 128 : 0, i < 2 ? 63 : 0});
        put({0, 0, 0, 0, 0, 0, 240, 63});
        for (int k = 0; k < 3; ++k) put({0, 0, 128, 63});
        bytes += "\1\2\3";
    }
    bytes += '\4';
    for (int i : {0, 1, 3, 2}) put({i, 0, 0, 0});
    bytes += '\3';
    for (int i : {0, 1, 2}) put({i, 0, 0, 0});
    put({5, 0, 0, 0});
    for (int i : {0, 1, 2}) put({i, 0, 0, 0});
    put({255, 255, 255, 255});
    put({3, 0, 0, 0});
    return bytes;
}

}  // namespace

void fuzz::one(const Bytes& bytes)
{
    if (bytes.empty()) return;
    const std::string text = text_of(Bytes(bytes.begin() + 1, bytes.end()));
    try {
        const Model model = read(bytes[0] % kReaders, text);
        require(!model.faces.empty(), "a model without faces");
        // No more than what a byte can say, but for the nodes of GLB, which may show one mesh a few times.
        const std::size_t most = 20 + 20 * text.size();
        require(model.faces.size() < most && model.vertices.size() < most && model.normals.size() < most &&
                    model.uvs.size() < most,
                "more than the file can hold");
        for (const Model::Face& face : model.faces) {
            check(face.vertex, model.vertices.size(), true);
            check(face.normal, model.normals.size(), false);
            check(face.uv, model.uvs.size(), false);
            check(face.color, model.colors.size(), false);
            require(face.material == model::kNone || face.material < model.materials.size(), "a material of nothing");
        }
        for (const glm::dvec3& p : model.vertices)
            require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "a vertex nowhere");
    } catch (const model::ModelError& error) {
        require(error.byte == model::ModelError::kNowhere || error.byte <= text.size() + 1000,
                "an error behind the file");
    }
}

std::vector<fuzz::Bytes> fuzz::seeds()
{
    const std::string stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0.5\nvertex 0 1e1 0\n"
                            "endloop\nendfacet\nendsolid a\n";
    const std::string obj =
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nusemtl a\nf 1/1/1 2/1/1 -2/1/1 4/1/1\n"
        "f 1 2 \\\n 3\n";
    const std::string ply = ply_head("ascii") + "0 0 0 0 0 1 1 2 3\n1 0 0 0 0 1 1 2 3\n1 1 0 0 0 1 1 2 3\n"
                                                "0 1 0 0 0 1 4 5 6\n4 0 1 2 3\n3 0 1 2\n5 0 1 2 -1 3\n";
    const std::string three_mf =
        "<model unit=\"inch\"><resources><basematerials id=\"5\"><base name=\"a\" "
        "displaycolor=\"#FF0000\"/></basematerials>"
        "<m:colorgroup id=\"6\"><m:color color=\"#0000FF\"/><m:color color=\"#FFFFFF80\"/></m:colorgroup>"
        "<object id=\"1\" pid=\"5\" pindex=\"0\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" "
        "y=\"0\" "
        "z=\"0\"/><vertex x=\"0\" y=\"1e1\" z=\"0\"/></vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/>"
        "<triangle v1=\"0\" v2=\"2\" v3=\"1\" pid=\"6\" p1=\"0\" p2=\"1\" p3=\"0\"/></triangles></mesh></object>"
        "<object id=\"2\"><components><component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 "
        "5\"/></components></object>"
        "</resources><build><item objectid=\"2\"/><item objectid=\"1\"/></build></model>";
    return {with(0, obj),
            with(1, stl),
            with(1, binary_stl()),
            with(2, ply),
            with(2, binary_ply(false)),
            with(2, binary_ply(true)),
            with(3, binary_glb()),
            with(4, "newmtl a\nKd 1 0.5 0\nd 0.5\nKe 1\nmap_Kd -s 1 1 1 -clamp on a b.png\nnewmtl b # c\nTr 0.1\n"),
            with(6, packed(three_mf)),
            with(7, three_mf),
            with(5, binary_stl()),
            with(5, ply)};
}
