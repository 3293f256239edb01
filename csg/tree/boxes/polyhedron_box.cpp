#include "csg/tree/boxes/polyhedron_box.h"

#include <cmath>

namespace csg {

Aabb polyhedron_box(const std::vector<Plane>& planes, const Aabb& box)
{
    constexpr std::size_t kMostPlanes = 32;  // triples grow with the cube
    if (planes.size() < 2 || planes.size() > kMostPlanes) return box;
    double size = 0.0;
    for (const Plane& plane : planes) size = std::max(size, std::abs(plane.offset));
    for (int i = 0; i < 3; ++i)
        for (const double side : {box.lower[i], box.upper[i]})
            if (std::isfinite(side)) size = std::max(size, std::abs(side));
    if (!(size > 0.0)) size = 1.0;
    // Sides that are missing stand far out: a vertex there says that nothing nearer bounds it.
    const double far = 1e6 * size;
    std::vector<Plane> all = planes;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis(0.0);
        axis[i] = 1.0;
        all.push_back({axis, std::min(box.upper[i], far)});
        all.push_back({-axis, std::min(-box.lower[i], far)});
    }
    Aabb hull;
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = a + 1; b < all.size(); ++b) {
            // Of the line that two planes share: its direction, and what is the same for all planes that cut it.
            const glm::dvec3 along = glm::cross(all[a].normal_out, all[b].normal_out),
                             moment = all[b].offset * all[a].normal_out - all[a].offset * all[b].normal_out;
            for (std::size_t c = b + 1; c < all.size(); ++c) {
                const double determinant = glm::dot(along, all[c].normal_out);
                if (std::abs(determinant) < 1e-12) continue;  // of unit normals: no one point in common
                const glm::dvec3 vertex = (glm::cross(all[c].normal_out, moment) + all[c].offset * along) / determinant;
                // Generous: a vertex too many only widens the box.
                const double slack = (1e-9 + 1e-13 / std::abs(determinant)) * std::max(size, glm::length(vertex));
                bool inside = true;
                for (std::size_t k = 0; inside && k < all.size(); ++k)
                    inside = glm::dot(all[k].normal_out, vertex) - all[k].offset <= slack;
                if (inside) hull.include(vertex);
            }
        }
    if (hull.empty()) return box;  // empty or too thin to tell
    const double margin = 1e-8 * size;
    for (int i = 0; i < 3; ++i) {
        hull.lower[i] = hull.lower[i] < -0.5 * far ? box.lower[i] : std::max(hull.lower[i] - margin, box.lower[i]);
        hull.upper[i] = hull.upper[i] > 0.5 * far ? box.upper[i] : std::min(hull.upper[i] + margin, box.upper[i]);
    }
    return hull;
}

}  // namespace csg
