#include "parser/grammar/objects/mesh_lists.h"
#include "parser/grammar/objects/model_looks.h"

#include <algorithm>

namespace parser {
namespace {

using Data = scene::MeshData;

scene::TexturePtr accept_texture_name(TokenStream& in)
{
    const auto name = in.accept_identifier<scene::TexturePtr>();
    return name ? *name : nullptr;
}

// ---- mesh -----------------------------------------------------------------------------------------------------
void take_corners(MeshState& s, const double* v, bool smooth, Data::Face& face)
{
    const auto first = [](const auto& all) { return static_cast<std::uint32_t>(all.size()); };
    for (std::uint32_t i = 0; i < 3; ++i) {
        const std::size_t at = i * (smooth ? 6 : 3);
        face.vertex[i] = first(s.data->vertices);
        s.data->vertices.emplace_back(v[at], v[at + 1], v[at + 2]);
        if (!smooth) continue;
        face.normal[i] = first(s.data->normals);
        s.data->normals.emplace_back(v[at + 3], v[at + 4], v[at + 5]);
    }
}

/// Triangles that the lexer has read.
void take_faces(MeshState& s, const Token& faces)
{
    const double* const begin = s.stream().values_from(faces).data();
    std::size_t smooth = 0;
    const double* v = begin;
    for (std::uint32_t i = 0; i < faces.jump; ++i, v += 1 + static_cast<std::size_t>(*v)) smooth += *v == kSmoothFace;
    s.data->faces.reserve(faces.jump);
    s.data->vertices.reserve(3 * std::size_t{faces.jump});
    s.data->normals.reserve(3 * smooth);
    v = begin;
    for (std::uint32_t i = 0; i < faces.jump; ++i, v += 1 + static_cast<std::size_t>(*v)) {
        Data::Face face{kNoIndices, kNoIndices, kNoIndices, kNoIndices};
        take_corners(s, v + 1, *v == kSmoothFace, face);
        s.data->faces.push_back(face);
    }
}

void read_face(MeshState& s, bool smooth)
{
    TokenStream& in = s.stream();
    const char* what = smooth ? "smooth_triangle" : "triangle";
    const auto opened = s.build.open_block(what);
    Data::Face face{kNoIndices, kNoIndices, kNoIndices, kNoIndices};
    const Token* const numbers = s.numbers();
    if (numbers) take_corners(s, in.values_of(*numbers).data(), smooth, face);
    for (std::size_t i = 0; !numbers && i < 3; ++i) {
        face.vertex[i] = static_cast<std::uint32_t>(s.data->vertices.size());
        s.data->vertices.push_back(s.vector());
        if (!smooth) continue;
        face.normal[i] = static_cast<std::uint32_t>(s.data->normals.size());
        s.data->normals.push_back(s.vector());
    }
    for (bool more = true; more;) {
        if (in.accept(Kind::UvVectors)) {
            for (std::size_t i = 0; i < 3; ++i) {
                face.uv[i] = static_cast<std::uint32_t>(s.data->uvs.size());
                s.data->uvs.push_back(s.pair());
            }
        } else if (in.accept(Kind::Texture)) {
            face.texture.fill(s.add_texture(read_textures(s.build)));
        } else if (in.accept(Kind::TextureList)) {
            const auto list = s.build.open_block("texture_list");
            for (std::size_t i = 0; i < 3; ++i) {
                const scene::TexturePtr name = accept_texture_name(in);
                if (!name) in.expect(Kind::Texture, "a texture");
                face.texture[i] = s.add_texture(name ? name : read_texture(s.build));
                in.accept_comma();
            }
            s.build.close_block("texture_list", list);
        } else {
            more = false;
        }
    }
    s.data->faces.push_back(face);
    s.build.close_block(what, opened);
}

// ---- mesh2 ----------------------------------------------------------------------------------------------------
constexpr std::size_t kMostExpected = 1'000'000;  ///< of what a text says it has

/// `{` how many, then so many of them `}`
Form list_form(Form one)
{
    return Form::braces(
        {form_of<seq<a_number, opt_comma>>(), Form::repeated(Form::sequence({std::move(one), form_of<opt_comma>()}))});
}
Production vector_list() { return {"vector_list", list_form(form_of<a_vector>())}; }
Production pair_list() { return {"pair_list", list_form(form_of<a_pair>())}; }
/// Behind the vertices of a face up to three textures.
Production index_list()
{
    return {"index_list", list_form(form_of<seq<a_vector, pegtl::star<opt_comma, a_number>>>())};
}
Form one_texture()
{
    return Form::choice(
        {Form::operand("identifier"), Form::sequence({Form::token(Kind::Texture), Form::named(texture_block)})});
}
Production texture_list_block() { return {"texture_list_block", list_form(one_texture())}; }
struct vertex_vectors : item<Kind::VertexVectors, reads<vector_list>> {
    static void act(MeshState& s)
    {
        s.data->vertices = read_vectors<glm::dvec3>(s, "vertex_vectors", [&] { return s.vector(); });
    }
};
struct normal_vectors : item<Kind::NormalVectors, reads<vector_list>> {
    static void act(MeshState& s)
    {
        s.data->normals = read_vectors<glm::dvec3>(s, "normal_vectors", [&] { return s.vector(); });
    }
};
struct uv_vectors : item<Kind::UvVectors, reads<pair_list>> {
    static void act(MeshState& s)
    {
        s.data->uvs = read_vectors<glm::dvec2>(s, "uv_vectors", [&] { return s.pair(); });
    }
};
struct texture_list : item<Kind::TextureList, reads<texture_list_block>> {
    static void act(MeshState& s)
    {
        TokenStream& in = s.stream();
        const auto opened = s.build.open_block("texture_list");
        for (std::size_t left = s.count(); left > 0; --left) {
            in.accept_comma();
            scene::TexturePtr name = accept_texture_name(in);
            if (!name) in.expect(Kind::Texture, "a texture");
            s.add_texture(name ? name : read_texture(s.build));
        }
        in.accept_comma();
        s.build.close_block("texture_list", opened);
    }
};
struct face_indices : item<Kind::FaceIndices, reads<index_list>> {
    static void act(MeshState& s)
    {
        std::vector<Data::Face>& faces = s.data->faces;
        read_indices(
            s, "face_indices", s.data->vertices.size(), true,
            [&](std::size_t count) { faces.reserve(faces.size() + std::min(count, kMostExpected)); },
            [&](std::size_t, const Indices& one) {
                faces.push_back({one.at, kNoIndices, kNoIndices, one.texture});
            });
    }
};
template <Kind kind, std::array<std::uint32_t, 3> Data::Face::*member>
struct more_indices : item<kind, reads<index_list>> {
    static void act(MeshState& s)
    {
        const bool normals = kind == Kind::NormalIndices;
        const std::size_t limit = normals ? s.data->normals.size() : s.data->uvs.size();
        std::vector<Data::Face>& faces = s.data->faces;
        read_indices(
            s, normals ? "normal_indices" : "uv_indices", limit, false, [](std::size_t) {},
            [&](std::size_t i, const Indices& one) {
                if (i < faces.size()) faces[i].*member = one.at;
            });
    }
};
struct inside_vector : item<Kind::InsideVector, a_vector> {
    static void act(MeshState& s)
    {
        s.data->inside_vector = s.pop_vector();
        s.data->has_inside_vector = true;
    }
};
using Mesh2Items = table<MeshState, vertex_vectors, normal_vectors, uv_vectors, texture_list, face_indices,
                         more_indices<Kind::NormalIndices, &Data::Face::normal>,
                         more_indices<Kind::UvIndices, &Data::Face::uv>, inside_vector>;

/// Where there are as many normals (uvs) as vertices and no indices for them, the face's own are meant.
void share_indices(Data& data)
{
    for (Data::Face& face : data.faces) {
        if (face.normal == kNoIndices && !data.normals.empty() && data.normals.size() == data.vertices.size())
            face.normal = face.vertex;
        if (face.uv == kNoIndices && !data.uvs.empty() && data.uvs.size() == data.vertices.size())
            face.uv = face.vertex;
    }
}

scene::Object finish_mesh(MeshState& s, scene::Object object, bool declared)
{
    if (!declared) object.shape = scene::Mesh{s.data};
    read_modifiers(s.build, object);
    return object;
}
bool declared_mesh(TokenStream& in, scene::Object& object)
{
    const auto declared = in.accept_identifier<std::shared_ptr<const scene::Object>>();
    if (declared) object = **declared;
    return declared.has_value();
}

}  // namespace

Production mesh_block()
{
    const Form corner_textures =
        Form::sequence({Form::token(Kind::TextureList), Form::braces({Form::repeated(one_texture())})});
    const Form more =
        Form::choice({form_of<seq<token<Kind::UvVectors>, pegtl::rep<3, a_pair, opt_comma>>>(), corner_textures,
                      Form::sequence({Form::token(Kind::Texture), Form::named(texture_block)})});
    const auto face = [&](Kind keyword, Form corners) {
        return Form::sequence({Form::token(keyword), Form::braces({std::move(corners), Form::repeated(more)})});
    };
    const Form item = Form::choice({face(Kind::Triangle, form_of<pegtl::rep<3, a_vector, opt_comma>>()),
                                    face(Kind::SmoothTriangle, form_of<pegtl::rep<6, a_vector, opt_comma>>()),
                                    model_mesh_form(), form_of<inside_vector>()});
    return {"mesh_block",
            Form::braces(
                {Form::choice({Form::operand("identifier"), Form::repeated(item, 1)}),
                 Form::repeated(Form::choice({form_of<ignored<Kind::Hierarchy>>(), Form::named(object_modifier)}))})};
}
Production mesh2_block()
{
    return {"mesh2_block",
            Form::braces(
                {Form::choice({Form::operand("identifier"), Form::repeated(Mesh2Items::form())}),
                 Form::repeated(Form::choice({form_of<ignored<Kind::Hierarchy>>(), Form::named(object_modifier)}))})};
}

scene::Object read_mesh(SceneBuilder& build, const scene::SourceRef& source)
{
    TokenStream& in = build.stream();
    MeshState s(build);
    scene::Object object;
    object.source = source;
    const auto opened = build.open_block("mesh");
    const bool declared = declared_mesh(in, object);
    FaceReceiver receiver(*s.data);
    for (bool more = !declared; more;) {
        peek_for(in, build.receiver, receiver);
        if (in.accept(Kind::Triangle)) read_face(s, false);
        else if (in.accept(Kind::SmoothTriangle)) read_face(s, true);
        else if (in.peek().kind == Kind::Faces) take_faces(s, in.next());
        else if (in.accept(Kind::Obj)) read_model_mesh(s, Kind::Obj);
        else if (in.accept(Kind::File)) read_model_mesh(s, Kind::File);
        else if (table<MeshState, inside_vector>::match(build, s)) continue;
        else more = false;
    }
    if (!declared && s.data->faces.empty()) build.stream().fail(source, "this mesh has no triangles");
    if (s.of_file) settle_inside(s), settle_look(s, object);
    object = finish_mesh(s, std::move(object), declared);
    build.close_block("mesh", opened);
    return object;
}

scene::Object read_mesh2(SceneBuilder& build, const scene::SourceRef& source)
{
    MeshState s(build);
    scene::Object object;
    object.source = source;
    const auto opened = build.open_block("mesh2");
    const bool declared = declared_mesh(build.stream(), object);
    if (!declared)
        while (Mesh2Items::match(build, s)) {}
    share_indices(*s.data);
    object = finish_mesh(s, std::move(object), declared);
    build.close_block("mesh2", opened);
    return object;
}

}  // namespace parser
