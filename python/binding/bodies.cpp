#include "python/binding/bodies.h"

#include "python/binding/scene_bodies.h"
#include "render/app/solid/part_file.h"
#include "render/solid/mesh/check.h"
#include "render/solid/mesh/deviation.h"
#include "render/solid/mesh/mesher.h"
#include "render/solid/section/contour.h"
#include "render/solid/section/section_check.h"

#include <fmt/format.h>

namespace python {
namespace {

constexpr std::size_t kDeviationSamples = 60'000;
constexpr int kMostCells = 128, kMostCutCells = 1024;
constexpr double kStraight = 0.02;  // of the tolerance: points as near to a line between others are left out

/// What `tell` says of each object; what is no body says why.
template <class What, class Tell>
std::vector<What> of_each(const SceneBodies& bodies, const Tell& tell)
{
    std::vector<What> out;
    for (const SceneBodies::Named& named : bodies.objects()) {
        out.emplace_back();
        out.back().name = named.name;
        try {
            tell(named, bodies.body(named), out.back());
        } catch (const solid::NoBody& why) {
            out.back().problem = why.what();
        }
    }
    return out;
}

/// The mean of the faces about each vertex, by their size.
std::vector<glm::vec3> normals_of(const solid::TriangleMesh& mesh)
{
    std::vector<glm::vec3> normals(mesh.vertices.size(), glm::vec3(0));
    for (const auto& t : mesh.triangles) {
        const glm::vec3 a = mesh.vertices[t[0]], twice = glm::cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a);
        for (const std::uint32_t corner : t) normals[corner] += twice;
    }
    for (glm::vec3& n : normals)
        if (const float length = glm::length(n); length > 0.0f) n /= length;
    return normals;
}

std::string too_far(double off, double tolerance)
{
    return off <= tolerance ? "" : fmt::format("it is off by {:.3g} somewhere, more than {:g}", off, tolerance);
}

}  // namespace

std::vector<ToldMeasures> measure(const std::shared_ptr<Source>& source, const Asked& asked, double precision)
{
    return result_of<std::vector<ToldMeasures>>([source, asked, precision](Job& job) {
        const SceneBodies bodies(*source, asked, job.cancel);
        return of_each<ToldMeasures>(bodies,
                                     [&](const SceneBodies::Named&, const solid::Body& body, ToldMeasures& out) {
                                         solid::MeasureOptions options;
                                         options.precision = precision;
                                         options.cancel = &job.cancel;
                                         out.measures = solid::measure(body, options);
                                     });
    });
}

std::vector<ToldMesh> mesh(const std::shared_ptr<Source>& source, const Asked& asked, const Fineness& fineness)
{
    return result_of<std::vector<ToldMesh>>([source, asked, fineness](Job& job) {
        const SceneBodies bodies(*source, asked, job.cancel);
        return of_each<ToldMesh>(bodies, [&](const SceneBodies::Named& named, const solid::Body& body, ToldMesh& out) {
            const auto start = app::PartClock::now();
            double error = 0.0;
            std::uint64_t rays = 0;
            const csg::Aabb extent = solid::require_extent(body, error, rays);
            solid::RefineOptions options =
                app::refine_options(fineness.tolerance, fineness.cells, start, fineness.seconds, job.cancellation);
            solid::MeshFacts facts;
            solid::Deviation off;
            app::make_finer(options, kMostCells, facts, [&](const solid::RefineOptions& now) {
                out.mesh = solid::mesh_of(body, extent, now, facts);
                off = solid::deviation(body, extent, out.mesh, kDeviationSamples, now.tolerance, now.cancel);
                return off.from_body;
            });
            app::color_of(*named.object, out.color);
            out.normals = normals_of(out.mesh);
            out.deviation = std::max(off.from_mesh, off.from_body);
            out.problem = solid::check(out.mesh).complaint();
            if (out.problem.empty()) out.problem = too_far(out.deviation, fineness.tolerance);
        });
    });
}

std::vector<ToldSection> section(const std::shared_ptr<Source>& source, const Asked& asked,
                                 const solid::CuttingPlane& plane, const Fineness& fineness)
{
    return result_of<std::vector<ToldSection>>([source, asked, plane, fineness](Job& job) {
        const SceneBodies bodies(*source, asked, job.cancel);
        return of_each<ToldSection>(bodies, [&](const SceneBodies::Named&, const solid::Body& body, ToldSection& out) {
            const auto start = app::PartClock::now();
            double error = 0.0;
            std::uint64_t rays = 0;
            const csg::Aabb extent = solid::require_extent(body, error, rays);
            if (plane.value < extent.lower[plane.axis] - error || plane.value > extent.upper[plane.axis] + error)
                return;
            const solid::CuttingPlane beside = solid::beside_faces(body, extent, plane);
            solid::RefineOptions options = app::refine_options(fineness.tolerance, solid::kContourCells, start,
                                                               fineness.seconds, job.cancellation);
            solid::RefineFacts facts;
            solid::SectionCheck off;
            app::make_finer(options, kMostCutCells, facts, [&](const solid::RefineOptions& now) {
                out.loops = solid::without_straight_points(solid::contour_of(body, extent, beside, now, facts),
                                                           kStraight * now.tolerance);
                off = solid::check_section(body, extent, beside, out.loops, now.tolerance, now.cancel);
                return off.from_body;
            });
            out.area = solid::area_of(out.loops);
            out.area_error = off.area.error;
            out.deviation = std::max(off.from_loops, off.from_body);
            out.problem = too_far(out.deviation, fineness.tolerance);
        });
    });
}

}  // namespace python
