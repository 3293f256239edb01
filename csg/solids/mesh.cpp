#include "csg/solids/mesh.h"

#include "csg/mesh/mesh_query.h"

#include <algorithm>

namespace csg {
namespace {

/// The faces that a ray meets, in order: at each it changes sides.
class MeshLine {
public:
    MeshLine(const Mesh& mesh, const Ray& ray) : mesh_(mesh), ray_(ray)
    {
        const Ray local = local_ray(mesh.frame, ray);
        mesh_crossings(*mesh.shape, local, -kInfinity, kInfinity, [&](double t, std::uint32_t face) {
            keep(t, face);
            return kInfinity;
        });
        const glm::dvec3 up = mesh.frame.inverse_vector(mesh.inside_vector);
        for (const auto& [a, b] : mesh.shape->open_edges()) meet_wall(local, a, b - a, up);
        std::sort(met_, met_ + count_,
                  [](const Met& a, const Met& b) { return a.t != b.t ? a.t < b.t : a.face < b.face; });
    }

    void spans(bool inverted, SpanList& out) const
    {
        const bool closed = mesh_.shape->open_edges().empty();
        // An odd number of faces of a closed mesh: rounding lost one at a corner. The middles of the intervals know
        // better.
        const bool doubtful = closed && count_ % 2 != 0;
        bool open = (!closed && inside_at_first()) != inverted;
        Crossing begin{.t = -kInfinity};
        for (std::uint32_t i = 0; i < count_; ++i) {
            const bool next = doubtful ? middle_inside(i) != inverted : !open;
            if (next == open) continue;
            const Crossing here{.t = met_[i].t, .face = met_[i].face};
            if (open) out.push({begin, here});
            begin = here;
            open = next;
        }
        if (open) out.push({begin, {.t = kInfinity}});
    }

private:
    struct Met {
        double t;
        std::uint32_t face;
    };

    void keep(double t, std::uint32_t face)
    {
        if (count_ < Mesh::kMostCrossings) met_[count_++] = {t, face};
    }

    /// The wall behind an edge: corner + u edge - s up with 0 <= u < 1 and 0 <= s.
    void meet_wall(const Ray& ray, const glm::dvec3& corner, const glm::dvec3& edge, const glm::dvec3& up)
    {
        const glm::dvec3 n = glm::cross(edge, up);
        const double t = glm::dot(corner - ray.origin, n) / glm::dot(ray.direction, n);
        const glm::dvec3 at = ray.at(t) - corner;
        const double u = glm::dot(glm::cross(at, up), n), s = -glm::dot(glm::cross(edge, at), n);
        if (u >= 0.0 && u < glm::dot(n, n) && s >= 0.0) keep(t, kUndrawnFace);
    }

    /// Whether the interval behind face i is inside.
    bool middle_inside(std::uint32_t i) const
    {
        return i + 1 < count_ && mesh_.contains(ray_.at(0.5 * (met_[i].t + met_[i + 1].t)));
    }

    /// Whether the ray comes from inside a mesh with holes.
    bool inside_at_first() const
    {
        const double before = count_ == 0 ? 0.0 : met_[0].t - (1.0 + std::abs(met_[0].t));
        return mesh_.contains(ray_.at(before));
    }

    const Mesh& mesh_;
    const Ray& ray_;
    Met met_[Mesh::kMostCrossings];
    std::uint32_t count_ = 0;
};

}  // namespace

void Mesh::spans(const Ray& ray, bool inverted, SpanList& out) const
{
    out.clear();
    if (solid()) MeshLine(*this, ray).spans(inverted, out);
}

std::uint32_t Mesh::most_crossings() const
{
    return static_cast<std::uint32_t>(
        std::min<std::size_t>(shape->triangles() + shape->open_edges().size(), kMostCrossings));
}

bool Mesh::holds(const glm::dvec3& p) const
{
    const Ray ray{frame.inverse_point(p), frame.inverse_vector(inside_vector)};
    // The range that POV-Ray counts in, in units of the mesh's space (spec 5b, 3.6).
    const double length = glm::length(ray.direction);
    if (!(length > 0.0)) return false;
    bool inside = false;
    const double farthest = 1e7 / length;
    mesh_crossings(*shape, ray, 1e-6 / length, farthest, [&](double, std::uint32_t) {
        inside = !inside;
        return farthest;
    });
    return inside;
}

glm::dvec3 Mesh::normal(const glm::dvec3& p, std::uint32_t face) const
{
    return unit_or_x(frame.normal(shape->normal(face, frame.inverse_point(p))));
}

Aabb Mesh::drawn_bounds() const
{
    if (shape->bounds().empty()) return {};
    return padded(frame.identity() ? shape->bounds() : transformed_box(frame, shape->bounds()));
}

Aabb Mesh::bounds() const { return solid() && !shape->open_edges().empty() ? Aabb::everything() : drawn_bounds(); }

}  // namespace csg
