#include "parser/grammar/core/rules.h"
#include "parser/grammar/objects/solid_shapes.h"

#include <array>

/// Solids given by a few numbers: what stands between the keyword's brace and the first modifier.
namespace parser {
namespace {

struct SolidState : BlockState {
    SolidState(SceneBuilder& builder, Kind keyword, scene::Object& made)
        : BlockState(builder), form(*solid_form(keyword)), object(made)
    {}
    const SolidForm& form;
    scene::Object& object;

    /// The components of the values that were read, in order.
    std::array<double, 18> values()
    {
        std::array<double, 18> all{};
        std::size_t at = 0;
        for (const char kind : form.values) at += kind == 'v' ? 3 : 1;
        for (std::size_t i = form.values.size(); i-- > 0;) {
            if (form.values[i] == 'n') {
                all[--at] = pop_float();
                continue;
            }
            const glm::dvec3 v = pop_vector();
            at -= 3;
            for (int c = 0; c < 3; ++c) all[at + static_cast<std::size_t>(c)] = v[c];
        }
        return all;
    }
};

bool open_ends(SolidState& s) { return s.stream().accept(Kind::Open); }

/// The ends of a cylinder or cone are one point. Points that were found by asking an unsupported object are guesses:
/// what they make is not the scene's fault.
void same_ends(SolidState& s, const glm::dvec3& base, glm::dvec3& cap, const char* message)
{
    if (!s.build.guessed) s.stream().fail(s.object.source, message);
    s.stream().warn(s.object.source, message);
    cap = base + glm::dvec3(0, 1, 0);
}

struct center : seq<a_vector> {};
struct radius : seq<opt_comma, a_number> {};
struct sphere : seq<must<center>, must<radius>> {};
void make_sphere(SolidState& s)
{
    read_rule<sphere>(s.build, s);
    s.form.set(s.values().data(), false, s.object);
}

struct corner : seq<a_vector> {};
struct second_corner : seq<opt_comma, a_vector> {};
struct box : seq<must<corner>, must<second_corner>> {};
void make_box(SolidState& s)
{
    read_rule<box>(s.build, s);
    s.form.set(s.values().data(), false, s.object);
}

struct plane_normal : seq<a_vector> {};
struct plane_distance : seq<opt_comma, a_number> {};
struct plane : seq<must<plane_normal>, must<plane_distance>> {};
void make_plane(SolidState& s)
{
    read_rule<plane>(s.build, s);
    if (!s.form.set(s.values().data(), false, s.object))
        s.stream().fail(s.object.source, "this plane's normal is zero, so it has no direction");
}

struct end_point : seq<a_vector> {};
struct other_end : seq<opt_comma, a_vector> {};
struct cylinder : seq<must<end_point>, must<other_end>, must<radius>> {};
void make_cylinder(SolidState& s)
{
    read_rule<cylinder>(s.build, s);
    const auto v = s.values();
    if (s.form.set(v.data(), open_ends(s), s.object)) return;
    auto& made = std::get<scene::Cylinder>(s.object.shape);
    same_ends(s, made.base, made.cap, "this cylinder's ends are the same point");
}

struct cone : seq<must<end_point>, must<radius>, must<other_end>, must<radius>> {};
void make_cone(SolidState& s)
{
    read_rule<cone>(s.build, s);
    const auto v = s.values();
    if (s.form.set(v.data(), open_ends(s), s.object)) return;
    auto& made = std::get<scene::Cone>(s.object.shape);
    same_ends(s, made.base, made.cap, "this cone's ends are the same point");
}

struct major_radius : seq<a_number> {};
struct minor_radius : seq<opt_comma, a_number> {};
struct torus : seq<must<major_radius>, must<minor_radius>> {};
void make_torus(SolidState& s)
{
    read_rule<torus>(s.build, s);
    s.form.set(s.values().data(), false, s.object);
}

struct square_terms : seq<a_vector> {};
struct mixed_terms : seq<opt_comma, a_vector> {};
struct linear_terms : seq<opt_comma, a_vector> {};
struct constant_term : seq<opt_comma, a_number> {};
struct quadric : seq<must<square_terms>, must<mixed_terms>, must<linear_terms>, must<constant_term>> {};
void make_quadric(SolidState& s)
{
    read_rule<quadric>(s.build, s);
    s.form.set(s.values().data(), false, s.object);
}

struct disc_normal : seq<opt_comma, a_vector> {};
struct disc : seq<must<center>, must<disc_normal>, must<radius>> {};
void make_disc(SolidState& s)
{
    read_rule<disc>(s.build, s);
    s.form.set(s.values().data(), false, s.object);
    s.stream().accept_comma();
    if (at_expression(s.stream())) std::get<scene::Disc>(s.object.shape).hole = parser::float_expr(s.stream());
}

struct vertex : seq<opt_comma, a_vector> {};
struct vertex_normal : seq<opt_comma, a_vector> {};
struct triangle : seq<must<vertex>, must<vertex>, must<vertex>> {};
struct smooth_triangle
    : seq<must<vertex>, must<vertex_normal>, must<vertex>, must<vertex_normal>, must<vertex>, must<vertex_normal>> {};
void make_triangle(SolidState& s)
{
    bool good = false;
    if (s.stream().peek().kind == Kind::Numbers) {
        good = s.form.set(s.stream().values_of(s.stream().next()).data(), false, s.object);
    } else {
        read_rule<triangle>(s.build, s);
        good = s.form.set(s.values().data(), false, s.object);
    }
    if (!good) s.stream().warn(s.object.source, "this triangle's corners lie on a line");
}
void make_smooth_triangle(SolidState& s)
{
    if (s.stream().peek().kind == Kind::Numbers) {
        s.form.set(s.stream().values_of(s.stream().next()).data(), false, s.object);
        return;
    }
    read_rule<smooth_triangle>(s.build, s);
    s.form.set(s.values().data(), false, s.object);
}

struct SolidEntry {
    Kind keyword;
    void (*make)(SolidState&);
};
constexpr SolidEntry kSolids[] = {
    {Kind::Sphere, make_sphere},     {Kind::Box, make_box},
    {Kind::Plane, make_plane},       {Kind::Cylinder, make_cylinder},
    {Kind::Cone, make_cone},         {Kind::Torus, make_torus},
    {Kind::Quadric, make_quadric},   {Kind::Disc, make_disc},
    {Kind::Triangle, make_triangle}, {Kind::SmoothTriangle, make_smooth_triangle},
};
using Makers = std::array<void (*)(SolidState&), kKindCount>;
constexpr Makers makers()
{
    Makers all{};
    for (const SolidEntry& entry : kSolids) all[static_cast<std::size_t>(entry.keyword)] = entry.make;
    return all;
}
constexpr Makers kMakers = makers();

}  // namespace

template <>
inline constexpr auto expected<sphere> = "the sphere's centre and radius";
template <>
inline constexpr auto expected<center> = "the centre, as in <0, 1, 0>";
template <>
inline constexpr auto expected<radius> = "the radius (a number)";
template <>
inline constexpr auto expected<box> = "the box's two corners";
template <>
inline constexpr auto expected<corner> = "the box's first corner, as in <-1, -1, -1>";
template <>
inline constexpr auto expected<second_corner> = "the box's second corner, as in <1, 1, 1>";
template <>
inline constexpr auto expected<plane> = "the plane's normal and distance";
template <>
inline constexpr auto expected<plane_normal> = "the plane's normal, as in <0, 1, 0>";
template <>
inline constexpr auto expected<plane_distance> = "the plane's distance from the origin (a number)";
template <>
inline constexpr auto expected<cylinder> = "the cylinder's two ends and radius";
template <>
inline constexpr auto expected<cone> = "the cone's ends, each with its radius";
template <>
inline constexpr auto expected<end_point> = "the centre of the first end, as in <0, 0, 0>";
template <>
inline constexpr auto expected<other_end> = "the centre of the second end, as in <0, 1, 0>";
template <>
inline constexpr auto expected<torus> = "the torus's two radii";
template <>
inline constexpr auto expected<major_radius> = "the torus's major radius (a number)";
template <>
inline constexpr auto expected<minor_radius> = "the torus's minor radius (a number)";
template <>
inline constexpr auto expected<quadric> = "the quadric's ten coefficients";
template <>
inline constexpr auto expected<square_terms> = "the quadric's x^2, y^2, z^2 coefficients, as in <1, 1, 1>";
template <>
inline constexpr auto expected<mixed_terms> = "the quadric's xy, xz, yz coefficients, as in <0, 0, 0>";
template <>
inline constexpr auto expected<linear_terms> = "the quadric's x, y, z coefficients, as in <0, 0, 0>";
template <>
inline constexpr auto expected<constant_term> = "the quadric's constant (a number)";
template <>
inline constexpr auto expected<disc> = "the disc's centre, normal and radius";
template <>
inline constexpr auto expected<disc_normal> = "the disc's normal, as in <0, 1, 0>";
template <>
inline constexpr auto expected<triangle> = "the triangle's three corners";
template <>
inline constexpr auto expected<smooth_triangle> = "the triangle's corners, each with its normal";
template <>
inline constexpr auto expected<vertex> = "a corner of the triangle, as in <0, 1, 0>";
template <>
inline constexpr auto expected<vertex_normal> = "the normal at this corner, as in <0, 1, 0>";

bool is_solid(Kind keyword) { return kMakers[static_cast<std::size_t>(keyword)] != nullptr; }

void read_solid(SceneBuilder& build, Kind keyword, scene::Object& object)
{
    object.source = build.stream().last();
    const std::string_view name = spelling(keyword);
    const scene::SourceRef opened = build.open_block(name);
    // `sphere { NAME ... }` is a copy of any declared object.
    if (const auto declared = build.stream().accept_identifier<std::shared_ptr<const scene::Object>>()) {
        object = **declared;
    } else {
        SolidState s(build, keyword, object);
        kMakers[static_cast<std::size_t>(keyword)](s);
    }
    read_modifiers(build, object);
    build.close_block(name, opened);
}

}  // namespace parser
