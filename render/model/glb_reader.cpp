#include "render/model/glb_reader.h"

#include "render/model/gltf_buffers.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>

namespace model {
namespace {

constexpr std::size_t kGlbHead = 12, kGlbChunkHead = 8;

std::uint32_t word_at(std::string_view bytes, std::size_t at)
{
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

/// The two chunks of a file.
struct Chunks {
    std::string_view json, binary;
    explicit Chunks(std::string_view bytes)
    {
        if (bytes.size() < kGlbHead + kGlbChunkHead) throw ModelError::at_byte("it ends within its head", bytes.size());
        if (word_at(bytes, 4) != 2)
            throw ModelError::at_byte("it is glTF of version " + std::to_string(word_at(bytes, 4)) + ", not 2", 4);
        if (word_at(bytes, 8) > bytes.size())
            throw ModelError::at_byte(
                "it ends before the " + std::to_string(word_at(bytes, 8)) + " bytes that it says it has", bytes.size());
        std::size_t at = kGlbHead;
        json = chunk(bytes, at, "JSON");
        if (bytes.size() - at >= kGlbChunkHead) binary = chunk(bytes, at, std::string_view("BIN\0", 4));
    }

private:
    static std::string_view chunk(std::string_view bytes, std::size_t& at, std::string_view kind)
    {
        const std::size_t length = word_at(bytes, at), begin = at + kGlbChunkHead;
        if (bytes.substr(at + 4, 4) != kind)
            throw ModelError::at_byte("no chunk " + std::string(kind.data()).substr(0, 4) + " stands here", at);
        if (length > bytes.size() - begin)
            throw ModelError::at_byte("it ends within a chunk of " + std::to_string(length) + " bytes", bytes.size());
        at = begin + length;
        return bytes.substr(begin, length);
    }
};

/// `count` numbers of a list; nothing: it is not there.
template <std::size_t count>
std::optional<std::array<double, count>> numbers(const GltfJson& of, const char* name, const std::string& where)
{
    const auto found = of.find(name);
    if (found == of.end()) return std::nullopt;
    std::array<double, count> out{};
    bool good = found->is_array() && found->size() == count;
    for (std::size_t i = 0; good && i < count; ++i) {
        good = (*found)[i].is_number();
        if (good) out[i] = (*found)[i].template get<double>();
        good = good && std::abs(out[i]) < 1e30;
    }
    if (!good) fail_gltf(where, std::string("its ") + name + " is no list of " + std::to_string(count) + " numbers");
    return out;
}

std::string text_of(const GltfJson& of, const char* name)
{
    const auto found = of.find(name);
    return found != of.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// %20 is a blank.
std::string without_escapes(const std::string& uri)
{
    std::string out;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned char code = 0;
        const bool escape = uri[i] == '%' && i + 2 < uri.size() &&
                            std::from_chars(&uri[i + 1], &uri[i + 1] + 2, code, 16).ptr == &uri[i + 1] + 2;
        out += escape ? static_cast<char>(code) : uri[i];
        if (escape) i += 2;
    }
    return out;
}

class Glb {
public:
    explicit Glb(std::string_view bytes) : chunks_(bytes), most_faces_(16 * bytes.size())
    {
        try {
            file_ = GltfJson::parse(chunks_.json);
        } catch (const GltfJson::parse_error& error) {
            const std::size_t read = std::min(error.byte, chunks_.json.size());
            throw ModelError::at_byte("its JSON is broken", kGlbHead + kGlbChunkHead + read - (read > 0 ? 1 : 0));
        } catch (const GltfJson::exception&) {  // as a number that is too large
            throw ModelError::at_byte("its JSON cannot be read", kGlbHead + kGlbChunkHead);
        }
        if (!file_.is_object()) throw ModelError::at_byte("its JSON is no object", kGlbHead + kGlbChunkHead);
    }

    Model read()
    {
        check_extensions();
        model_.linear = true;
        read_materials();
        const std::size_t nodes = list("nodes").size();
        shown_.assign(nodes, false);
        for (const std::size_t root : roots(nodes)) show(root, glm::dmat4(1.0));
        if (model_.faces.empty()) throw ModelError("it has no triangles", 0);
        return std::move(model_);
    }

private:
    const GltfJson& list(const char* name) const
    {
        static const GltfJson kNothing = GltfJson::array();
        const auto found = file_.find(name);
        return found != file_.end() && found->is_array() ? *found : kNothing;
    }

    void check_extensions() const
    {
        for (const GltfJson& one : list("extensionsRequired")) {
            const std::string name = one.is_string() ? one.get<std::string>() : std::string();
            if (name.starts_with("KHR_materials_") || name == "KHR_mesh_quantization" ||
                name == "KHR_texture_transform")
                continue;
            throw ModelError("it needs the extension '" + name + "', which is not read", 0);
        }
    }

    static std::vector<std::size_t> indices(const GltfJson& of, const char* name, const std::string& where)
    {
        std::vector<std::size_t> out;
        const auto found = of.find(name);
        if (found == of.end()) return out;
        if (!found->is_array()) fail_gltf(where, std::string("its ") + name + " are no list");
        for (const GltfJson& one : *found) {
            if (!one.is_number_unsigned()) fail_gltf(where, std::string("one of its ") + name + " is no whole number");
            out.push_back(one.get<std::size_t>());
        }
        return out;
    }

    /// Of the scene that is to be shown; without scenes the nodes that are no children.
    std::vector<std::size_t> roots(std::size_t nodes) const
    {
        if (!list("scenes").empty()) {
            const std::size_t scene = gltf_count(file_, "scene", 0, "the file");
            return indices(gltf_item(file_, "scenes", scene, "the file"), "nodes", "scene " + std::to_string(scene));
        }
        std::vector<bool> child(nodes, false);
        for (std::size_t i = 0; i < nodes; ++i) {
            const std::string where = "node " + std::to_string(i);
            for (const std::size_t one : indices(gltf_item(file_, "nodes", i, where), "children", where))
                if (one < nodes) child[one] = true;
        }
        std::vector<std::size_t> out;
        for (std::size_t i = 0; i < nodes; ++i)
            if (!child[i]) out.push_back(i);
        return out;
    }

    static glm::dmat4 transform_of(const GltfJson& node, const std::string& where)
    {
        if (const auto matrix = numbers<16>(node, "matrix", where)) {
            glm::dmat4 out;
            for (int i = 0; i < 16; ++i) out[i / 4][i % 4] = (*matrix)[static_cast<std::size_t>(i)];
            return out;
        }
        const auto move = numbers<3>(node, "translation", where).value_or(std::array{0.0, 0.0, 0.0});
        const auto turn = numbers<4>(node, "rotation", where).value_or(std::array{0.0, 0.0, 0.0, 1.0});
        const auto scale = numbers<3>(node, "scale", where).value_or(std::array{1.0, 1.0, 1.0});
        glm::dmat4 out = glm::mat4_cast(glm::dquat(turn[3], turn[0], turn[1], turn[2]));
        for (int k = 0; k < 3; ++k) out[k] *= scale[static_cast<std::size_t>(k)];
        out[3] = glm::dvec4(move[0], move[1], move[2], 1.0);
        return out;
    }

    /// A node and those below it, one after the other: files nest them as deep as they like.
    void show(std::size_t root, const glm::dmat4& to_scene)
    {
        std::vector<std::pair<std::size_t, glm::dmat4>> waiting{{root, to_scene}};
        while (!waiting.empty()) {
            const auto [index, above] = waiting.back();
            waiting.pop_back();
            const std::string where = "node " + std::to_string(index);
            const GltfJson& node = gltf_item(file_, "nodes", index, where);
            if (shown_[index]) fail_gltf(where, "it stands at two places");
            shown_[index] = true;
            const glm::dmat4 here = above * transform_of(node, where);
            if (node.contains("mesh")) show_mesh(gltf_count(node, "mesh", 0, where), here);
            const std::vector<std::size_t> children = indices(node, "children", where);
            for (auto child = children.rbegin(); child != children.rend(); ++child) waiting.emplace_back(*child, here);
        }
    }

    void show_mesh(std::size_t index, const glm::dmat4& to_scene)
    {
        const std::string where = "mesh " + std::to_string(index);
        const GltfJson& mesh = gltf_item(file_, "meshes", index, where);
        const auto primitives = mesh.find("primitives");
        if (primitives == mesh.end() || !primitives->is_array()) fail_gltf(where, "it has no primitives");
        for (const GltfJson& primitive : *primitives) {
            if (!primitive.is_object()) fail_gltf(where, "one of its primitives is no object");
            show_primitive(primitive, where, to_scene);
        }
    }

    std::optional<GltfRows> attribute(const GltfJson& primitive, const char* name, std::size_t width,
                                      const std::string& where) const
    {
        const auto all = primitive.find("attributes");
        if (all == primitive.end() || !all->is_object()) fail_gltf(where, "a primitive has no attributes");
        if (!all->contains(name)) return std::nullopt;
        return GltfRows(file_, chunks_.binary, gltf_count(*all, name, 0, where), width);
    }

    void show_primitive(const GltfJson& primitive, const std::string& where, const glm::dmat4& to_scene)
    {
        enum Mode : std::size_t { kTriangles = 4, kStrip, kFan };
        const std::size_t mode = gltf_count(primitive, "mode", kTriangles, where);
        if (mode < kTriangles) return;  // points and lines
        if (mode > kFan) fail_gltf(where, "there is no mode " + std::to_string(mode));
        const auto positions = attribute(primitive, "POSITION", 3, where);
        if (!positions) return;
        const auto normals = attribute(primitive, "NORMAL", 3, where),
                   uvs = attribute(primitive, "TEXCOORD_0", 2, where),
                   colors = attribute(primitive, "COLOR_0", 3, where);
        for (const auto& other : {normals, uvs, colors})
            if (other && other->count() < positions->count())
                fail_gltf(where, "an attribute has fewer rows than POSITION");
        std::uint32_t material = kNone;
        if (primitive.contains("material")) {
            const std::size_t given = gltf_count(primitive, "material", 0, where);
            gltf_item(file_, "materials", given, where);
            material = static_cast<std::uint32_t>(given);
        }
        std::optional<GltfRows> indices;
        if (primitive.contains("indices"))
            indices.emplace(file_, chunks_.binary, gltf_count(primitive, "indices", 0, where), 1);
        const std::size_t count = indices ? indices->count() : positions->count();
        if (model_.faces.size() + count > most_faces_ || model_.vertices.size() + positions->count() > most_faces_)
            fail_gltf(where, "the nodes show it too often for a file of this size");

        // Colours of corners are laid over the material's; a picture stays alone.
        const bool pictured = material != kNone && (model_.materials[material].picture != kNone ||
                                                    !model_.materials[material].picture_path.empty());
        const glm::vec3 base = material == kNone ? glm::vec3(1) : model_.materials[material].color;
        const bool painted = colors && !pictured;
        const First first{model_.vertices.size(), model_.normals.size(), model_.uvs.size(), model_.colors.size()};
        const glm::dmat3 linear(to_scene);
        // Of normals: the inverse transposed, times the determinant, so that nothing is divided by.
        const glm::dmat3 turning(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                                 glm::cross(linear[0], linear[1]));
        const double determinant = glm::dot(linear[0], turning[0]), side = determinant < 0.0 ? -1.0 : 1.0;
        const auto vector = [](const GltfRows& rows, std::size_t i) {
            return glm::dvec3(rows.real(i, 0), rows.real(i, 1), rows.real(i, 2));
        };
        const auto turned = [](const glm::dvec3& v) { return glm::dvec3(v.x, v.y, -v.z); };
        for (std::size_t i = 0; i < positions->count(); ++i) {
            const glm::dvec3 p = glm::dvec3(to_scene * glm::dvec4(vector(*positions, i), 1.0));
            if (!std::isfinite(p.x + p.y + p.z)) fail_gltf(where, "a vertex is out of all bounds");
            model_.vertices.push_back(turned(p));
            if (normals) model_.normals.push_back(turned(side * (turning * vector(*normals, i))));
            if (uvs) model_.uvs.emplace_back(uvs->real(i, 0), 1.0 - uvs->real(i, 1));
            if (painted) model_.colors.push_back(base * glm::vec3(vector(*colors, i)));
        }
        const auto corner = [&](std::size_t i) {
            const std::uint32_t index = indices ? indices->index(i) : static_cast<std::uint32_t>(i);
            if (index >= positions->count())
                fail_gltf(where, "there is no vertex " + std::to_string(index) + ": they are " +
                                     std::to_string(positions->count()));
            return index;
        };
        const bool keep = determinant < 0.0;  // the mirrored axis turns all round once
        const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
            std::array<std::uint32_t, 3> at{corner(a), corner(b), corner(c)};
            if (at[0] == at[1] || at[1] == at[2] || at[0] == at[2]) return;  // strips turn round by such
            if (!keep) std::swap(at[1], at[2]);
            const auto from = [&](std::size_t begin) {
                const auto n = static_cast<std::uint32_t>(begin);
                return std::array{n + at[0], n + at[1], n + at[2]};
            };
            Model::Face face;
            face.vertex = from(first.vertex);
            if (normals) face.normal = from(first.normal);
            if (uvs) face.uv = from(first.uv);
            if (painted) face.color = from(first.color);
            face.material = material;
            model_.faces.push_back(face);
        };
        if (mode == kTriangles)
            for (std::size_t i = 2; i < count; i += 3) add(i - 2, i - 1, i);
        for (std::size_t i = 2; mode == kStrip && i < count; ++i)
            i % 2 == 0 ? add(i - 2, i - 1, i) : add(i - 1, i - 2, i);
        for (std::size_t i = 2; mode == kFan && i < count; ++i) add(0, i - 1, i);
    }

    void read_materials()
    {
        const std::size_t count = list("materials").size();
        for (std::size_t i = 0; i < count; ++i) {
            const std::string where = "material " + std::to_string(i);
            const GltfJson& of = gltf_item(file_, "materials", i, where);
            Model::Material& material = model_.materials.emplace_back();
            material.name = text_of(of, "name");
            if (material.name.empty()) material.name = where;
            material.told = true;
            if (const auto emission = numbers<3>(of, "emissiveFactor", where))
                material.emission = glm::vec3((*emission)[0], (*emission)[1], (*emission)[2]);
            const bool blends = text_of(of, "alphaMode") == "BLEND";
            material.opaque = !blends && text_of(of, "alphaMode") != "MASK";
            const auto surface = of.find("pbrMetallicRoughness");
            if (surface == of.end() || !surface->is_object()) continue;
            if (const auto base = numbers<4>(*surface, "baseColorFactor", where)) {
                material.color = glm::vec3((*base)[0], (*base)[1], (*base)[2]);
                if (blends) material.opacity = static_cast<float>(std::clamp((*base)[3], 0.0, 1.0));
            }
            const auto texture = surface->find("baseColorTexture");
            if (texture != surface->end() && texture->is_object()) read_picture(*texture, where, material);
        }
    }

    void read_picture(const GltfJson& texture, const std::string& where, Model::Material& material)
    {
        if (gltf_count(texture, "texCoord", 0, where) != 0) return;  // coordinates that are not read
        const GltfJson& named = gltf_item(file_, "textures", gltf_count(texture, "index", 0, where), where);
        if (!named.contains("source")) return;  // of an extension
        const std::size_t index = gltf_count(named, "source", 0, where);
        const GltfJson& picture = gltf_item(file_, "images", index, where);
        if (!picture.contains("bufferView")) {
            const std::string uri = text_of(picture, "uri");
            if (!uri.starts_with("data:")) material.picture_path = without_escapes(uri);
            return;
        }
        const auto known = std::find(picture_of_.begin(), picture_of_.end(), index);
        material.picture = static_cast<std::uint32_t>(known - picture_of_.begin());
        if (known != picture_of_.end()) return;
        picture_of_.push_back(index);
        model_.pictures.emplace_back(gltf_view(file_, chunks_.binary, gltf_count(picture, "bufferView", 0, where),
                                               "image " + std::to_string(index)));
    }

    struct First {
        std::size_t vertex, normal, uv, color;
    };

    Chunks chunks_;
    std::size_t most_faces_;
    GltfJson file_;
    Model model_;
    std::vector<bool> shown_;
    std::vector<std::size_t> picture_of_;  ///< which of the file's images each of the model's pictures is
};

}  // namespace

bool is_glb(std::string_view bytes) { return bytes.starts_with("glTF"); }

Model glb_of(std::string_view bytes) { return Glb(bytes).read(); }

}  // namespace model
