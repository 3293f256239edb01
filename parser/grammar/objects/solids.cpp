#include "parser/grammar/core/rules.h"

#include <array>
#include <span>

/// Solids given by a few numbers: what stands between the keyword's brace and the first modifier.
namespace parser {
namespace {

struct SolidState : BlockState {
    SolidState(SceneBuilder& builder, scene::Object& made) : BlockState(builder), object(made) {}
    scene::Object& object;
};
/// Shorter distances between a cylinder's or cone's ends, and shorter normals of a plane, are errors (spec 5a, 5).
constexpr double kDegenerate = 1e-10;

/// Points that were found by asking an unsupported object are guesses: what they make is not the scene's fault.
void check_ends(SolidState& s, const glm::dvec3& base, glm::dvec3& cap, const char* message)
{
    if (glm::distance(base, cap) >= kDegenerate) return;
    if (!s.build.guessed) s.stream().fail(s.object.source, message);
    s.stream().warn(s.object.source, message);
    cap = base + glm::dvec3(0, 1, 0);
}

bool open_ends(SolidState& s) { return s.stream().accept(Kind::Open); }

struct center : seq<a_vector> {};
struct radius : seq<opt_comma, a_number> {};
struct sphere : seq<must<center>, must<radius>> {};
void make_sphere(SolidState& s)
{
    read_rule<sphere>(s.build, s);
    const double r = s.pop_float();
    s.object.shape = scene::Sphere{s.pop_vector(), r};
}

struct corner : seq<a_vector> {};
struct second_corner : seq<opt_comma, a_vector> {};
struct box : seq<must<corner>, must<second_corner>> {};
void make_box(SolidState& s)
{
    read_rule<box>(s.build, s);
    const glm::dvec3 b = s.pop_vector(), a = s.pop_vector();
    s.object.shape = scene::Box{glm::min(a, b), glm::max(a, b)};
}

struct plane_normal : seq<a_vector> {};
struct plane_distance : seq<opt_comma, a_number> {};
struct plane : seq<must<plane_normal>, must<plane_distance>> {};
void make_plane(SolidState& s)
{
    read_rule<plane>(s.build, s);
    const double distance = s.pop_float();
    const glm::dvec3 normal = s.pop_vector();
    if (glm::length(normal) < kDegenerate)
        s.stream().fail(s.object.source, "this plane's normal is zero, so it has no direction");
    s.object.shape = scene::Plane{glm::normalize(normal), distance};
}

struct end_point : seq<a_vector> {};
struct other_end : seq<opt_comma, a_vector> {};
struct cylinder : seq<must<end_point>, must<other_end>, must<radius>> {};
void make_cylinder(SolidState& s)
{
    read_rule<cylinder>(s.build, s);
    scene::Cylinder c;
    c.radius = s.pop_float();
    c.cap = s.pop_vector();
    c.base = s.pop_vector();
    c.open = open_ends(s);
    check_ends(s, c.base, c.cap, "this cylinder's ends are the same point");
    s.object.shape = c;
}

struct cone : seq<must<end_point>, must<radius>, must<other_end>, must<radius>> {};
void make_cone(SolidState& s)
{
    read_rule<cone>(s.build, s);
    scene::Cone c;
    c.cap_radius = s.pop_float();
    c.cap = s.pop_vector();
    c.base_radius = s.pop_float();
    c.base = s.pop_vector();
    c.open = open_ends(s);
    check_ends(s, c.base, c.cap, "this cone's ends are the same point");
    s.object.shape = c;
}

struct major_radius : seq<a_number> {};
struct minor_radius : seq<opt_comma, a_number> {};
struct torus : seq<must<major_radius>, must<minor_radius>> {};
void make_torus(SolidState& s)
{
    read_rule<torus>(s.build, s);
    const double minor = s.pop_float();
    s.object.shape = scene::Torus{s.pop_float(), minor};
}

struct square_terms : seq<a_vector> {};
struct mixed_terms : seq<opt_comma, a_vector> {};
struct linear_terms : seq<opt_comma, a_vector> {};
struct constant_term : seq<opt_comma, a_number> {};
struct quadric : seq<must<square_terms>, must<mixed_terms>, must<linear_terms>, must<constant_term>> {};
void make_quadric(SolidState& s)
{
    read_rule<quadric>(s.build, s);
    scene::Quadric q;
    q.constant = s.pop_float();
    q.linear = s.pop_vector();
    q.mixed = s.pop_vector();
    q.square = s.pop_vector();
    s.object.shape = q;
}

struct disc_normal : seq<opt_comma, a_vector> {};
struct disc : seq<must<center>, must<disc_normal>, must<radius>> {};
void make_disc(SolidState& s)
{
    read_rule<disc>(s.build, s);
    scene::Disc d;
    d.radius = s.pop_float();
    const glm::dvec3 normal = s.pop_vector();
    d.normal = glm::length(normal) > 0 ? glm::normalize(normal) : normal;
    d.center = s.pop_vector();
    s.stream().accept_comma();
    if (at_expression(s.stream())) d.hole = parser::float_expr(s.stream());
    s.object.shape = d;
}

struct vertex : seq<opt_comma, a_vector> {};
struct vertex_normal : seq<opt_comma, a_vector> {};
struct triangle : seq<must<vertex>, must<vertex>, must<vertex>> {};
struct smooth_triangle
    : seq<must<vertex>, must<vertex_normal>, must<vertex>, must<vertex_normal>, must<vertex>, must<vertex_normal>> {};
void make_triangle(SolidState& s)
{
    scene::Triangle t{};
    if (s.stream().peek().kind == Kind::Numbers) {
        const std::span<const double> v = s.stream().values_of(s.stream().next());
        for (std::size_t i = 0; i < 3; ++i) t.vertex[i] = {v[3 * i], v[3 * i + 1], v[3 * i + 2]};
    } else {
        read_rule<triangle>(s.build, s);
        for (std::size_t i = 3; i-- > 0;) t.vertex[i] = s.pop_vector();
    }
    if (glm::length(glm::cross(t.vertex[1] - t.vertex[0], t.vertex[2] - t.vertex[0])) == 0.0)
        s.stream().warn(s.object.source, "this triangle's corners lie on a line");
    s.object.shape = t;
}
void make_smooth_triangle(SolidState& s)
{
    scene::Triangle t{};
    const auto normals = std::make_shared<std::array<glm::dvec3, 3>>();
    if (s.stream().peek().kind == Kind::Numbers) {
        const std::span<const double> v = s.stream().values_of(s.stream().next());
        for (std::size_t i = 0; i < 3; ++i) {
            t.vertex[i] = {v[6 * i], v[6 * i + 1], v[6 * i + 2]};
            (*normals)[i] = {v[6 * i + 3], v[6 * i + 4], v[6 * i + 5]};
        }
    } else {
        read_rule<smooth_triangle>(s.build, s);
        for (std::size_t i = 3; i-- > 0;) {
            (*normals)[i] = s.pop_vector();
            t.vertex[i] = s.pop_vector();
        }
    }
    for (glm::dvec3& normal : *normals)
        if (glm::length(normal) > 0) normal = glm::normalize(normal);
    t.normal = normals;
    s.object.shape = t;
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
        SolidState s(build, object);
        kMakers[static_cast<std::size_t>(keyword)](s);
    }
    read_modifiers(build, object);
    build.close_block(name, opened);
}

}  // namespace parser
