#include "render/lint/findings.h"
#include "render/lint/walk.h"
#include "render/scene/solids.h"

#include <fmt/format.h>

namespace lint {
namespace {

/// A radius and what a message calls it.
struct Radius {
    const char* name;
    double value;
};

std::vector<Radius> radii_of(const scene::Object& object)
{
    std::vector<Radius> out;
    if (const auto* s = std::get_if<scene::Sphere>(&object.shape)) out = {{"radius", s->radius}};
    else if (const auto* c = std::get_if<scene::Cylinder>(&object.shape)) out = {{"radius", c->radius}};
    else if (const auto* k = std::get_if<scene::Cone>(&object.shape))
        out = {{"base radius", k->base_radius}, {"cap radius", k->cap_radius}};
    else if (const auto* t = std::get_if<scene::Torus>(&object.shape))
        out = {{"major radius", t->major}, {"minor radius", t->minor}};
    else if (const auto* d = std::get_if<scene::Disc>(&object.shape)) out = {{"radius", d->radius}, {"hole", d->hole}};
    if (object.details->written)
        if (const auto* sweep = std::get_if<scene::SphereSweep>(&object.details->written->parameters))
            for (const auto& sphere : sweep->spheres) out.push_back({"radius of a sphere", sphere.radius});
    return out;
}

/// Why nothing is to be seen of it; empty: something is.
std::string why_empty(const scene::Object& object)
{
    if (const auto* box = std::get_if<scene::Box>(&object.shape)) {
        // A box that is flat in one direction is drawn, as a rectangle.
        const auto same = glm::equal(box->lower, box->upper);
        if (same.x + same.y + same.z > 1) return "its corners differ along one axis at most";
        return {};
    }
    if (const auto* cylinder = std::get_if<scene::Cylinder>(&object.shape))
        if (cylinder->base == cylinder->cap) return "both ends are the same point";
    if (const auto* cone = std::get_if<scene::Cone>(&object.shape)) {
        if (cone->base == cone->cap) return "both ends are the same point";
        return cone->base_radius == 0 && cone->cap_radius == 0 ? "both radii are 0" : "";
    }
    if (const auto* torus = std::get_if<scene::Torus>(&object.shape))
        return torus->minor == 0 ? "the minor radius is 0" : "";
    if (const auto* disc = std::get_if<scene::Disc>(&object.shape))
        return disc->radius == 0            ? "the radius is 0"
               : disc->hole >= disc->radius ? "the hole is as wide as the disc"
                                            : "";
    for (const Radius& radius : radii_of(object))
        if (radius.value == 0 && !object.details->written) return fmt::format("the {} is 0", radius.name);
    return {};
}

void check_mesh(Findings& out, const scene::Object& object)
{
    const auto* mesh = std::get_if<scene::Mesh>(&object.shape);
    if (!mesh || !mesh->data) return;
    std::size_t flat = 0, first = 0;
    const scene::MeshData& data = *mesh->data;
    for (std::size_t i = 0; i < data.faces.size(); ++i) {
        const auto& v = data.faces[i].vertex;
        if (v[0] >= data.vertices.size() || v[1] >= data.vertices.size() || v[2] >= data.vertices.size()) continue;
        const glm::dvec3 a = data.vertices[v[1]] - data.vertices[v[0]], b = data.vertices[v[2]] - data.vertices[v[0]];
        constexpr double kFlat = 1e-12;  // of the product of two edges: the angle between them
        if (glm::length(glm::cross(a, b)) > kFlat * glm::length(a) * glm::length(b)) continue;
        if (flat++ == 0) first = i;
    }
    if (flat > 0)
        out.add("flat-triangle", object.source,
                fmt::format("{} of {} triangles of this mesh {} corners on a line, the first is number {}", flat,
                            data.faces.size(), flat == 1 ? "has its" : "have their", first));
}

}  // namespace

void check_sizes(Findings& out, const scene::Description& description)
{
    walk(description, [&](const Visited& at) {
        const std::string_view name = name_of(at.object);
        for (const Radius& radius : radii_of(at.object))
            if (radius.value < 0)
                out.add("negative-size", at.object.source,
                        fmt::format("the {} of this {} is negative: {:g}", radius.name, name, radius.value));
        const std::string why = why_empty(at.object);
        if (!why.empty()) out.add("zero-size", at.object.source, fmt::format("this {} has no extent: {}", name, why));
        if (out.wants("flat-triangle")) check_mesh(out, at.object);
    });
}

}  // namespace lint
