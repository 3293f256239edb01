#include "parser/grammar/objects/solids.h"
#include "parser/grammar/core/solid_reader.h"

#include <array>
#include <memory>

/// Solids given by a few numbers: what stands between the keyword's brace and the first modifier, and what it makes.
namespace parser {
namespace {

/// Shorter distances between a cylinder's or cone's ends, and shorter normals of a plane, are errors (spec 5a, 5).
constexpr double kDegenerate = 1e-10;

glm::dvec3 vector_at(const double* v) { return {v[0], v[1], v[2]}; }

bool set_sphere(const double* v, bool, scene::Object& object)
{
    object.shape = scene::Sphere{vector_at(v), v[3]};
    return true;
}

bool set_box(const double* v, bool, scene::Object& object)
{
    const glm::dvec3 a = vector_at(v), b = vector_at(v + 3);
    object.shape = scene::Box{glm::min(a, b), glm::max(a, b)};
    return true;
}

bool set_plane(const double* v, bool, scene::Object& object)
{
    const glm::dvec3 normal = vector_at(v);
    if (glm::length(normal) < kDegenerate) return false;
    object.shape = scene::Plane{glm::normalize(normal), v[3]};
    return true;
}

bool set_cylinder(const double* v, bool open, scene::Object& object)
{
    const scene::Cylinder made{vector_at(v), vector_at(v + 3), v[6], open};
    object.shape = made;
    return glm::distance(made.base, made.cap) >= kDegenerate;
}

bool set_cone(const double* v, bool open, scene::Object& object)
{
    const scene::Cone made{vector_at(v), v[3], vector_at(v + 4), v[7], open};
    object.shape = made;
    return glm::distance(made.base, made.cap) >= kDegenerate;
}

bool set_torus(const double* v, bool, scene::Object& object)
{
    object.shape = scene::Torus{v[0], v[1]};
    return true;
}

bool set_quadric(const double* v, bool, scene::Object& object)
{
    object.shape = scene::Shared(scene::Quadric{vector_at(v), vector_at(v + 3), vector_at(v + 6), v[9], {}});
    return true;
}

bool set_disc(const double* v, bool, scene::Object& object)
{
    const glm::dvec3 normal = vector_at(v + 3);
    object.shape = scene::Disc{vector_at(v), glm::length(normal) > 0 ? glm::normalize(normal) : normal, v[6], 0.0};
    return true;
}

bool set_triangle(const double* v, bool, scene::Object& object)
{
    scene::Triangle t{};
    for (std::size_t i = 0; i < 3; ++i) t.vertex[i] = vector_at(v + 3 * i);
    const bool line = glm::length(glm::cross(t.vertex[1] - t.vertex[0], t.vertex[2] - t.vertex[0])) == 0.0;
    object.shape = t;
    return !line;
}

bool set_smooth_triangle(const double* v, bool, scene::Object& object)
{
    scene::SmoothTriangle t{};
    for (std::size_t i = 0; i < 3; ++i) {
        t.vertex[i] = vector_at(v + 6 * i);
        const glm::dvec3 normal = vector_at(v + 6 * i + 3);
        t.normal[i] = glm::length(normal) > 0 ? glm::normalize(normal) : normal;
    }
    object.shape = scene::Shared(t);
    return true;
}

struct center : seq<a_vector> {};
struct radius : seq<opt_comma, a_number> {};
struct sphere : seq<must<center>, must<radius>> {};

struct corner : seq<a_vector> {};
struct second_corner : seq<opt_comma, a_vector> {};
struct box : seq<must<corner>, must<second_corner>> {};

struct plane_normal : seq<a_vector> {};
struct plane_distance : seq<opt_comma, a_number> {};
struct plane : seq<must<plane_normal>, must<plane_distance>> {};

struct end_point : seq<a_vector> {};
struct other_end : seq<opt_comma, a_vector> {};
struct cylinder : seq<must<end_point>, must<other_end>, must<radius>> {};
struct cone : seq<must<end_point>, must<radius>, must<other_end>, must<radius>> {};

struct major_radius : seq<a_number> {};
struct minor_radius : seq<opt_comma, a_number> {};
struct torus : seq<must<major_radius>, must<minor_radius>> {};

using spindle_word = any_token<Kind::Difference, Kind::Intersection, Kind::Merge, Kind::Union>;

struct square_terms : seq<a_vector> {};
struct mixed_terms : seq<opt_comma, a_vector> {};
struct linear_terms : seq<opt_comma, a_vector> {};
struct constant_term : seq<opt_comma, a_number> {};
struct quadric : seq<must<square_terms>, must<mixed_terms>, must<linear_terms>, must<constant_term>> {};

struct disc_normal : seq<opt_comma, a_vector> {};
struct disc : seq<must<center>, must<disc_normal>, must<radius>> {};

struct vertex : seq<opt_comma, a_vector> {};
struct vertex_normal : seq<opt_comma, a_vector> {};
struct triangle : seq<must<vertex>, must<vertex>, must<vertex>> {};
struct smooth_triangle
    : seq<must<vertex>, must<vertex_normal>, must<vertex>, must<vertex_normal>, must<vertex>, must<vertex_normal>> {};

}  // namespace

template <>
inline constexpr auto expected<center> = "the centre, as in <0, 1, 0>";
template <>
inline constexpr auto expected<radius> = "the radius (a number)";
template <>
inline constexpr auto expected<corner> = "the box's first corner, as in <-1, -1, -1>";
template <>
inline constexpr auto expected<second_corner> = "the box's second corner, as in <1, 1, 1>";
template <>
inline constexpr auto expected<plane_normal> = "the plane's normal, as in <0, 1, 0>";
template <>
inline constexpr auto expected<plane_distance> = "the plane's distance from the origin (a number)";
template <>
inline constexpr auto expected<end_point> = "the centre of the first end, as in <0, 0, 0>";
template <>
inline constexpr auto expected<other_end> = "the centre of the second end, as in <0, 1, 0>";
template <>
inline constexpr auto expected<major_radius> = "the torus's major radius (a number)";
template <>
inline constexpr auto expected<minor_radius> = "the torus's minor radius (a number)";
template <>
inline constexpr auto expected<square_terms> = "the quadric's x^2, y^2, z^2 coefficients, as in <1, 1, 1>";
template <>
inline constexpr auto expected<mixed_terms> = "the quadric's xy, xz, yz coefficients, as in <0, 0, 0>";
template <>
inline constexpr auto expected<linear_terms> = "the quadric's x, y, z coefficients, as in <0, 0, 0>";
template <>
inline constexpr auto expected<constant_term> = "the quadric's constant (a number)";
template <>
inline constexpr auto expected<disc_normal> = "the disc's normal, as in <0, 1, 0>";
template <>
inline constexpr auto expected<vertex> = "a corner of the triangle, as in <0, 1, 0>";
template <>
inline constexpr auto expected<vertex_normal> = "the normal at this corner, as in <0, 1, 0>";

namespace {

/// The values that a rule reads, in reading order, as SolidForm::values has them.
template <class Rule, class... Inner>
constexpr std::size_t add_kinds(char* to, std::size_t count, pegtl::type_list<Inner...>)
{
    if constexpr (std::is_same_v<typename Rule::rule_t, a_vector>) to[count++] = 'v';
    if constexpr (std::is_same_v<typename Rule::rule_t, a_number>) to[count++] = 'n';
    ((count = add_kinds<Inner>(to, count, typename Inner::subs_t{})), ...);
    return count;
}
template <class Rule>
struct ValueKinds {
    std::array<char, 6> kinds{};
    std::size_t count = add_kinds<Rule>(kinds.data(), 0, typename Rule::subs_t{});
};
template <class Rule>
inline constexpr ValueKinds<Rule> kValueKinds;

struct SolidState;
struct SolidEntry {
    SolidForm form;
    Form (*head)();
    bool (*read)(TokenInput&, SolidState&);
    /// Null: nothing follows, nothing is to be said. `good`: what SolidForm::set answered.
    void (*after)(SolidState&, bool good);
};

struct SolidState : BlockState {
    SolidState(SceneBuilder& builder, const SolidForm& read, scene::Object& made)
        : BlockState(builder), form(read), object(made)
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

void after_plane(SolidState& s, bool good)
{
    if (!good) s.stream().fail(s.object.source, "this plane's normal is zero, so it has no direction");
}

/// The ends are one point. Points that were found by asking an unsupported object are guesses: what they make is not
/// the scene's fault.
template <class Solid>
void after_ends(SolidState& s, bool good)
{
    if (good) return;
    const std::string message = "this " + std::string(spelling(s.form.keyword)) + "'s ends are the same point";
    if (!s.build.guessed) s.stream().fail(s.object.source, message);
    s.stream().warn(s.object.source, message);
    auto& made = std::get<Solid>(s.object.shape);
    made.cap = made.base + glm::dvec3(0, 1, 0);
}

/// What a torus that crosses itself is, if that is said or POV-Ray 3.8 draws it (spec 7c, 3).
void after_torus(SolidState& s, bool)
{
    using Spindle = scene::Torus::Spindle;
    auto& torus = std::get<scene::Torus>(s.object.shape);
    TokenStream& in = s.stream();
    const bool new_rules = in.povray() == scene::PovRay::V38;
    if (in.accept(Kind::Difference)) torus.spindle = Spindle::Difference;
    else if (in.accept(Kind::Intersection)) torus.spindle = Spindle::Intersection;
    else if (in.accept(Kind::Merge)) torus.spindle = Spindle::Merge;
    else if (in.accept(Kind::Union) || new_rules) torus.spindle = Spindle::Union;
    if (new_rules)
        for (double* const radius : {&torus.major, &torus.minor}) {
            if (!(*radius < 0.0)) continue;
            in.warn(s.object.source, "a negative radius inverts a torus in POV-Ray 3.8");
            *radius = -*radius;
            s.object.inverse = !s.object.inverse;
        }
    if (torus.spindle == Spindle::Intersection && !(torus.minor > torus.major))
        in.warn(s.object.source, "nothing is inside of this torus: it does not cross itself");
}

void after_disc(SolidState& s, bool)
{
    s.stream().accept_comma();
    if (at_expression(s.stream())) std::get<scene::Disc>(s.object.shape).hole = parser::float_expr(s.stream());
}

void after_triangle(SolidState& s, bool good)
{
    if (!good) s.stream().warn(s.object.source, "this triangle's corners lie on a line");
}

template <class Rule>
constexpr SolidEntry entry(Kind keyword, decltype(SolidForm::set) set, bool may_be_open = false,
                           decltype(SolidEntry::after) after = nullptr)
{
    constexpr const auto& values = kValueKinds<Rule>;
    return {{keyword, {values.kinds.data(), values.count}, may_be_open, set},
            form_of<Rule>,
            [](TokenInput& input, SolidState& s) { return pegtl::parse<Rule, action, control>(input, s); },
            after};
}
constexpr SolidEntry kSolids[] = {
    entry<sphere>(Kind::Sphere, set_sphere),
    entry<box>(Kind::Box, set_box),
    entry<plane>(Kind::Plane, set_plane, false, after_plane),
    entry<cylinder>(Kind::Cylinder, set_cylinder, true, after_ends<scene::Cylinder>),
    entry<cone>(Kind::Cone, set_cone, true, after_ends<scene::Cone>),
    entry<torus>(Kind::Torus, set_torus, false, after_torus),
    entry<quadric>(Kind::Quadric, set_quadric),
    entry<disc>(Kind::Disc, set_disc, false, after_disc),
    entry<triangle>(Kind::Triangle, set_triangle, false, after_triangle),
    entry<smooth_triangle>(Kind::SmoothTriangle, set_smooth_triangle),
};
constexpr auto kByKeyword = [] {
    std::array<const SolidEntry*, kKindCount> all{};
    for (const SolidEntry& one : kSolids) all[static_cast<std::size_t>(one.form.keyword)] = &one;
    return all;
}();

void read_values_of(const SolidEntry& solid, SceneBuilder& build, scene::Object& object)
{
    SolidState s(build, solid.form, object);
    TokenStream& in = build.stream();
    bool good = false;
    if (in.peek().kind == Kind::Numbers) {
        good = solid.form.set(in.values_of(in.next()).data(), false, object);
    } else {
        TokenInput input(in);
        solid.read(input, s);
        const auto values = s.values();
        good = solid.form.set(values.data(), solid.form.may_be_open && in.accept(Kind::Open), object);
    }
    if (solid.after) solid.after(s, good);
}

}  // namespace

std::vector<Form> solids_of_numbers()
{
    std::vector<Form> all;
    for (const SolidEntry& one : kSolids) {
        Form head = one.head();
        if (one.form.may_be_open) head = Form::sequence({std::move(head), form_of<opt<token<Kind::Open>>>()});
        if (one.form.keyword == Kind::Torus)
            head = Form::sequence({std::move(head), form_of<opt<spindle_word>>(), form_of<sturms>()});
        if (one.form.keyword == Kind::Disc)
            head = Form::sequence({std::move(head), form_of<opt_comma>(), form_of<opt<a_number>>()});
        all.push_back(solid_form(one.form.keyword, std::move(head)));
    }
    return all;
}

const SolidForm* solid_form(Kind keyword)
{
    const SolidEntry* const found = kByKeyword[static_cast<std::size_t>(keyword)];
    return found ? &found->form : nullptr;
}

bool is_solid(Kind keyword) { return solid_form(keyword) != nullptr; }

void read_solid(SceneBuilder& build, Kind keyword, scene::Object& object)
{
    object.source = build.stream().last();
    const std::string_view name = spelling(keyword);
    const scene::SourceRef opened = build.open_block(name);
    // `sphere { NAME ... }` is a copy of any declared object.
    if (const auto declared = build.stream().accept_identifier<std::shared_ptr<const scene::Object>>())
        object = **declared;
    else read_values_of(*kByKeyword[static_cast<std::size_t>(keyword)], build, object);
    read_modifiers(build, object);
    build.close_block(name, opened);
}

}  // namespace parser
