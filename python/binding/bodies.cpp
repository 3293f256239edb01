#include "python/binding/bodies.h"

#include "python/binding/scene_bodies.h"
#include "render/app/solid/body_shapes.h"
#include "render/app/solid/part_file.h"
#include "render/solid/mesh/check.h"

#include <fmt/format.h>

namespace python {
namespace {

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

/// Of each vertex: the surface's normal there, on a sharp edge the mean of its sides'.
std::vector<glm::vec3> vertex_normals(const solid::TriangleMesh& mesh)
{
    std::vector<glm::vec3> normals(mesh.vertices.size(), glm::vec3(0));
    for (std::size_t i = 0; i < mesh.normal_of.size(); ++i)
        for (std::size_t corner = 0; corner < 3; ++corner)
            normals[mesh.triangles[i][corner]] += mesh.normals[mesh.normal_of[i][corner]];
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
            app::BodyMesh made = app::mesh_within(
                body, extent,
                app::refine_options(fineness.tolerance, fineness.cells, start, fineness.seconds, job.cancellation));
            out.mesh = std::move(made.mesh);
            app::color_of(*named.object, out.color);
            out.normals = vertex_normals(out.mesh);
            out.deviation = made.worst();
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
            app::BodySection cut = app::section_within(body, extent, beside,
                                                       app::refine_options(fineness.tolerance, solid::kContourCells,
                                                                           start, fineness.seconds, job.cancellation));
            out.loops = std::move(cut.loops);
            out.area = solid::area_of(out.loops);
            out.area_error = cut.off.area.error;
            out.deviation = cut.worst();
            out.problem = too_far(out.deviation, fineness.tolerance);
        });
    });
}

}  // namespace python
