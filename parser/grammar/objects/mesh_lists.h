#pragma once

#include "parser/grammar/core/rules.h"
#include "parser/lexer/number_blocks.h"

/// The lists of a mesh2: vectors, and indices with textures, as the lexer has read them or number by number.
namespace parser {

inline constexpr std::array<std::uint32_t, 3> kNoIndices{scene::MeshData::kNone, scene::MeshData::kNone,
                                                         scene::MeshData::kNone};

/// A declared vector, or element of an array of them: the next face, no texture's number.
inline bool at_vector(TokenStream& in)
{
    const Value* value = in.peek().kind == Kind::Identifier ? in.value_of(in.peek()) : nullptr;
    while (const auto* array = value ? value->get_if<std::shared_ptr<Array>>() : nullptr) {
        value = nullptr;
        for (const Value& element : (*array)->elements)
            if (element.set()) value = &element;
    }
    const Tuple* tuple = value ? value->get_if<Tuple>() : nullptr;
    return tuple && tuple->count > 1;
}

/// The mesh that is being read.
struct MeshState : BlockState {
    using BlockState::BlockState;
    std::shared_ptr<scene::MeshData> data = std::make_shared<scene::MeshData>();
    bool of_file = false;              ///< some of its triangles are
    std::vector<std::uint32_t> looks;  ///< textures that files tell, as indices into data->textures
    std::uint32_t add_texture(scene::TexturePtr t)
    {
        data->textures.push_back(std::move(t));
        return static_cast<std::uint32_t>(data->textures.size() - 1);
    }
    glm::dvec3 vector()
    {
        stream().accept_comma();
        if (!at_expression(stream())) build.fail_unknown("a vector, as in <0, 1, 0>");
        return parser::vector_expr(stream());
    }
    /// Literal vectors, if they are next: the lexer has read them.
    const Token* numbers()
    {
        if (stream().peek().kind != Kind::Numbers) return nullptr;
        return &stream().next();
    }
    glm::dvec2 pair()
    {
        stream().accept_comma();
        return parser::vector2_expr(stream());
    }
    std::size_t count()
    {
        stream().accept_comma();
        const double n = parser::float_expr(stream());
        if (!(n >= 0) || n > 1e9) stream().fail(stream().last(), "a count must be 0 or more");
        return static_cast<std::size_t>(n);
    }
};

/// Behind `obj` and `file`: the file's name and what its materials are; adds its triangles (model_meshes.cpp).
void read_model_mesh(MeshState& s, Kind word);
Form model_mesh_form();
/// A mesh with triangles of a file is a solid by itself where they are closed and all look the same way.
void settle_inside(MeshState& s);
/// "; " and where a mesh is open or turned over; nothing of what is no mesh, or a closed one.
std::string why_open(const scene::Object& object);

struct Indices {
    std::array<std::uint32_t, 3> at;
    std::array<std::uint32_t, 3> texture;
};

/// Where the token stands that is the last of a list's item: of its vector, or of its texture `texture` (from 0).
inline scene::SourceRef place_in_list(TokenStream& in, const Token& numbers, std::size_t item, int texture)
{
    SourceFile list;
    list.text = in.text_from(numbers);
    if (list.text.empty()) return {numbers.file, numbers.offset};
    Names names;
    tokenize(list, 0, names, false, false);
    std::size_t at = 0;
    for (std::size_t closed = 0; closed <= item; ++at) closed += list.tokens[at].kind == Kind::Greater ? 1 : 0;
    --at;
    for (int t = -1; t < texture; ++at)
        if (list.tokens[at + 1].kind == Kind::Number) ++t;
    return {numbers.file, numbers.offset + list.tokens[at].offset};
}

template <class Take>
void take_indices(MeshState& s, const Token& numbers, const char* what, std::size_t limit, Take&& take)
{
    TokenStream& in = s.stream();
    const std::span<const double> values = in.values_of(numbers);
    const auto stride = static_cast<std::size_t>(numbers.number);
    for (std::size_t n = 0; n < numbers.jump; ++n) {
        const double* const v = &values[n * stride];
        Indices one{{}, kNoIndices};
        for (std::size_t i = 0; i < 3; ++i) {
            if (v[i] < 0 || v[i] >= static_cast<double>(limit))
                in.fail(place_in_list(in, numbers, n, -1), std::string("an index of ") + what + " is out of range");
            one.at[i] = static_cast<std::uint32_t>(v[i]);
        }
        for (std::size_t t = 0; stride == 6 && t < 3 && v[3 + t] != kNoTexture; ++t) {
            if (v[3 + t] >= static_cast<double>(s.data->textures.size()))
                in.fail(place_in_list(in, numbers, n, static_cast<int>(t)),
                        "a texture index of face_indices is out of range");
            const auto index = static_cast<std::uint32_t>(v[3 + t]);
            if (t == 0) one.texture.fill(index);
            else one.texture[t] = index;
        }
        take(n, one);
    }
}

/// `{ count, <a,b,c> [, t [, t, t]], ... }`. `take` gets each with its number; `expect` how many come.
template <class Expect, class Take>
void read_indices(MeshState& s, const char* what, std::size_t limit, bool textures, Expect&& expect, Take&& take)
{
    TokenStream& in = s.stream();
    const auto opened = s.build.open_block(what);
    if (const Token* const numbers = s.numbers()) {
        expect(numbers->jump);
        take_indices(s, *numbers, what, limit, take);
        s.build.close_block(what, opened);
        return;
    }
    const std::size_t count = s.count();
    expect(count);
    for (std::size_t n = 0; n < count; ++n) {
        Indices one{{}, kNoIndices};
        const glm::dvec3 v = s.vector();
        for (int i = 0; i < 3; ++i) {
            if (v[i] < 0 || v[i] >= static_cast<double>(limit))
                in.fail(in.last(), std::string("an index of ") + what + " is out of range");
            one.at[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(v[i]);
        }
        // After a face up to three numbers name the textures of its corners.
        for (std::size_t t = 0; textures && t < 3; ++t) {
            in.accept_comma();
            if (in.peek().kind == Kind::Less || in.peek().kind == Kind::RightBrace || !at_expression(in) ||
                at_vector(in))
                break;
            const auto index = static_cast<std::uint32_t>(parser::float_expr(in));
            if (index >= s.data->textures.size()) in.fail(in.last(), "a texture index of face_indices is out of range");
            if (t == 0) one.texture.fill(index);
            else one.texture[t] = index;
        }
        take(n, one);
    }
    in.accept_comma();
    s.build.close_block(what, opened);
}

template <class Vector>
Vector vector_at(const double* v)
{
    if constexpr (Vector::length() == 2) return {v[0], v[1]};
    else return {v[0], v[1], v[2]};
}

template <class Vector, class Read>
std::vector<Vector> read_vectors(MeshState& s, const char* what, Read&& read)
{
    const auto opened = s.build.open_block(what);
    if (const Token* const numbers = s.numbers()) {
        std::vector<Vector> all;
        all.reserve(numbers->jump);
        const double* v = s.stream().values_of(*numbers).data();
        for (std::uint32_t i = 0; i < numbers->jump; ++i, v += Vector::length()) all.push_back(vector_at<Vector>(v));
        s.build.close_block(what, opened);
        return all;
    }
    std::vector<Vector> all(s.count());
    for (Vector& v : all) v = read();
    s.stream().accept_comma();
    s.build.close_block(what, opened);
    return all;
}

}  // namespace parser
