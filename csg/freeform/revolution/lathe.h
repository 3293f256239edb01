#pragma once

#include "csg/freeform/shared/intersection_list.h"
#include "csg/solids/shared/outline_shape.h"

#include <span>
#include <vector>

namespace csg {

/// A curve of radius (x) and height (y) turned about the y axis (spec 5b, 7; manual: Lathe). Inside is what lies within
/// an odd number of its turns at one height, however open it is, and farther from the axis than its nearest point. What
/// has a negative radius is drawn, but bounds nothing. It holds its surface, its inverse does not.
class Lathe {
public:
    /// `segments`: the curve's pieces in order, a uv coordinate's unit each. `reach`: least and largest radius that
    /// POV-Ray finds, from which it takes extents and the hole that is never inside. Numbers that are not finite:
    /// nothing is met.
    Lathe(const std::vector<OutlinePiece>& segments, const Aabb& extent, double least_radius);

    void intersect(const Ray& ray, IntersectionList& out) const;
    bool intersects_many() const;
    void intersect_many(std::span<const Ray> rays, IntersectionList* out) const;
    bool contains(const glm::dvec3& p) const;
    glm::dvec3 gradient(const glm::dvec3& p, std::uint32_t face) const;
    glm::dvec2 uv(const glm::dvec3& p, std::uint32_t face) const;
    Aabb bounds() const;
    Aabb extent() const { return extent_; }
    /// Whether rays may touch it where they neither enter nor leave.
    bool reports_touches() const { return negative_; }

    static constexpr bool kRound = true;  ///< not asked for its own crossings beside a start (Freeform::round)
    static constexpr bool kSurface = false;
    static constexpr bool kClosed = true, kInverseClosed = false;

private:
    /// A part of a segment, from `lo` to `hi` of its parameter, on which radius, height and the slopes of both keep
    /// their direction and the radius its sign.
    struct Arc {
        glm::dvec2 a, b, c, d;
        double lo, hi;
        glm::dvec2 start, end;  ///< shared with the neighbours
        glm::dvec2 start_slope, end_slope;
        std::uint32_t segment;
        bool straight, negative;
        glm::dvec2 at(double w) const { return ((a * w + b) * w + c) * w + d; }
        glm::dvec2 slope(double w) const { return (3.0 * a * w + 2.0 * b) * w + c; }
    };
    /// What arcs lie in, a little larger: distance from the axis, height.
    struct Reach {
        double nearest = kInfinity, farthest = 0.0, low = kInfinity, high = -kInfinity;
    };
    /// The same of eight in a row, a lane each.
    struct alignas(64) Reaches {
        static constexpr std::size_t kArcs = 8;
        double nearest[kArcs], farthest[kArcs], low[kArcs], high[kArcs];
        void set(std::size_t lane, const Reach& reach);
    };

    class Sweep;
    class Meeting;
    class Tile;

    void add_segment(const OutlinePiece& piece, std::uint32_t segment);
    Reach reach_of(std::size_t first, std::size_t last) const;
    void find_reaches();
    void find_rims();
    template <class Lanes, class F>
    void each_near(const Lanes& lanes, F&& f) const;
    double parameter(const Arc& arc, const glm::dvec2& p) const;

    std::vector<Arc> arcs_;
    Reach all_;
    std::vector<Reaches> reaches_;  ///< of the arcs
    std::vector<Reaches> groups_;   ///< of eight arcs each; empty where there are too few to be worth it
    std::vector<glm::dvec2> rims_;  ///< where the curve ends at a positive radius
    Aabb extent_;
    double hole_ = 0.0;  ///< radius that is never inside; 0 if no point of it could be
    double segments_ = 1.0;
    bool negative_ = false;
};

}  // namespace csg
