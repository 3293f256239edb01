#include "csg/mesh/mesh_edges.h"
#include "parser/grammar/objects/mesh_lists.h"
#include "parser/grammar/objects/model_looks.h"
#include "parser/stream/files/file_bytes.h"
#include "render/model/obj_reader.h"
#include "render/model/read_model.h"

#include <fmt/format.h>

#include <unordered_map>

/// Meshes whose triangles are a file's: POV-Ray 3.8's mesh { obj ... }, and mesh { file ... } (docs/tools/meshes.md).
namespace parser {
namespace {

/// What the names of materials mean.
struct MaterialList {
    std::unordered_map<std::string, std::uint32_t> by_name;  ///< indices into the mesh's textures
    bool asked = false;                                      ///< names of declared textures, with prefix and suffix
    bool bare = true;                                        ///< it has no entry
    std::string prefix, suffix;
};

/// `{ "name" texture { ... } ... prefix "p" suffix "s" }`, commas between them optional.
MaterialList read_materials(MeshState& s)
{
    TokenStream& in = s.stream();
    MaterialList list;
    const auto opened = s.build.open_block("texture_list");
    for (bool more = true; more;) {
        in.accept_comma();
        list.bare = list.bare && in.peek().kind == Kind::RightBrace;
        if (in.accept(Kind::Prefix)) list.prefix = parser::string_expr(in);
        else if (in.accept(Kind::Suffix)) list.suffix = parser::string_expr(in);
        else if (at_string(in)) {
            const std::string name = parser::string_expr(in);
            in.accept_comma();
            const auto declared = in.accept_identifier<scene::TexturePtr>();
            if (!declared) in.expect(Kind::Texture, "a texture");
            list.by_name[name] = s.add_texture(declared ? *declared : read_textures(s.build));
        } else {
            more = false;
        }
    }
    s.build.close_block("texture_list", opened);
    return list;
}

model::Model read_file(TokenStream& in, Kind word, const scene::SourceRef& at, const std::string& name,
                       const std::string& path)
{
    try {
        const std::string bytes = bytes_of_file(in, at, path);
        return word == Kind::Obj ? model::obj_of(bytes) : model::model_of(bytes, path);
    } catch (const model::ModelError& error) {
        if (error.byte != model::ModelError::kNowhere)
            in.fail(at, fmt::format("{}: byte {}: {}", path, error.byte, error.what()));
        if (error.line > 0) in.fail(at, fmt::format("{}:{}: {}", path, error.line, error.what()));
        in.fail(at, fmt::format("the file '{}' is no mesh: {}", name, error.what()));
    }
}

/// The texture of each material; kNone: the mesh's own.
std::vector<std::uint32_t> textures_of(MeshState& s, const scene::SourceRef& at, const model::Model& model,
                                       const MaterialList& list)
{
    std::vector<std::uint32_t> all;
    for (const model::Model::Material& material : model.materials) {
        const std::string& name = material.name;
        std::uint32_t texture = scene::MeshData::kNone;
        const std::string full = list.prefix + name + list.suffix;
        if (const auto known = list.by_name.find(name); known != list.by_name.end()) {
            texture = known->second;
        } else if (list.asked) {
            const Value* const value = s.stream().value_of(std::string_view(full));
            const auto* declared = value ? value->get_if<scene::TexturePtr>() : nullptr;
            if (declared) texture = s.add_texture(*declared);
            else
                s.stream().warn(at, fmt::format("the material '{}' is not in texture_list, and no texture '{}' is "
                                                "declared: it has the mesh's texture",
                                                name, full));
        }
        all.push_back(texture);
    }
    return all;
}

std::array<std::uint32_t, 3> counted_from(std::array<std::uint32_t, 3> of, std::size_t by)
{
    for (std::uint32_t& one : of)
        one = one == model::kNone ? scene::MeshData::kNone : one + static_cast<std::uint32_t>(by);
    return of;
}

}  // namespace

Form model_mesh_form()
{
    const Form entry = Form::choice(
        {form_of<seq<token<Kind::Prefix>, a_text>>(), form_of<seq<token<Kind::Suffix>, a_text>>(),
         Form::sequence({form_of<seq<a_text, opt_comma>>(),
                         Form::choice({Form::operand("identifier"),
                                       Form::sequence({Form::token(Kind::Texture), Form::named(texture_block)})})})});
    return Form::sequence(
        {form_of<seq<pegtl::sor<token<Kind::Obj>, token<Kind::File>>, a_text>>(),
         Form::optional(Form::sequence({Form::token(Kind::TextureList), Form::braces({Form::repeated(entry)})}))});
}

void read_model_mesh(MeshState& s, Kind word)
{
    TokenStream& in = s.stream();
    const scene::SourceRef at = in.here();
    const std::string name = parser::path_expr(in);
    const std::string path =
        in.find_file(name, word == Kind::Obj ? std::vector<std::string>{".obj", ".OBJ"} : std::vector<std::string>{});
    if (path.empty()) in.fail(at, fmt::format("cannot find the mesh file '{}'", name));
    in.read_files().data(path);
    const bool listed = in.accept(Kind::TextureList);
    MaterialList list = listed ? read_materials(s) : MaterialList{};
    list.asked = listed && (word == Kind::Obj || !list.bare);
    model::Model model = read_file(in, word, at, name, path);
    const bool told = word == Kind::File && !listed;  // `obj` leaves what files say of materials alone, as 3.8 does
    const std::vector<std::uint32_t> textures = told ? textures_told(s, at, path, model)
                                                     : textures_of(s, at, model, list);

    scene::MeshData& mesh = *s.data;
    const std::size_t vertices = mesh.vertices.size(), normals = mesh.normals.size(), uvs = mesh.uvs.size();
    const auto append = [](auto& to, auto& from) {
        if (to.empty()) to = std::move(from);
        else to.insert(to.end(), from.begin(), from.end());
    };
    append(mesh.vertices, model.vertices);
    append(mesh.normals, model.normals);
    append(mesh.uvs, model.uvs);
    const std::size_t first = mesh.faces.size();
    mesh.faces.reserve(first + model.faces.size());
    for (const model::Model::Face& face : model.faces) {
        scene::MeshData::Face made{counted_from(face.vertex, vertices), counted_from(face.normal, normals),
                                   counted_from(face.uv, uvs), kNoIndices};
        if (face.material != model::kNone) made.texture.fill(textures[face.material]);
        mesh.faces.push_back(made);
    }
    if (told) paint_corners(s, at, path, model, first);
    s.of_file = true;
}

namespace {

csg::MeshEdges edges_of(const scene::MeshData& mesh)
{
    std::vector<std::array<std::uint32_t, 3>> faces;
    faces.reserve(mesh.faces.size());
    for (const scene::MeshData::Face& face : mesh.faces) faces.push_back(face.vertex);
    return csg::edges_of(mesh.vertices, faces);
}

}  // namespace

std::string why_open(const scene::Object& object)
{
    const auto* mesh = std::get_if<scene::Mesh>(&object.shape);
    if (!mesh || !mesh->data) return {};
    const csg::MeshEdges edges = edges_of(*mesh->data);
    if (edges.open.empty()) return edges.oriented ? "" : "; some faces of this mesh look inwards, others outwards";
    const auto text = [&](std::uint32_t vertex) {
        const glm::dvec3& p = mesh->data->vertices[vertex];
        return fmt::format("<{:.6g}, {:.6g}, {:.6g}>", p.x, p.y, p.z);
    };
    return fmt::format("; {} of this mesh's edges {} no second face, as that from {} to {}", edges.open.size(),
                       edges.open.size() == 1 ? "has" : "have", text(edges.open[0][0]), text(edges.open[0][1]));
}

void settle_inside(MeshState& s)
{
    scene::MeshData& mesh = *s.data;
    if (mesh.has_inside_vector) return;
    const csg::MeshEdges edges = edges_of(mesh);
    if (!edges.open.empty() || !edges.oriented) return;
    mesh.has_inside_vector = true;
    mesh.inside_vector = csg::kAnyInsideVector;
}

}  // namespace parser
