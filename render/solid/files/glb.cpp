#include "render/solid/files/glb.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace solid {
namespace {

// Numbers of glTF 2.0: component types and targets of views.
constexpr int kUnsignedInt = 5125, kFloat = 5126, kVertices = 34962, kIndices = 34963;

/// A string in quotes; bytes that JSON keeps for itself are escaped.
std::string quoted(const std::string& text)
{
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) < 0x20) out += fmt::format("\\u{:04x}", static_cast<int>(c));
        else out += c;
    }
    return out + '"';
}

double linear(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

glm::vec3 linear(const Rgb& c) { return {linear(c[0]), linear(c[1]), linear(c[2])}; }

/// Text between commas.
void list(std::string& all, const std::string& one) { all += all.empty() ? one : "," + one; }

/// What the binary chunk holds, and how the JSON tells of it.
class Store {
public:
    /// The accessor's number.
    /// \param more of the JSON, for positions their range
    template <class T>
    std::size_t add(const std::vector<T>& items, int component, const char* type, std::size_t each, int target,
                    const std::string& more = "")
    {
        const std::size_t bytes = items.size() * sizeof(T);
        list(views_, fmt::format("{{\"buffer\":0,\"byteOffset\":{},\"byteLength\":{},\"target\":{}}}", data_.size(),
                                 bytes, target));
        list(accessors_, fmt::format("{{\"bufferView\":{},\"componentType\":{},\"count\":{},\"type\":\"{}\"{}}}",
                                     count_, component, items.size() * each, type, more));
        data_.append(reinterpret_cast<const char*>(items.data()), bytes);
        return count_++;
    }
    const std::string& data() const { return data_; }
    const std::string& views() const { return views_; }
    const std::string& accessors() const { return accessors_; }

private:
    std::string data_, views_, accessors_;
    std::size_t count_ = 0;
};

std::string range_of(const std::vector<glm::vec3>& places)
{
    glm::vec3 low(std::numeric_limits<float>::infinity()), high = -low;
    for (const glm::vec3& p : places) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return fmt::format(",\"min\":[{:.9g},{:.9g},{:.9g}],\"max\":[{:.9g},{:.9g},{:.9g}]", low.x, low.y, low.z, high.x,
                       high.y, high.z);
}

void put_chunk(std::string& out, const char* kind, std::string data, char filler)
{
    while (data.size() % 4 != 0) data += filler;
    const auto size = static_cast<std::uint32_t>(data.size());
    out.append(reinterpret_cast<const char*>(&size), 4);
    out.append(kind, 4);
    out += data;
}

}  // namespace

std::string glb_bytes(const std::vector<FilePart>& parts)
{
    Store store;
    std::string nodes, meshes, materials, children;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const FilePart& part = parts[i];
        std::vector<std::uint32_t> vertex_of;
        TriangleMesh mesh = with_own_normals(part.mesh, vertex_of);
        for (glm::vec3& v : mesh.vertices) v.z = -v.z;
        for (glm::vec3& n : mesh.normals) n.z = -n.z;
        for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
        std::string attributes = fmt::format(
            "\"POSITION\":{}", store.add(mesh.vertices, kFloat, "VEC3", 1, kVertices, range_of(mesh.vertices)));
        if (!mesh.normals.empty())
            attributes += fmt::format(",\"NORMAL\":{}", store.add(mesh.normals, kFloat, "VEC3", 1, kVertices));
        glm::vec3 base = linear(part.color);
        if (!part.colors.empty()) {
            base = glm::vec3(1.0f);
            std::vector<glm::vec3> colors;
            for (const std::uint32_t v : vertex_of) colors.push_back(linear(part.colors[v]));
            attributes += fmt::format(",\"COLOR_0\":{}", store.add(colors, kFloat, "VEC3", 1, kVertices));
        }
        const std::size_t indices = store.add(mesh.triangles, kUnsignedInt, "SCALAR", 3, kIndices);
        const std::string name = quoted(part.name);
        list(meshes,
             fmt::format("{{\"name\":{},\"primitives\":[{{\"attributes\":{{{}}},\"indices\":{},\"material\":{}}}]}}",
                         name, attributes, indices, i));
        list(materials,
             fmt::format("{{\"name\":{},\"pbrMetallicRoughness\":{{\"baseColorFactor\":[{:.6g},{:.6g},{:.6g},1],"
                         "\"metallicFactor\":0,\"roughnessFactor\":0.5}}}}",
                         name, base.x, base.y, base.z));
        list(nodes, fmt::format("{{\"name\":{},\"mesh\":{}}}", name, i));
        list(children, fmt::format("{}", i));
    }
    list(nodes, fmt::format("{{\"name\":\"millimetres\",\"scale\":[0.001,0.001,0.001],\"children\":[{}]}}", children));
    const std::string json = fmt::format("{{\"asset\":{{\"version\":\"2.0\",\"generator\":\"Whittle\"}},\"scene\":0,"
                                         "\"scenes\":[{{\"nodes\":[{}]}}],\"nodes\":[{}],"
                                         "\"meshes\":[{}],\"materials\":[{}],\"accessors\":[{}],\"bufferViews\":[{}],"
                                         "\"buffers\":[{{\"byteLength\":{}}}]}}",
                                         parts.size(), nodes, meshes, materials, store.accessors(), store.views(),
                                         store.data().size());
    std::string body;
    put_chunk(body, "JSON", json, ' ');
    put_chunk(body, "BIN\0", store.data(), '\0');
    if (body.size() + 12 > std::numeric_limits<std::uint32_t>::max())
        throw std::runtime_error("a GLB file holds no more than 4 GiB");
    std::string out = "glTF";
    const std::uint32_t version = 2, size = static_cast<std::uint32_t>(body.size() + 12);
    out.append(reinterpret_cast<const char*>(&version), 4);
    out.append(reinterpret_cast<const char*>(&size), 4);
    return out + body;
}

}  // namespace solid
