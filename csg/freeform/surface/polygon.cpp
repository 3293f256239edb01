#include "csg/freeform/surface/polygon.h"

namespace csg {
namespace {

constexpr double kSame = 1e-10;      // corners apart, squared; a corner off the plane; a ray along it (spec 5b, 4)
constexpr double kLeastEdge = 1e-3;  // a thinner box is widened by this on both sides

}  // namespace

Polygon::Polygon(std::vector<glm::dvec3> corners)
{
    for (const glm::dvec3& p : corners) corner_box_.include(p);
    box_ = corner_box_;
    for (int k = 0; k < 3; ++k)
        if (box_.upper[k] - box_.lower[k] < kLeastEdge) {
            box_.lower[k] -= kLeastEdge;
            box_.upper[k] += kLeastEdge;
        }
    find_plane(corners);
}

void Polygon::find_plane(const std::vector<glm::dvec3>& corners)
{
    if (corners.empty()) return;
    origin_ = corners[0];
    std::size_t i = 1;
    const auto apart = [&](std::size_t k) { return glm::dot(corners[k] - origin_, corners[k] - origin_) > kSame; };
    while (i < corners.size() && !apart(i)) ++i;
    if (i == corners.size()) return;
    const glm::dvec3 u = corners[i++] - origin_;
    const auto aside = [&](std::size_t k) {
        const glm::dvec3 w = glm::cross(u, corners[k] - origin_);
        return glm::dot(w, w) > kSame;
    };
    while (i < corners.size() && !(apart(i) && aside(i))) ++i;
    if (i == corners.size()) return;
    const glm::dvec3 v = corners[i] - origin_, w = glm::cross(u, v);
    axes_ = glm::dmat3(glm::normalize(glm::cross(v, w)), glm::normalize(glm::cross(w, glm::cross(v, w))),
                       glm::normalize(w));
    std::vector<glm::dvec2> flat;
    for (const glm::dvec3& p : corners) {
        const glm::dvec3 local = glm::transpose(axes_) * (p - origin_);
        if (std::abs(local.z) > kSame) return;
        flat.emplace_back(local.x, local.y);
    }
    corners_ = std::move(flat);
}

bool Polygon::holds(const glm::dvec2& q) const
{
    bool inside = false;
    for (std::size_t first = 0; first < corners_.size();) {
        std::size_t i = first;
        do {
            const glm::dvec2 &a = corners_[i], &b = corners_[i + 1];
            const bool above_a = a.y >= q.y, above_b = b.y >= q.y;
            if (above_a != above_b && ((b.y - q.y) * (a.x - b.x) >= (b.x - q.x) * (a.y - b.y)) == above_b)
                inside = !inside;
        } while (++i + 1 < corners_.size() && corners_[i] != corners_[first]);
        first = i + 1;
    }
    return inside;
}

void Polygon::intersect(const Ray& ray, IntersectionList& out) const
{
    if (corners_.empty()) return;
    const glm::dvec3 o = glm::transpose(axes_) * (ray.origin - origin_), d = glm::transpose(axes_) * ray.direction;
    if (std::abs(d.z) < kSame * std::sqrt(glm::dot(d, d))) return;
    const double t = -o.z / d.z;
    if (holds({o.x + t * d.x, o.y + t * d.y})) out.touch(t, 0);
}

}  // namespace csg
