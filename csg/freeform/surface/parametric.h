#pragma once

#include "csg/freeform/shared/container.h"
#include "csg/freeform/field/field.h"
#include "csg/freeform/shared/intersection_list.h"

#include <array>
#include <memory>
#include <vector>

namespace csg {

/// What a parametric surface is made of (spec 5b, 14; reference manual: Parametric).
struct ParametricTerms {
    std::array<std::shared_ptr<const Field>, 3> field;  ///< x, y and z of <u, v, 0>
    glm::dvec2 lower{0.0}, upper{1.0};                  ///< of u and v, sorted
    double accuracy = 0.001;                            ///< above 0
    double max_gradient = 1.0;
    int precompute = 0;  ///< levels of the tree whose ranges are unions, for the axes below
    std::array<bool, 3> precomputed{};
    Container container;
};

/// A surface given by two parameters, drawn without an inside. A ray follows halves of the parameters' rectangle by
/// POV-Ray's rules, its shift by the accuracy included; the ranges of the largest parts are kept.
class Parametric {
public:
    explicit Parametric(ParametricTerms terms) : terms_(std::move(terms)) {}

    /// Must come before the first ray: the fields are asked.
    void prepare();

    /// A face is the number of the part that was hit.
    void intersect(const Ray& ray, IntersectionList& out) const;
    bool contains(const glm::dvec3&) const { return false; }
    bool contains_inverted(const glm::dvec3&) const { return false; }
    glm::dvec3 gradient(const glm::dvec3& p, std::uint32_t face) const;
    glm::dvec2 uv(const glm::dvec3&, std::uint32_t face) const { return part(face).lower; }
    Aabb bounds() const { return terms_.container.bounds(); }

    const ParametricTerms& terms() const { return terms_; }

    static constexpr bool kSurface = true;
    static constexpr bool kOpenSurface = true;  ///< by the accuracy
    static constexpr bool kClosed = false, kInverseClosed = false;

private:
    struct Range {
        double low, high;
    };
    using Ranges = std::array<Range, 3>;
    /// A rectangle of parameters. Part 1 is the whole, the halves of part n are 2n and 2n + 1.
    struct Part {
        glm::dvec2 lower, upper;
        std::uint32_t number;
        int longer() const { return upper.y - lower.y > upper.x - lower.x ? 1 : 0; }
        Part half(int which) const;
    };
    /// One ray's search.
    struct Search;

    Part whole() const { return {terms_.lower, terms_.upper, 1}; }
    Part part(std::uint32_t number) const;
    void ranges(const Part& a, const Part& b, std::size_t axis, Range& of_a, Range& of_b) const;
    Range range_of(const double* corners, const Part& part) const;
    void unite(std::uint32_t number);
    glm::dvec3 point(double u, double v) const;

    ParametricTerms terms_;
    std::vector<Ranges> known_;  ///< by number
};

}  // namespace csg
