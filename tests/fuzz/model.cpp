// Files of triangles: the first byte chooses the reader.
#include "render/model/obj_reader.h"
#include "render/model/ply_reader.h"
#include "render/model/read_model.h"
#include "render/model/stl_reader.h"
#include "tests/fuzz/target.h"

#include <cmath>

namespace {

using model::Model;

constexpr std::size_t kReaders = 4;

Model read(std::size_t reader, std::string_view bytes)
{
    switch (reader) {
    case 0: return model::obj_of(bytes);
    case 1: return model::stl_of(bytes);
    case 2: return model::ply_of(bytes);
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
        // No more than what a byte can say; OBJ's polygons have two bytes a corner.
        require(model.faces.size() + model.vertices.size() + model.normals.size() + model.uvs.size() <= text.size(),
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
        require(error.byte == model::ModelError::kNowhere || error.byte <= text.size(), "an error behind the file");
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
    return {with(0, obj),
            with(1, stl),
            with(1, binary_stl()),
            with(2, ply),
            with(2, binary_ply(false)),
            with(2, binary_ply(true)),
            with(3, binary_stl()),
            with(3, ply)};
}
