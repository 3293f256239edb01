#include "render/kernel/path/lamp_faces.h"

#include "render/light/illuminate.h"
#include "render/kernel/tile/nearly_zero.h"

#include <algorithm>
#include <cmath>

namespace trace::path {
namespace {

/// A face whose places each shine to all sides. A light that turns to what it lights has no face of its own.
bool has_face(const light::Light& light)
{
    return light.area && light.size1 > 1 && light.size2 > 1 && !light.parallel && !light.shadowless && !light.orient &&
           light.projector == nullptr && light.kind != light::Light::Kind::Cylinder;
}

}  // namespace

LampFaces::LampFaces(const light::LightSet* lights)
{
    if (lights == nullptr) return;
    for (const light::Light& light : lights->lights) {
        if (!has_face(light) || black(light.color)) continue;
        const glm::dvec3 across = glm::cross(light.axis1, light.axis2);
        const double area = glm::length(across);
        if (!(area > 0.0)) continue;
        // place_on() goes half a cell beyond the nodes at both ends.
        const auto half = [](int size) { return 0.5 * size / (size - 1); };
        Face face{};
        face.light = &light;
        face.normal = across / area;
        face.along1 = glm::cross(light.axis2, face.normal) / area;
        face.along2 = glm::cross(face.normal, light.axis1) / area;
        face.half1 = half(light.size1);
        face.half2 = half(light.size2);
        face.area = 4.0 * face.half1 * face.half2 * area;
        faces_.push_back(face);
    }
}

bool LampFaces::has(const light::Light& light) const
{
    return std::any_of(faces_.begin(), faces_.end(), [&](const Face& face) { return face.light == &light; });
}

double LampFaces::Face::density(const glm::dvec3& place) const
{
    const glm::dvec3 off = place - light->location;
    double p = glm::dot(off, along1), q = glm::dot(off, along2), share = 1.0;
    if (light->circular) {
        // Squares around the middle have become circles: back, and by how much that has packed them (node_offset()).
        const double length = std::sqrt(p * p + q * q), most = std::max(std::abs(p), std::abs(q));
        if (most > 0.0) {
            p *= length / most;
            q *= length / most;
            share = length * length / (most * most);
        }
        p -= light::kCircleShift;
        q -= light::kCircleShift;
    }
    return std::abs(p) <= half1 && std::abs(q) <= half2 ? share / area : 0.0;
}

/// A surface gets pi C f(r) cos from a lamp at the distance r, whatever way the light came; from a face the mean over
/// its places, which is that of this radiance over the solid angle it fills.
glm::vec3 LampFaces::radiance(const Face& face, const csg::Ray& ray, double t, double way, double density)
{
    const double r = way + t;
    const light::Illumination lit{ray.direction, r, {}};
    return light::color_at(*face.light, lit, ray.origin) * static_cast<float>(kPi * r * r * density);
}

}  // namespace trace::path
