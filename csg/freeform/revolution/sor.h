#pragma once

#include "csg/freeform/shared/intersection_list.h"

#include <span>
#include <vector>

namespace csg {

class AxisRay;

/// A curve of radius (x) over rising height (y) turned about the y axis, the square of its radius a cubic spline of the
/// height (spec 5b, 8; manual: Surface of Revolution). It holds its surface, its inverse does not. Faces: 0 its base, 1
/// its cap, 2 + segment.
class Sor {
public:
    /// `points`: at least four, of which the first and the last are control points only. With numbers that are not
    /// finite no ray meets it.
    Sor(const std::vector<glm::dvec2>& points, bool open);

    void intersect(const Ray& ray, IntersectionList& out) const;
    bool intersects_many() const { return true; }
    void intersect_many(std::span<const Ray> rays, IntersectionList* out) const;
    bool contains(const glm::dvec3& p) const;
    glm::dvec3 gradient(const glm::dvec3& p, std::uint32_t face) const;
    glm::dvec2 uv(const glm::dvec3& p, std::uint32_t face) const;
    Aabb bounds() const;

    static constexpr bool kSurface = false;
    static constexpr bool kClosed = true, kInverseClosed = false;

private:
    static constexpr std::uint32_t kBase = 0, kCap = 1, kFirstSide = 2;

    /// The squared radius ((a h + b) h + c) h + d at height low + h.
    struct Segment {
        double low, high;
        double a, b, c, d;
        double most;  ///< largest squared radius
        /// \tparam T double, or lanes
        template <class T>
        T square(const T& h) const
        {
            return ((T(a) * h + T(b)) * h + T(c)) * h + T(d);
        }
        template <class T>
        T slope(const T& h) const
        {
            return (T(3.0 * a) * h + T(2.0 * b)) * h + T(c);
        }
    };
    template <class T>
    class Meeting;
    void meet_level(const AxisRay& ray, IntersectionList& out) const;

    const Segment& segment_at(double y) const;

    std::vector<Segment> segments_;  ///< rising
    double base_ = 0.0, cap_ = 0.0;  ///< squared radii of the ends
    bool base_drawn_ = false, cap_drawn_ = false;
    double most_ = 0.0;
};

}  // namespace csg
