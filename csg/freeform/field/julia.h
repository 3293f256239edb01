#pragma once

#include "csg/freeform/shared/intersection_list.h"

#include <span>

namespace csg {

/// What a julia_fractal is made of (spec 5b, 12; reference manual: Julia Fractal).
struct JuliaTerms {
    enum class Function : std::uint8_t {
        Square,
        Cube,
        HyperSquare,
        HyperCube,
        Reciprocal,
        Exp,
        Ln,
        Sin,
        Asin,
        Cos,
        Acos,
        Tan,
        Atan,
        Sinh,
        Asinh,
        Cosh,
        Acosh,
        Tanh,
        Atanh,
        Power
    };
    glm::dvec4 constant{0.0};
    Function function = Function::Square;  ///< the first two of quaternions, the others hypercomplex
    glm::dvec2 exponent{0.0};              ///< of Power
    int iterations = 20;                   ///< above 0
    double precision = 20.0;               ///< at least 1: steps of a ray are no shorter than one part of so many
    glm::dvec4 slice{0.0, 0.0, 0.0, 1.0};  ///< normal of the slice through four dimensions; the last is not 0
    double slice_distance = 0.0;
    /// As POV-Ray 3.7 draws it: functions that are no polynomials lose a component where a point is asked about (spec
    /// 5b, 12.1), and a crossing between the last look within what is asked and the next is not found (spec 5b, 12.2):
    /// rays that end within the set or are clipped there lose some. False: as 3.8.
    bool as_37 = true;
    bool whole = false;  ///< rays of polynomials are told every crossing, no matter what the precision is
};

/// A slice of the points of four dimensions that stay near the origin under q -> f(q) + constant. Rays are marched as
/// POV-Ray does it: which of the set's hairs they meet depends on the steps. A whole one is the set itself, and its
/// normals are those of its surface, which POV-Ray's, of one iteration more, are not.
class Julia {
public:
    explicit Julia(const JuliaTerms& terms);

    const JuliaTerms& terms() const { return terms_; }
    /// A point in the set's own space. Orbits, and where the way of a ray begins, are a matter of the last bits:
    /// POV-Ray's.
    glm::dvec3 into(const Transform& frame, const glm::dvec3& point) const;
    /// `moved`: the ray comes through a transformation, after which POV-Ray scales its direction to unit length.
    void intersect(const Ray& ray, IntersectionList& out, bool moved = false) const;
    bool intersects_many() const { return terms_.function != JuliaTerms::Function::Reciprocal && !whole(); }
    void intersect_many(std::span<const Ray> rays, IntersectionList* out, bool moved = false) const;
    bool contains(const glm::dvec3& p) const;
    glm::dvec3 gradient(const glm::dvec3& p, std::uint32_t face) const;
    Aabb bounds() const { return {glm::dvec3(-radius_), glm::dvec3(radius_)}; }

    static constexpr bool kSurface = false;
    static constexpr bool kOpenSurface = true;  ///< what a ray meets depends on where its steps began
    static constexpr bool kClosed = true, kInverseClosed = false;

private:
    class Orbits;
    class Ahead;
    class Lanes;
    struct March {
        bool inside;
        double step;  ///< to where the next look is worth while
    };
    bool polynomial() const { return terms_.function <= JuliaTerms::Function::HyperCube; }
    bool whole() const { return terms_.whole && polynomial(); }
    bool quaternion() const { return terms_.function <= JuliaTerms::Function::Cube; }
    glm::dvec4 lifted(const glm::dvec3& p) const { return {p, offset_ - glm::dot(tilt_, p)}; }
    glm::dvec4 plain_start(const glm::dvec3& p) const;
    double size(const glm::dvec4& q) const;  ///< squared
    bool gone(const glm::dvec4& q) const { return !(size(q) <= escape_); }
    bool stays(const glm::dvec3& p) const;
    March look(const glm::dvec3& p, const glm::dvec3& way) const;
    March look_quaternion(const glm::dvec3& p) const;
    glm::dvec3 quaternion_slope(glm::dvec4 q) const;
    enum class Where : std::uint8_t { Outside, Inside, CrossesOnce, Unknown };
    Where where(const glm::dvec3& p, const glm::dvec3& half) const;
    void intersect_whole(const Ray& ray, IntersectionList& out) const;
    glm::dvec3 whole_gradient(const glm::dvec3& p) const;
    struct Orbit;
    Orbit follow(glm::dvec4 q) const;

    /// Squares of sizes from here on, and what is no number, stand for their logarithms.
    static constexpr double kMostSize = 1e300;

    JuliaTerms terms_;
    glm::dvec3 tilt_;  ///< the fourth coordinate is offset - dot(tilt, p)
    double offset_, radius_, escape_, step_;
};

}  // namespace csg
