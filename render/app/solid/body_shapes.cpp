#include "render/app/solid/body_shapes.h"

#include "render/solid/remesh/remesh.h"

#include <algorithm>

namespace app {
namespace {

constexpr std::size_t kSamples = 60'000;
constexpr double kStraight = 0.02;  // of the tolerance: points as near to a line between others are left out

/// Makes a part again with twice as many cells, up to `most_cells`, until no place of the object is farther from it
/// than the tolerance: a coarse lattice may overlook something narrow. `make` is given the options, sets `facts`, and
/// returns how far the object is off the part.
template <class Facts, class Make>
void make_finer(solid::RefineOptions& options, int most_cells, Facts& facts, const Make& make)
{
    for (;; options.cells = std::min(2 * options.cells, most_cells)) {
        facts = {};
        const double off = make(options);
        if (off <= options.tolerance || facts.full || facts.late || options.cells >= most_cells) return;
    }
}

}  // namespace

double BodyMesh::worst() const { return std::max(off.from_mesh, off.from_body); }
double BodySection::worst() const { return std::max(off.from_loops, off.from_body); }

BodyMesh mesh_within(const solid::Body& body, const csg::Aabb& extent, solid::RefineOptions options)
{
    BodyMesh out;
    make_finer(options, kMostCells, out.facts, [&](const solid::RefineOptions& now) {
        out.mesh = solid::good_mesh_of(body, extent, now, out.facts, [&](const solid::TriangleMesh& made) {
            out.off = solid::deviation(body, extent, made, kSamples, now.tolerance, now.cancel);
            return out.worst() <= now.tolerance;
        });
        return out.off.from_body;
    });
    out.cells = options.cells;
    return out;
}

BodySection section_within(const solid::Body& body, const csg::Aabb& extent, const solid::CuttingPlane& plane,
                           solid::RefineOptions options)
{
    BodySection out;
    make_finer(options, kMostCutCells, out.facts, [&](const solid::RefineOptions& now) {
        out.loops = solid::without_straight_points(solid::contour_of(body, extent, plane, now, out.facts),
                                                   kStraight * now.tolerance);
        out.off = solid::check_section(body, extent, plane, out.loops, now.tolerance, now.cancel);
        return out.off.from_body;
    });
    out.cells = options.cells;
    return out;
}

}  // namespace app
