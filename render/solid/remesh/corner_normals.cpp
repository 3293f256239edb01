#include "render/solid/remesh/remesher.h"

#include <cmath>

namespace solid {
namespace {

constexpr double kBeside = 1e-3;     // of the way to the middle of a triangle: there the surface is that of its side
constexpr double kSameSide = 0.999;  // cosine: the normals there and at the vertex are of one side

}  // namespace

/// The surface's normal at a vertex, on the side that a triangle lies on.
glm::dvec3 Remesher::side_normal(Index v, Index f) const
{
    const glm::dvec3 x = mesh_.places[v], facing = mesh_.facing[f];
    const Foot foot = foot_of(body_, x + kBeside * (middle_of(f) - x), facing, longest_side(f));
    // What bends more from the triangle is another side: beside a corner it may be nearer.
    if (!foot.found || glm::dot(foot.at.normal, facing) < kSharpTurn) return facing;
    glm::dvec3 own = body_.normal(x, foot.end);
    if (glm::dot(own, foot.at.normal) < 0.0) own = -own;
    return glm::dot(own, foot.at.normal) > kSameSide ? own : foot.at.normal;
}

/// Normals of corners, by half-edge the number of the normal that its tail has there.
void Remesher::corner_normals(std::vector<glm::vec3>& normals, std::vector<Index>& of_corner) const
{
    struct Wanted {
        Index vertex, largest;
    };
    std::vector<Wanted> wanted;
    of_corner.assign(3 * mesh_.triangles(), HalfEdges::kNone);
    for (Index v = 0; v < mesh_.vertices(); ++v) {
        if (!mesh_.has_vertex(v)) continue;
        Index start = mesh_.first_out(v);
        mesh_.each_out(v, [&](Index h) {
            if (mesh_.is_sharp(h)) start = h;
        });
        double largest = -1.0;
        Index h = start;
        do {
            if (h == start || mesh_.is_sharp(h)) {
                wanted.push_back({v, h / 3});
                largest = -1.0;
            }
            const double area = glm::length(cross_at(h / 3));
            if (area > largest) {
                largest = area;
                wanted.back().largest = h / 3;
            }
            of_corner[h] = static_cast<Index>(wanted.size() - 1);
            h = mesh_.around(h);
        } while (h != start);
    }
    normals.resize(wanted.size());
    each(wanted.size(), [&](Index i) {
        const auto [v, f] = wanted[i];
        const glm::dvec3 known = normals_[v];
        normals[i] = glm::vec3(known != glm::dvec3(0.0) ? known : side_normal(v, f));
    });
}

TriangleMesh Remesher::result() const
{
    TriangleMesh out = mesh_.mesh();
    std::vector<Index> of_corner;
    corner_normals(out.normals, of_corner);
    for (Index f = 0; f < mesh_.triangles(); ++f)
        if (mesh_.has_triangle(f))
            out.normal_of.push_back({of_corner[3 * f], of_corner[3 * f + 1], of_corner[3 * f + 2]});
    return out;
}

}  // namespace solid
