#pragma once

#include "csg/freeform/shared/intersection_list.h"

#include <vector>

namespace csg {

/// A plane region between loops of corners, even-odd: drawn, without an inside (spec 5b, 4; manual: Polygon).
class Polygon {
public:
    /// Loops one after the other, each ended by a copy of its first corner. What is not flat to 1e-10 or has no area is
    /// never met.
    explicit Polygon(std::vector<glm::dvec3> corners);

    void intersect(const Ray& ray, IntersectionList& out) const;
    bool contains(const glm::dvec3&) const { return false; }
    bool contains_inverted(const glm::dvec3&) const { return false; }
    glm::dvec3 gradient(const glm::dvec3&, std::uint32_t) const { return axes_[2]; }
    Aabb bounds() const { return box_; }
    Aabb extent(const Transform& moved) const;  ///< of its corners

    static constexpr bool kSurface = true;  ///< touched, never entered
    static constexpr bool kClosed = false, kInverseClosed = false;

private:
    struct Edge {
        glm::dvec2 a, b;
    };

    void find_plane(const std::vector<glm::dvec3>& corners);
    void add_edges(const std::vector<glm::dvec2>& corners);
    void sort_into_bands();
    std::size_t band_of(double y) const;
    bool holds(const glm::dvec2& q) const;

    glm::dvec3 origin_{0.0};
    glm::dmat3 axes_{1.0};           ///< columns: two of the plane, its normal
    std::vector<Edge> edges_;        ///< band by band, those that reach into it; empty: nothing to draw
    std::vector<std::size_t> ends_;  ///< of the bands, in edges_
    double low_ = 0.0, high_ = 0.0, bands_per_unit_ = 0.0;
    std::vector<glm::dvec3> corners_;
    Aabb box_;  ///< of the corners, a little thick
};

}  // namespace csg
