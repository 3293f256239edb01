#include "csg/freeform/surface/polygon.h"

#include <algorithm>
#include <cmath>

namespace csg {
namespace {

constexpr double kSame = 1e-10;      // corners apart, squared; a corner off the plane; a ray along it (spec 5b, 4)
constexpr double kLeastEdge = 1e-3;  // a thinner box is widened by this on both sides
constexpr std::size_t kMostBands = 256, kMostPlaces = 16;  // of an edge, on the average

}  // namespace

Polygon::Polygon(std::vector<glm::dvec3> corners) : corners_(std::move(corners))
{
    for (const glm::dvec3& p : corners_) box_.include(p);
    for (int k = 0; k < 3; ++k)
        if (box_.upper[k] - box_.lower[k] < kLeastEdge) {
            box_.lower[k] -= kLeastEdge;
            box_.upper[k] += kLeastEdge;
        }
    find_plane(corners_);
}

Aabb Polygon::extent(const Transform& moved) const
{
    Aabb box;
    for (const glm::dvec3& p : corners_) box.include(moved.point(p));
    return box;
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
    add_edges(flat);
    sort_into_bands();
}

/// Edges along the first axis are left out: a point is never counted as beside one.
void Polygon::add_edges(const std::vector<glm::dvec2>& corners)
{
    for (std::size_t first = 0; first < corners.size();) {
        std::size_t i = first;
        do {
            if (corners[i].y != corners[i + 1].y) edges_.push_back({corners[i], corners[i + 1]});
        } while (++i + 1 < corners.size() && corners[i] != corners[first]);
        first = i + 1;
    }
}

std::size_t Polygon::band_of(double y) const
{
    return std::min(static_cast<std::size_t>((y - low_) * bands_per_unit_), ends_.size() - 1);
}

/// A point looks at the edges of its band alone. There are as many bands as edges, so more corners do not cost more.
void Polygon::sort_into_bands()
{
    if (edges_.empty()) return;
    low_ = kInfinity, high_ = -kInfinity;
    for (const Edge& e : edges_) {
        low_ = std::min({low_, e.a.y, e.b.y});
        high_ = std::max({high_, e.a.y, e.b.y});
    }
    const auto each_band = [&](const Edge& e, auto&& f) {
        for (std::size_t k = band_of(std::min(e.a.y, e.b.y)); k <= band_of(std::max(e.a.y, e.b.y)); ++k) f(k);
    };
    std::size_t places;
    ends_.resize(2 * std::min(edges_.size(), kMostBands));
    do {
        ends_.resize(ends_.size() / 2);
        bands_per_unit_ = static_cast<double>(ends_.size()) / (high_ - low_);
        if (!std::isfinite(bands_per_unit_)) bands_per_unit_ = 0.0;
        places = 0;
        for (const Edge& e : edges_) each_band(e, [&](std::size_t) { ++places; });
    } while (places > kMostPlaces * edges_.size() && ends_.size() > 1);
    std::vector<std::vector<Edge>> bands(ends_.size());
    for (const Edge& e : edges_) each_band(e, [&](std::size_t k) { bands[k].push_back(e); });
    edges_.clear();
    for (std::size_t band = 0; band < bands.size(); ++band) {
        edges_.insert(edges_.end(), bands[band].begin(), bands[band].end());
        ends_[band] = edges_.size();
    }
}

bool Polygon::holds(const glm::dvec2& q) const
{
    if (!(q.y >= low_ && q.y <= high_)) return false;
    const std::size_t band = band_of(q.y);
    bool inside = false;
    for (std::size_t i = band == 0 ? 0 : ends_[band - 1]; i < ends_[band]; ++i) {
        const auto& [a, b] = edges_[i];
        const bool above_a = a.y >= q.y, above_b = b.y >= q.y;
        if (above_a != above_b && ((b.y - q.y) * (a.x - b.x) >= (b.x - q.x) * (a.y - b.y)) == above_b) inside = !inside;
    }
    return inside;
}

void Polygon::intersect(const Ray& ray, IntersectionList& out) const
{
    if (edges_.empty()) return;
    const glm::dvec3 o = glm::transpose(axes_) * (ray.origin - origin_), d = glm::transpose(axes_) * ray.direction;
    if (std::abs(d.z) < kSame * std::sqrt(glm::dot(d, d))) return;
    const double t = -o.z / d.z;
    if (holds({o.x + t * d.x, o.y + t * d.y})) out.touch(t, 0);
}

}  // namespace csg
