#include "bench/numerics/forms.h"
#include "csg/freeform/freeform.h"

#include <cmath>

// Surfaces: every triangle, every edge.
namespace numerics {
namespace {

using csg::Transform;

WidePoint wide(const glm::dvec3& p) { return {p.x, p.y, p.z}; }
WidePoint minus(const WidePoint& a, const WidePoint& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Wide dot(const WidePoint& a, const WidePoint& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
WidePoint cross(const WidePoint& a, const WidePoint& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using Corners = std::array<glm::dvec3, 3>;

std::vector<Wide> met(const std::vector<Corners>& triangles, const WidePoint& from, const WidePoint& way)
{
    std::vector<Wide> all;
    for (const Corners& c : triangles) {
        const WidePoint a = minus(wide(c[0]), from), b = minus(wide(c[1]), from), d = minus(wide(c[2]), from);
        const Wide u = dot(way, cross(a, b)), v = dot(way, cross(b, d)), w = dot(way, cross(d, a));
        if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) || u + v + w == 0) continue;
        const WidePoint n = cross(minus(b, a), minus(d, a));
        all.push_back(dot(a, n) / dot(way, n));
    }
    return all;
}

/// A closed sphere of triangles with corners that single precision holds.
csg::MeshInput bumpy_sphere()
{
    constexpr int kRings = 8, kAround = 16;
    csg::MeshInput input;
    input.solid = true;
    const auto add = [&](double x, double y, double z) {
        input.vertices.push_back(glm::round(glm::dvec3(x, y, z) * 4096.0) / 4096.0);
    };
    add(0, 1, 0);
    for (int i = 1; i < kRings; ++i)
        for (int j = 0; j < kAround; ++j) {
            const double a = 3.14159265 * i / kRings, b = 6.2831853 * j / kAround,
                         r = 1.0 + 0.2 * std::sin(2.3 * i + 5.1 * j);
            add(r * std::sin(a) * std::cos(b), std::cos(a), r * std::sin(a) * std::sin(b));
        }
    add(0, -1, 0);
    const auto at = [&](int i, int j) {
        return static_cast<std::uint32_t>(i == 0        ? 0
                                          : i == kRings ? 1 + (kRings - 1) * kAround
                                                        : 1 + (i - 1) * kAround + j % kAround);
    };
    for (int i = 0; i < kRings; ++i)
        for (int j = 0; j < kAround; ++j) {
            if (i > 0) input.faces.push_back({.vertex = {at(i, j), at(i, j + 1), at(i + 1, j)}});
            if (i + 1 < kRings) input.faces.push_back({.vertex = {at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)}});
        }
    return input;
}

Form mesh_form()
{
    const csg::MeshInput input = bumpy_sphere();
    std::vector<Corners> triangles;
    for (const csg::MeshInput::Face& f : input.faces)
        triangles.push_back({input.vertices[f.vertex[0]], input.vertices[f.vertex[1]], input.vertices[f.vertex[2]]});
    const auto shape = std::make_shared<csg::MeshShape>(input);
    return {.name = "mesh",
            .make =
                [shape](const Transform& frame, double) {
                    csg::Mesh mesh;
                    mesh.shape = shape;
                    mesh.frame = frame;
                    mesh.surfaces = {0};
                    mesh.inside_vector = {0.31, 0.9, 0.17};
                    return csg::Solid(mesh);
                },
            .holds =
                [triangles](const WidePoint& p) {
                    int before = 0;
                    for (const Wide s : met(triangles, p, {0.217L, 0.83L, 0.411L})) before += s > 0 ? 1 : 0;
                    return before % 2 == 1;
                },
            .meets = [triangles](const WidePoint& from, const WidePoint& way) { return met(triangles, from, way); },
            .bar = 1e-13,
            .blur = 1e-6};  // nearer walls are not counted (spec 5b, 3.6)
}

Form patch_form()
{
    csg::BicubicPatch::Input input;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            input.points[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = {
                0.6 * (i - 1.5), 0.5 * std::sin(1.7 * i + 2.9 * j), 0.6 * (j - 1.5)};
    constexpr int kSteps = 3, kPieces = 1 << kSteps;
    input.u_steps = input.v_steps = kSteps;
    const auto point = [&](int u, int v) {
        const auto weight = [](int k, double t) {
            return (k == 1 || k == 2 ? 3.0 : 1.0) * std::pow(t, k) * std::pow(1.0 - t, 3 - k);
        };
        glm::dvec3 sum(0.0);
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                sum += weight(i, static_cast<double>(u) / kPieces) * weight(j, static_cast<double>(v) / kPieces) *
                       input.points[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        return sum;
    };
    std::vector<Corners> triangles;
    for (int u = 0; u < kPieces; ++u)
        for (int v = 0; v < kPieces; ++v) {
            triangles.push_back({point(u, v), point(u, v + 1), point(u + 1, v + 1)});
            triangles.push_back({point(u, v), point(u + 1, v + 1), point(u + 1, v)});
        }
    const auto shape = csg::make_freeform<csg::BicubicPatch>(input);
    // Corners are kept in single precision, as in a mesh; a ray along the border may see one patch and not the other.
    return {.name = "bicubic_patch",
            .make =
                [shape](const Transform& frame, double) {
                    return csg::Solid(csg::Freeform{shape, frame});
                },
            .meets = [triangles](const WidePoint& from, const WidePoint& way) { return met(triangles, from, way); },
            .bar = 1e-6,
            .band = 1e-5};
}

std::vector<Wide> plane_met(const WidePoint& from, const WidePoint& way, const std::function<bool(Wide, Wide)>& within)
{
    if (way.z == 0) return {};
    const Wide s = -from.z / way.z;
    return within(from.x + s * way.x, from.y + s * way.y) ? std::vector<Wide>{s} : std::vector<Wide>{};
}

Form polygon_form()
{
    const std::vector<glm::dvec3> corners{{-1, -1, 0},    {1, -0.8, 0},   {0.2, 0.1, 0},   {1, 1, 0},
                                          {-0.9, 0.9, 0}, {-1, -1, 0},    {-0.5, -0.4, 0}, {-0.1, -0.5, 0},
                                          {-0.3, 0.3, 0}, {-0.5, -0.4, 0}};
    const auto within = [corners](Wide x, Wide y) {
        bool odd = false;
        for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
            if (i == 5) continue;  // from one loop to the next
            const glm::dvec3 &a = corners[i], &b = corners[i + 1];
            if ((a.y > y) != (b.y > y) &&
                x < a.x + (y - a.y) / (static_cast<Wide>(b.y) - a.y) * (static_cast<Wide>(b.x) - a.x))
                odd = !odd;
        }
        return odd;
    };
    const auto shape = csg::make_freeform<csg::Polygon>(corners);
    return {.name = "polygon",
            .make =
                [shape](const Transform& frame, double) {
                    return csg::Solid(csg::Freeform{shape, frame});
                },
            .meets = [within](const WidePoint& from, const WidePoint& way) { return plane_met(from, way, within); },
            .bar = 1e-13};
}

Form disc_form()
{
    return {.name = "disc",
            .make =
                [](const Transform& frame, double) {
                    return csg::Solid(csg::Disc{1.2, 0.4, frame});
                },
            .meets =
                [](const WidePoint& from, const WidePoint& way) {
                    return plane_met(from, way, [](Wide x, Wide y) {
                        return x * x + y * y <= 1.2 * static_cast<Wide>(1.2) &&
                               x * x + y * y >= 0.4 * static_cast<Wide>(0.4);
                    });
                },
            .bar = 1e-13};
}

/// Kept in world space: what its corners are rounded to there is what is judged, by `crossings` of a triangle.
Form triangle_form(const std::string& name, bool smooth)
{
    return {.name = name,
            .make =
                [smooth](const Transform& frame, double) {
                    const std::array<glm::dvec3, 3> corners{
                        frame.point({-1, -0.7, 0.3}), frame.point({0.9, -0.5, -0.4}), frame.point({-0.2, 1, 0.1})};
                    if (!smooth) return csg::Solid(csg::Triangle::make(corners));
                    const glm::dvec3 flat =
                        glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
                    return csg::Solid(csg::Triangle::make(corners, {glm::normalize(flat + glm::dvec3(0.2, 0, 0)),
                                                                    glm::normalize(flat + glm::dvec3(0, 0.2, 0)),
                                                                    glm::normalize(flat + glm::dvec3(0, -0.1, 0.1))}));
                },
            .bar = 1e-13};
}

}  // namespace

std::vector<Form> surface_forms()
{
    return {disc_form(),
            triangle_form("triangle", false),
            triangle_form("smooth_triangle", true),
            polygon_form(),
            mesh_form(),
            patch_form()};
}

}  // namespace numerics
