#include "numbers/functions/functions.h"
#include "parser/grammar/scene/effects.h"
#include "parser/grammar/core/rules.h"
#include "parser/stream/functions/function.h"
#include "render/scene/last_bits.h"

#include <cmath>
#include <numbers>

namespace parser {
namespace {

using Kinds = scene::Camera::Kind;

struct CameraState : BlockState {
    CameraState(SceneBuilder& b, const scene::Camera& base) : BlockState(b), camera(base), old_right(base.right) {}
    scene::Camera& subject() { return camera; }
    scene::Camera camera;
    glm::dvec3 old_right;
    std::optional<glm::dvec3> look_at, focal_point;
    std::optional<double> angle;
    csg::Transform transform;
    double computed_focus = 0;  // length of direction as `angle` or `look_at` left it; 0: neither was written
    bool right_given = false, up_given = false, angle_written = false;
    bool fixed_order = true;  // version 3.5 and later; before, every item acts at once
};

constexpr double kEpsilon = 1e-10;  // POV-Ray's smallest length here (spec 2, 1)

/// The direction's length for a viewing angle; `up` never changes (spec 2, 3.2 step 2).
void apply_angle(CameraState& s, double angle)
{
    const double length = 0.5 * glm::length(s.camera.right) / numbers::tan(angle * std::numbers::pi / 360.0);
    const double old = glm::length(s.camera.direction);
    if (old > 0) s.camera.direction *= length / old;
    s.computed_focus = length;
}

/// Turns the camera to a point (spec 2, 3.3): only the lengths and the handedness of the old vectors survive.
void apply_look_at(CameraState& s, const glm::dvec3& target)
{
    scene::Camera& c = s.camera;
    const double d = glm::length(c.direction), r = glm::length(c.right), u = glm::length(c.up);
    const double hand = glm::dot(glm::cross(c.up, c.direction), c.right) > 0 ? 1.0 : -1.0;
    const glm::dvec3 to = target - c.location;
    if (glm::dot(to, to) < kEpsilon) s.stream().fail(c.source, "the camera's location and look_at are the same point");
    const scene::PovRay povray = s.stream().povray();
    const glm::dvec3 n = scene::unit(to, povray);
    glm::dvec3 q = glm::cross(c.sky, n);
    if (std::abs(q.x) < kEpsilon && std::abs(q.y) < kEpsilon && std::abs(q.z) < kEpsilon) {
        s.stream().warn(c.source, "the camera looks along its sky vector: the old right vector is used");
        q = c.right;
    }
    q = scene::unit(q, povray);
    c.direction = d * n;
    c.right = hand * r * q;
    c.up = u * glm::cross(n, q);
    s.computed_focus = d;
}

/// right and up grow with the distance to look_at (spec 2, 3.5).
void size_orthographic(CameraState& s)
{
    const double far = glm::length(s.look_at.value_or(glm::dvec3(0, 0, 1)) - s.camera.location);
    const double d = glm::length(s.camera.direction);
    if (far <= kEpsilon || d <= kEpsilon) return;
    s.camera.right *= far / d;
    s.camera.up *= far / d;
}

void transform_vectors(scene::Camera& c, const csg::Transform& t)
{
    c.location = t.point(c.location);
    c.direction = t.vector(c.direction);
    c.right = t.vector(c.right);
    c.up = t.vector(c.up);
}

template <Kinds kind>
void set_kind(CameraState& s)
{
    s.camera.kind = kind;
    if (kind == Kinds::Orthographic && !s.fixed_order) size_orthographic(s);
}
template <Kind word, Kinds kind>
struct camera_kind : item<word> {
    static void act(CameraState& s) { set_kind<kind>(s); }
};
struct cylinder_type : seq<a_number> {};
struct cylinder : item<Kind::Cylinder, cylinder_type> {
    static void act(CameraState& s)
    {
        set_kind<Kinds::Cylinder>(s);
        s.camera.cylinder_type = s.pop_int();
        if (s.camera.cylinder_type < 1 || s.camera.cylinder_type > 4)
            s.fail("the cylinder camera's type must be 1, 2, 3 or 4");
    }
};
struct mesh_camera : item<Kind::MeshCamera, reads<mesh_camera_block>> {
    static void act(CameraState& s)
    {
        set_kind<Kinds::Mesh>(s);
        s.camera.mesh = read_mesh_camera(s.build);
    }
};
/// Three functions in braces.
Production ray_functions()
{
    const Form one = Form::sequence({Form::named(function_value), form_of<opt_comma>()});
    return {"ray_functions", Form::braces({one, one, one})};
}
using Functions = std::array<function::FunctionPtr, 3>;
Functions read_ray_functions(CameraState& s, std::string_view name)
{
    const scene::SourceRef opened = s.build.open_block(name);
    Functions all;
    for (function::FunctionPtr& one : all) {
        if (s.stream().peek().kind != Kind::Function) s.stream().fail_expected("'function' and its body");
        one = read_function_value(s.stream());
        if (one->parameters > 3) s.fail("a camera's functions are of x and y");
        s.stream().accept_comma();
    }
    s.build.close_block(name, opened);
    return all;
}
/// A vector, or functions where the camera is user_defined: what comes last counts (spec 7c, 7).
template <Kind word, glm::dvec3 scene::Camera::*Vector, Functions scene::UserCamera::*ByFunction>
struct vector_or_functions : item<word, by_action<pegtl::sor<reads<ray_functions>, a_vector>>> {
    static void act(CameraState& s)
    {
        const bool functions = s.camera.kind == Kinds::UserDefined && s.stream().peek().kind == Kind::LeftBrace;
        if (functions || s.camera.functions) {
            auto by = std::make_shared<scene::UserCamera>();
            if (s.camera.functions) *by = *s.camera.functions;
            (*by).*ByFunction = functions ? read_ray_functions(s, spelling(word)) : Functions{};
            s.camera.functions = std::move(by);
        }
        if (functions) return;
        read_rule<a_vector>(s.build, s);
        s.camera.*Vector = s.pop_vector();
    }
};
struct up : item<Kind::Up, a_vector> {
    static void act(CameraState& s)
    {
        s.camera.up = s.pop_vector();
        s.up_given = true;
    }
};
struct right : item<Kind::Right, a_vector> {
    static void act(CameraState& s)
    {
        s.camera.right = s.pop_vector();
        s.right_given = true;
    }
};
struct look_at : item<Kind::LookAt, a_vector> {
    static void act(CameraState& s)
    {
        s.look_at = s.pop_vector();
        if (!s.fixed_order) apply_look_at(s, *s.look_at);
    }
};
struct angle : item<Kind::Angle, by_action<opt<a_number, another_number>>> {
    static void act(CameraState& s)
    {
        s.angle_written = true;
        const bool optional = s.camera.kind == Kinds::Orthographic;
        if (optional && !at_expression(s.stream())) return;
        read_rule<a_number>(s.build, s);
        const double a = s.pop_float();
        if (a < 0) s.fail("the camera's angle is negative");
        const bool flat = s.camera.kind == Kinds::Perspective || s.camera.kind == Kinds::Orthographic;
        if (flat && a >= 180) s.fail("the camera's angle must be below 180 degrees");
        s.angle = a;
        s.camera.angle_deg = a;
        if (s.camera.kind == Kinds::Spherical) {
            s.stream().accept_comma();
            s.camera.angle2_deg = a / 2;
            if (at_expression(s.stream())) {
                read_rule<a_number>(s.build, s);
                s.camera.angle2_deg = s.pop_float();
            }
        }
        if (!s.fixed_order && s.camera.kind == Kinds::Perspective && a > 0) apply_angle(s, a);
    }
};
struct blur_samples : item<Kind::BlurSamples, a_number, by_action<another_number>> {
    static void act(CameraState& s)
    {
        s.camera.blur_samples = s.pop_int();
        s.camera.blur_fewest = 0;
        if (s.camera.blur_samples <= 0) s.fail("blur_samples must be above 0");
        // `min, max`: the larger number is the limit.
        if (!s.fixed_order) return;
        s.stream().accept_comma();
        if (at_expression(s.stream())) {
            read_rule<a_number>(s.build, s);
            s.camera.blur_fewest = s.camera.blur_samples;
            s.camera.blur_samples = s.pop_int();
        }
    }
};
struct confidence : item<Kind::Confidence, a_number> {
    static void act(CameraState& s)
    {
        const double v = s.pop_float();
        if (v > 0 && v < 1) s.camera.confidence = v;
        else s.warn("confidence must lie between 0 and 1; the old value stays");
    }
};
struct variance : item<Kind::Variance, a_number> {
    static void act(CameraState& s)
    {
        const double v = s.pop_float();
        if (v >= 0 && v <= 1) s.camera.variance = v;
        else s.warn("variance must lie between 0 and 1; the old value stays");
    }
};
struct focal_point : item<Kind::FocalPoint, a_vector> {
    static void act(CameraState& s)
    {
        s.focal_point = s.pop_vector();
        if (!s.fixed_order) s.camera.focal_distance = glm::length(*s.focal_point - s.camera.location);
    }
};
struct bokeh : item<Kind::Bokeh, reads<bokeh_block>> {
    static void act(CameraState& s) { s.camera.bokeh = read_bokeh(s.build); }
};
struct normal : item<Kind::Normal, reads<normal_block>> {
    static void act(CameraState& s) { s.camera.normal = read_normal(s.build, nullptr); }
};

using scene::Camera;
using CameraKinds =
    table<CameraState, camera_kind<Kind::Perspective, Kinds::Perspective>,
          camera_kind<Kind::Orthographic, Kinds::Orthographic>, camera_kind<Kind::Fisheye, Kinds::Fisheye>,
          camera_kind<Kind::UltraWideAngle, Kinds::UltraWideAngle>, camera_kind<Kind::Omnimax, Kinds::Omnimax>,
          camera_kind<Kind::Panoramic, Kinds::Panoramic>, camera_kind<Kind::Spherical, Kinds::Spherical>,
          camera_kind<Kind::UserDefined, Kinds::UserDefined>, cylinder, mesh_camera>;
using CameraItems =
    table<CameraState, up, right, look_at, angle, blur_samples, confidence, variance, focal_point, bokeh, normal,
          vector_or_functions<Kind::Location, &Camera::location, &scene::UserCamera::location>,
          vector_or_functions<Kind::Direction, &Camera::direction, &scene::UserCamera::direction>,
          member<Kind::Sky, &Camera::sky>, member<Kind::Aperture, &Camera::aperture>>;

/// Transformations act after everything else, in version 3.5 and later; before, at once.
struct CameraModifiers {
    static bool match(SceneBuilder& build, CameraState& s)
    {
        if (const auto t = read_transformation(build)) {
            s.transform = *t * s.transform;
            if (!s.fixed_order) transform_vectors(s.camera, *t);
            return true;
        }
        if (!s.fixed_order && CameraKinds::match(build, s)) return true;
        return CameraItems::match(build, s);
    }
};

void finish_in_fixed_order(CameraState& s)
{
    const bool flat = s.camera.kind == Kinds::Perspective || s.camera.kind == Kinds::Orthographic;
    if (flat && s.angle.value_or(0) > 0) apply_angle(s, *s.angle);
    if (s.look_at) apply_look_at(s, *s.look_at);
    if (s.camera.kind == Kinds::Orthographic && ((!s.up_given && !s.right_given) || s.angle_written))
        size_orthographic(s);
    s.camera.focal_distance = s.computed_focus > 0 ? s.computed_focus : 1.0;
    if (s.focal_point) s.camera.focal_distance = glm::length(*s.focal_point - s.camera.location);
    if (s.camera.focal_distance == 0) s.camera.focal_distance = 1.0;
    transform_vectors(s.camera, s.transform);
}

}  // namespace

template <>
inline constexpr auto expected<cylinder_type> = "the cylinder camera's type, 1 to 4";

Production camera_block()
{
    return {"camera_block",
            Form::braces({Form::optional(Form::operand("identifier")), Form::repeated(CameraKinds::form()),
                          Form::repeated(either<moves, CameraItems>::form())})};
}

scene::Camera read_camera(SceneBuilder& build, const scene::Camera& base)
{
    TokenStream& stream = build.stream();
    CameraState s(build, base);
    s.camera.source = stream.last();
    s.fixed_order = build.version() >= 350;
    const scene::SourceRef opened = build.open_block("camera");
    bool declared = false;
    if (const auto other = stream.accept_identifier<std::shared_ptr<const scene::Camera>>()) {
        s.camera = **other;
        declared = true;
    }
    if (declared && s.fixed_order) {
        while (const auto t = read_transformation(build)) transform_vectors(s.camera, *t);
    } else {
        if (s.fixed_order)
            while (CameraKinds::match(build, s)) {}
        while (CameraModifiers::match(build, s)) {}
        if (s.fixed_order) finish_in_fixed_order(s);
        if (s.camera.kind == Kinds::UserDefined && s.camera.aperture != 0.0) {
            stream.warn(s.camera.source,
                        "a user_defined camera has no focal blur here; POV-Ray 3.8 shows the background alone");
            s.camera.aperture = 0.0;
        }
    }
    build.close_block("camera", opened);
    return s.camera;
}

}  // namespace parser
