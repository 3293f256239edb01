#include "parser/grammar/core/rules.h"
#include "render/scene/last_bits.h"

#include <fmt/format.h>

namespace parser {
namespace {

struct TransformState : BlockState {
    using BlockState::BlockState;
    csg::Transform result;
    bool inverse = false;
};

/// A component that is exactly 0 counts as 1 (spec 5a, 3.1).
glm::dvec3 repaired_scale(TransformState& s, glm::dvec3 by)
{
    for (int i = 0; i < 3; ++i) {
        if (by[i] != 0.0) continue;
        s.stream().warn(s.stream().last(), fmt::format("scale by 0 along {} changed to 1", "xyz"[i]));
        by[i] = 1.0;
    }
    return by;
}

/// Smallest column of a matrix that is not taken for a scale by 0 (spec 5a, 3.1).
constexpr double kZeroColumn = 1e-10;

/// `rows` as written: the images of x, y, z, then the translation.
csg::Transform matrix_transform(TransformState& s, const std::array<double, 12>& rows, const scene::SourceRef& at)
{
    csg::Transform t;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) t.linear[r][c] = rows[static_cast<std::size_t>(3 * r + c)];
    t.offset = {rows[9], rows[10], rows[11]};
    for (int c = 0; c < 3; ++c) {
        const glm::dvec3 column(t.linear[0][c], t.linear[1][c], t.linear[2][c]);
        if (glm::any(glm::greaterThanEqual(glm::abs(column), glm::dvec3(kZeroColumn)))) continue;
        s.stream().warn(at, "this matrix scales by 0: the empty column got 1 on its diagonal");
        t.linear[c][c] = 1.0;
    }
    if (glm::determinant(t.linear) == 0.0)
        s.stream().fail(at, "this matrix is singular: it flattens space and cannot be undone");
    t.inverse_linear = glm::inverse(t.linear);
    t.inverse_offset = -(t.inverse_linear * t.offset);
    return t;
}

struct translate : item<Kind::Translate, a_vector> {
    static void act(TransformState& s) { s.result = csg::Transform::translate(s.pop_vector()) * s.result; }
};
struct rotate : item<Kind::Rotate, a_vector> {
    static void act(TransformState& s) { s.result = scene::rotation(s.pop_vector(), s.stream().povray()) * s.result; }
};
struct scale : item<Kind::Scale, a_vector> {
    static void act(TransformState& s)
    {
        s.result = csg::Transform::scale(repaired_scale(s, s.pop_vector())) * s.result;
    }
};
struct matrix_number : seq<opt_comma, a_number> {};
struct matrix_open : token<Kind::Less> {};
struct matrix_close : seq<opt_comma, token<Kind::Greater>> {};
struct matrix : item<Kind::Matrix, matrix_open, pegtl::rep<12, must<matrix_number>>, matrix_close> {
    static void act(TransformState& s)
    {
        std::array<double, 12> rows{};
        for (std::size_t i = 12; i-- > 0;) rows[i] = s.pop_float();
        s.result = matrix_transform(s, rows, s.stream().last()) * s.result;
    }
};
using Shared = std::shared_ptr<const csg::Transform>;
struct transform : item<Kind::Transform, by_action<pegtl::sor<declared<Shared>, reads<transform_block>>>> {
    static void act(TransformState& s) { s.result = read_transform(s.build) * s.result; }
};
struct inverse : item<Kind::Inverse> {
    static void act(TransformState& s) { s.inverse = true; }
};

using Transformations = table<TransformState, translate, rotate, scale, matrix, transform>;
struct TransformItems {
    /// Names may stand anywhere in the block.
    static bool match(SceneBuilder& build, TransformState& s)
    {
        const auto declared = build.stream().accept_identifier<Shared>();
        if (declared) s.result = **declared * s.result;
        return declared || Known::match(build, s);
    }
    static std::vector<Kind> words() { return Known::words(); }
    static Form form() { return Form::choice({form_of<declared<Shared>>(), Known::form()}); }

private:
    using Known = either<Transformations, table<TransformState, inverse>>;
};
using TransformBlock = block<Kind::Transform, TransformItems>;

}  // namespace

template <>
inline constexpr auto expected<matrix_number> = "one of the matrix's 12 numbers";
template <>
inline constexpr auto expected<pegtl::rep<12, must<matrix_number>>> = "the matrix's 12 numbers";
template <>
inline constexpr auto expected<matrix_open> = "'<' and the matrix's 12 numbers";
template <>
inline constexpr auto expected<matrix_close> = "'>' after the matrix's 12 numbers";

std::optional<csg::Transform> read_transformation(SceneBuilder& build)
{
    if (!Transformations::begins(build)) return std::nullopt;
    TransformState state(build);
    Transformations::match(build, state);
    return state.result;
}

Production transformation() { return {"transformation", Transformations::form()}; }
Production transform_block() { return {"transform_block", TransformBlock::form()}; }

csg::Transform read_transform(SceneBuilder& build)
{
    if (const auto declared = build.stream().accept_identifier<Shared>()) return **declared;
    TransformState state(build);
    TransformBlock::read(build, state);
    return state.inverse ? state.result.inverted() : state.result;
}

}  // namespace parser
