#include "render/app/views/view_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace app {
namespace {

using Kind = scene::Camera::Kind;

const char* word_of(const scene::Camera& camera)
{
    switch (camera.kind) {
    case Kind::Perspective: return "perspective";
    case Kind::Orthographic: return "orthographic";
    case Kind::Fisheye: return "fisheye";
    case Kind::UltraWideAngle: return "ultra_wide_angle";
    case Kind::Omnimax: return "omnimax";
    case Kind::Panoramic: return "panoramic";
    case Kind::Cylinder: return "cylinder";
    case Kind::Spherical: return "spherical";
    case Kind::Mesh:
    case Kind::UserDefined: break;
    }
    throw OptionError("--views cannot turn the scene's camera: its rays are those of a mesh or of functions");
}

}  // namespace

std::string vector_in_text(const glm::dvec3& v) { return fmt::format("<{}, {}, {}>", v.x, v.y, v.z); }

std::string camera_statement(const scene::Camera& camera)
{
    if (camera.normal || camera.bokeh)
        throw OptionError("--views cannot turn the scene's camera: it has a normal or a bokeh");
    std::string text = fmt::format("camera {{\n  {}", word_of(camera));
    if (camera.kind == Kind::Cylinder) text += fmt::format(" {}", camera.cylinder_type);
    for (const auto& [name, vector] : {std::pair{"location", &camera.location},
                                       {"sky", &camera.sky},
                                       {"direction", &camera.direction},
                                       {"right", &camera.right},
                                       {"up", &camera.up}})
        text += fmt::format("\n  {} {}", name, vector_in_text(*vector));
    const bool flat = camera.kind == Kind::Perspective || camera.kind == Kind::Orthographic;
    if (!flat && camera.angle_deg > 0.0) {  // of the flat ones the vectors hold it
        text += fmt::format("\n  angle {}", camera.angle_deg);
        if (camera.kind == Kind::Spherical) text += fmt::format(", {}", camera.angle2_deg);
    }
    if (camera.aperture != 0.0 && camera.blur_samples > 0) {
        const glm::dvec3 ahead = glm::normalize(camera.direction);
        text += fmt::format("\n  aperture {}\n  focal_point {}", camera.aperture,
                            vector_in_text(camera.location + camera.focal_distance * ahead));
        if (camera.blur_fewest > 0)
            text += fmt::format("\n  blur_samples {}, {}", camera.blur_fewest, camera.blur_samples);
        else text += fmt::format("\n  blur_samples {}", camera.blur_samples);
        text += fmt::format("\n  confidence {}\n  variance {}", camera.confidence, camera.variance);
    }
    return text + "\n}\n";
}

}  // namespace app
