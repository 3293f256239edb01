#pragma once

#include "csg/bvh.h"
#include "csg/freeform/ray_record.h"

#include <array>
#include <span>
#include <vector>

namespace csg {

/// All balls whose centre and radius run along a spline (spec 5b, 9; manual: Sphere Sweep), as one solid: what POV-Ray finds
/// by sorting candidate hits is here the union of the intervals that a ray has in the balls of each segment.
class SphereSweep {
public:
    struct Ball {
        glm::dvec3 center{0.0};
        double radius = 0.0;
    };
    enum class Spline { Linear, Cubic, B };

    /// At least 2 balls for a linear spline, 4 for the others; numbers that are not finite leave their segments out.
    SphereSweep(Spline spline, std::span<const Ball> balls);

    void meet(const Ray& ray, RayRecord& out) const;
    bool contains(const glm::dvec3& p) const;
    /// `face`: the segment, and where on it in 2^-16.
    glm::dvec3 gradient(const glm::dvec3& p, std::uint32_t face) const;
    Aabb bounds() const { return box_; }
    /// POV-Ray's after a transformation: around the balls as they were written, moved; twice as large for Spline::Cubic.
    Aabb extent(const Transform& moved) const;

    static constexpr bool kSurface = false, kClosed = true, kInverseClosed = false;

private:
    /// Bezier form of degree 1 or 3; w holds the radius.
    struct Segment {
        std::array<glm::dvec4, 4> control;
        bool linear;
        glm::dvec4 at(double u) const;
        glm::dvec4 rate(double u) const;
    };
    struct End {
        double t, u;
    };
    struct Piece {
        End in, out;
        std::uint32_t segment;
    };

    void add(const Segment& segment);
    void gather(std::uint32_t segment, const Ray& ray, std::vector<Piece>& out) const;

    static constexpr std::size_t kMostLoose = 8;   ///< more segments go through a hierarchy

    Spline spline_;
    std::vector<Ball> balls_;
    std::vector<Segment> segments_;
    std::vector<Aabb> boxes_;
    Bvh tree_;                                     ///< empty below that number
    Aabb box_;
    glm::dvec3 middle_{0.0};
};

}  // namespace csg
