#include "parser/grammar/objects/solid_shapes.h"

#include <array>
#include <memory>

/// Shapes of solids that are given by a few numbers.
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

constexpr SolidForm kForms[] = {
    {Kind::Sphere, "vn", false, set_sphere},      {Kind::Box, "vv", false, set_box},
    {Kind::Plane, "vn", false, set_plane},        {Kind::Cylinder, "vvn", true, set_cylinder},
    {Kind::Cone, "vnvn", true, set_cone},         {Kind::Torus, "nn", false, set_torus},
    {Kind::Quadric, "vvvn", false, set_quadric},  {Kind::Disc, "vvn", false, set_disc},
    {Kind::Triangle, "vvv", false, set_triangle}, {Kind::SmoothTriangle, "vvvvvv", false, set_smooth_triangle},
};

}  // namespace

const SolidForm* solid_form(Kind keyword)
{
    for (const SolidForm& form : kForms)
        if (form.keyword == keyword) return &form;
    return nullptr;
}

}  // namespace parser
