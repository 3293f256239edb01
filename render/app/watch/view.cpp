#include "render/app/watch/view.h"

#include "numbers/functions/functions.h"
#include "render/scene/inside.h"

#include <fmt/format.h>

#include <algorithm>

namespace app {
namespace {

constexpr double kSteepest = 89.0;  // degrees from the horizon: beyond, up and down change places

glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double degrees)
{
    const double angle = glm::radians(degrees), c = numbers::cos(angle), s = numbers::sin(angle);
    return c * v + s * glm::cross(axis, v) + (1.0 - c) * glm::dot(axis, v) * axis;
}

std::string vector_text(const glm::dvec3& v) { return fmt::format("<{:.9g}, {:.9g}, {:.9g}>", v.x, v.y, v.z); }

bool holds_light(const scene::Object& object)
{
    if (is_light(object)) return true;
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    return csg != nullptr && std::any_of(csg->operands->begin(), csg->operands->end(), holds_light);
}

/// Whether a half space can be taken away from it; what is a surface alone is clipped.
bool is_solid(const scene::Object& object)
{
    if (const auto* csg = std::get_if<scene::Csg>(&object.shape)) return csg->has_inside;
    return !scene::is_patch(object) && !std::holds_alternative<scene::Disc>(object.shape);
}

/// Not without its half space in the object's own space: `to_own` leads there.
scene::Object half_space(const glm::dvec3& normal, double offset, const csg::Transform& to_own)
{
    scene::Object plane;
    plane.shape = scene::Plane{normal, offset};
    plane.transform = to_own;
    return plane;
}

scene::Object opened(const scene::Object& object, const View::Cut& cut, const csg::Transform& to_own)
{
    if (is_light(object)) return object;
    const auto* csg = std::get_if<scene::Csg>(&object.shape);
    if (csg != nullptr && csg->op == scene::CsgOp::Union && (csg->light_group || holds_light(object))) {
        scene::Object out = object;  // its lights go on to shine
        auto operands = std::make_shared<std::vector<scene::Object>>();
        for (const scene::Object& operand : *csg->operands)
            operands->push_back(opened(operand, cut, object.transform->inverted() * to_own));
        std::get<scene::Csg>(out.shape).operands = std::move(operands);
        return out;
    }
    if (!is_solid(object)) {
        scene::Object out = object;
        out.details.edit().clipped_by.push_back(half_space(cut.normal, cut.offset, to_own));
        return out;
    }
    scene::Object out;
    out.texture = object.texture;
    out.details.edit().interior = object.details->interior;
    out.details.edit().interior_texture = object.details->interior_texture;
    out.source = object.source;
    out.default_texture = object.default_texture;
    out.flags = object.flags;
    scene::Csg whole;
    whole.op = scene::CsgOp::Difference;
    whole.cutaway_textures = true;  // the face of the cut looks as the solid does
    whole.operands =
        std::make_shared<std::vector<scene::Object>>(std::vector{object, half_space(-cut.normal, -cut.offset, to_own)});
    out.shape = std::move(whole);
    return out;
}

}  // namespace

scene::Camera moved(const scene::Camera& camera, const View::Orbit& orbit, double distance)
{
    scene::Camera out = camera;
    const double length = glm::length(camera.direction);
    if (length == 0.0 || glm::length(camera.sky) == 0.0) return out;
    const glm::dvec3 sky = glm::normalize(camera.sky), ahead = camera.direction / length;
    const glm::dvec3 pivot = camera.location + distance * ahead;
    const glm::dvec3 side = glm::length(camera.right) > 0.0 ? glm::normalize(camera.right) : glm::dvec3(1, 0, 0);
    const double height = glm::degrees(numbers::asin(std::clamp(glm::dot(-ahead, sky), -1.0, 1.0)));
    const double pitch = std::clamp(orbit.pitch_deg, std::min(0.0, -kSteepest - height),
                                    std::max(0.0, kSteepest - height));  // of the eye above the pivot
    // The sign that lifts the eye for either hand of the coordinates.
    const double lifts = glm::dot(turned(-ahead, side, 1.0), sky) > glm::dot(-ahead, sky) ? 1.0 : -1.0;
    const auto turn = [&](const glm::dvec3& v) { return turned(turned(v, side, lifts * pitch), sky, orbit.yaw_deg); };
    out.direction = turn(camera.direction);
    out.right = turn(camera.right);
    out.up = turn(camera.up);
    out.location = pivot + orbit.dolly * turn(camera.location - pivot);
    const bool flat = camera.kind == scene::Camera::Kind::Orthographic;
    if (flat) {
        out.right *= orbit.dolly;
        out.up *= orbit.dolly;
    }
    const double wide = flat ? 1.0 : orbit.dolly * distance / length;
    out.location += wide * (orbit.right * out.right + orbit.up * out.up);
    return out;
}

std::string camera_text(const scene::Camera& camera)
{
    using Kind = scene::Camera::Kind;
    std::string out = "camera {\n";
    switch (camera.kind) {
    case Kind::Perspective: break;
    case Kind::Orthographic: out += "  orthographic\n"; break;
    case Kind::Fisheye: out += "  fisheye\n"; break;
    case Kind::UltraWideAngle: out += "  ultra_wide_angle\n"; break;
    case Kind::Omnimax: out += "  omnimax\n"; break;
    case Kind::Panoramic: out += "  panoramic\n"; break;
    case Kind::Cylinder: out += fmt::format("  cylinder {}\n", camera.cylinder_type); break;
    case Kind::Spherical: out += "  spherical\n"; break;
    case Kind::Mesh: out += "  // a mesh_camera: its rays are the mesh's\n"; break;
    case Kind::UserDefined: out += "  user_defined  // and its functions, as the scene has them\n"; break;
    }
    out += "  location " + vector_text(camera.location) + "\n";
    out += "  direction " + vector_text(camera.direction) + "\n";
    out += "  right " + vector_text(camera.right) + "\n";
    out += "  up " + vector_text(camera.up) + "\n";
    out += "  sky " + vector_text(camera.sky) + "\n";
    if (camera.kind != Kind::Perspective && camera.kind != Kind::Orthographic && camera.angle_deg != 0.0) {
        out += fmt::format("  angle {:.9g}", camera.angle_deg);
        out += camera.kind == Kind::Spherical && camera.angle2_deg != 0.0 ? fmt::format(", {:.9g}\n", camera.angle2_deg)
                                                                          : "\n";
    }
    if (camera.aperture > 0.0) {
        const double length = glm::length(camera.direction);
        const glm::dvec3 sharp = camera.location +
                                 (length > 0.0 ? camera.focal_distance / length : 0.0) * camera.direction;
        out += fmt::format("  aperture {:.9g} blur_samples {} confidence {:.9g} variance {:.9g}\n  focal_point {}\n",
                           camera.aperture, camera.blur_samples, camera.confidence, camera.variance,
                           vector_text(sharp));
    }
    if (camera.normal) out += "  // and its normal, as the scene has it\n";
    if (camera.bokeh) out += "  // and its bokeh, as the scene has it\n";
    return out + "}\n";
}

void cut_open(scene::Description& description, const View::Cut& cut)
{
    scene::ObjectList open;
    for (const scene::Object& object : description.objects) open.push_back(opened(object, cut, {}));
    description.objects = std::move(open);
}

}  // namespace app
