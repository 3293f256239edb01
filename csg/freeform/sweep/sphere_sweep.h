#pragma once

#include "csg/bvh/bvh.h"
#include "csg/freeform/shared/intersection_list.h"

#include <array>
#include <span>
#include <vector>

namespace csg {

/// Where a ray goes into or out of a segment's spheres: its parameter, and the place of the sphere on the segment.
struct SweepEnd {
    double t, u;
};

/// All spheres whose centre and radius run along a spline (spec 5b, 9; manual: Sphere Sweep), as one solid: what
/// POV-Ray finds by sorting candidate hits is here the union of the intervals that a ray has in the spheres of each
/// segment. Along curved splines POV-Ray's count of the candidates keeps some of those within too: they are touches
/// here.
class SphereSweep {
public:
    struct SweptSphere {
        glm::dvec3 center{0.0};
        double radius = 0.0;
    };
    enum class Spline { Linear, Cubic, B };

    /// At least 2 spheres for a linear spline, 4 for the others; numbers that are not finite leave their segments out.
    SphereSweep(Spline spline, std::span<const SweptSphere> spheres);

    void intersect(const Ray& ray, IntersectionList& out) const;
    bool contains(const glm::dvec3& p) const;
    /// Whether it draws surfaces within; which ones is counted along the ray.
    bool reports_touches() const { return spline_ != Spline::Linear; }
    bool one_way() const { return reports_touches(); }
    /// `face`: the segment, and where on it in 2^-12; from the number of segments on, the flat end of one.
    glm::dvec3 gradient(const glm::dvec3& p, std::uint32_t face) const;
    Aabb bounds() const { return box_; }
    /// POV-Ray's after a transformation: around the spheres as they were written, moved; twice as large for
    /// Spline::Cubic.
    Aabb extent(const Transform& moved) const;

    static constexpr bool kRound = true;  ///< not asked for its own crossings beside a start (Freeform::round)
    static constexpr bool kSurface = false, kClosed = true, kInverseClosed = false;

private:
    /// Bezier form of degree 1 or 3; w holds the radius.
    struct Segment {
        std::array<glm::dvec4, 4> control;
        bool linear;
        glm::dvec4 at(double u) const;
        glm::dvec4 rate(double u) const;
    };
    struct Piece {
        SweepEnd in, out;
        std::uint32_t segment;
    };

    static constexpr std::uint32_t kPlaceBits = 12,
                                   kPlaces = (1u << kPlaceBits) - 1;  ///< of the place in a face's number
    static std::uint32_t face_of(std::uint32_t segment, double u)
    {
        return segment << kPlaceBits | static_cast<std::uint32_t>(glm::clamp(u, 0.0, 1.0) * kPlaces + 0.5);
    }

    void add(const Segment& segment);
    void gather(std::uint32_t segment, const Ray& ray, std::vector<Piece>& out) const;
    void gather_all(const Ray& ray, double from, double to, bool first_only, std::vector<Piece>& out) const;

    /// A place where POV-Ray may meet the surface.
    struct Candidate {
        double t;
        bool enters;
        std::uint32_t face;
    };
    void candidates(std::uint32_t segment, const Ray& ray, std::vector<Candidate>& out) const;
    void touch_within(const Ray& ray, double start, IntersectionList& out) const;

    static constexpr std::size_t kMostSegments = (std::size_t{1} << (31 - kPlaceBits)) - 2;
    static constexpr std::size_t kMostLoose = 3;  ///< more segments go through a hierarchy

    Spline spline_;
    std::vector<SweptSphere> spheres_;
    std::vector<Segment> segments_;
    std::vector<Aabb> boxes_;
    Bvh tree_;  ///< empty below that number
    Aabb box_;
    glm::dvec3 middle_{0.0};
};

}  // namespace csg
