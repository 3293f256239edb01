#pragma once

#include "csg/freeform/shared/intersection_list.h"

#include <span>

namespace csg {

/// (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) <= 1 (spec 5a, 5.10; manual: Superquadric Ellipsoid), asked as a length of
/// (x, y, z) that is 1 on the surface: along a ray it is convex where both exponents are at least 1.
class Superellipsoid {
public:
    Superellipsoid(double e, double n);

    void intersect(const Ray& ray, IntersectionList& out) const;
    /// Those that are convex along every ray.
    bool intersects_many() const { return convex_; }
    void intersect_many(std::span<const Ray> rays, IntersectionList* out) const;
    bool contains(const glm::dvec3& p) const;
    /// Whether a ray surely has no crossing from `from` to `to`: a convex one goes away outside, or is inside at both.
    /// False: it may have. POV-Ray's inside reaches so far out that contains() tells nothing near the surface.
    bool meets_no_more(const Ray& ray, double from, double to) const;
    glm::dvec3 gradient(const glm::dvec3& p, std::uint32_t) const;
    Aabb bounds() const { return {glm::dvec3(-kReach), glm::dvec3(kReach)}; }

    static constexpr bool kSurface = false, kClosed = true, kInverseClosed = false;

private:
    class Convex;
    static constexpr double kReach = 1.0001;  ///< POV-Ray's extent; nothing but spikes without end reaches it

    struct Slope {
        double value, slope;
    };
    struct Line {
        glm::dvec3 origin, direction;
        glm::dvec3 at(double t) const { return origin + t * direction; }
    };
    struct Range {
        double low, high;
    };

    double excess(const glm::dvec3& p) const;
    Slope along(const Line& line, double t) const;
    bool slope_has_sign(const Line& line, double a, double b) const;
    template <class F>
    bool each_change(const Line& line, Range in, Range excess, int depth, F&& found) const;
    /// `start`: of the line in the ray's parameter.
    void meet_any(const Line& line, Range in_cube, double start, IntersectionList& out) const;

    double across_, along_;  ///< exponents 2 / e and 2 / n
    bool convex_;
    double edge_ = 0.0, rim_ = 0.0, corner_ = 0.0;  ///< reach of a convex one along x + y, x + z and x + y + z
};

}  // namespace csg
