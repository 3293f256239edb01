#pragma once

#include "csg/solids/shared/polynomial_shape.h"
#include "csg/solids/shared/common.h"

#include <memory>

namespace csg {

/// A polynomial that is not positive: poly, cubic, quartic (spec 5a, 5.9). Tangents miss. It and its inverse hold the
/// surface.
struct Polynomial {
    std::shared_ptr<const PolynomialShape> shape;
    Transform frame;  ///< local to world

    static constexpr std::uint32_t kMostSpans = PolynomialShape::kMostDegree / 2 + 2;
    std::uint32_t most_spans() const { return static_cast<std::uint32_t>(shape->degree()) / 2 + 2; }
    std::uint32_t most_crossings() const { return static_cast<std::uint32_t>(shape->degree()) + 1; }

    void intersect(const Ray& ray, SpanList& out) const
    {
        each_span(ray, [&](double in, std::uint32_t, double end, std::uint32_t) { out.push({{.t = in}, {.t = end}}); });
    }

    /// f(t in, face, t out, face) for the pieces of the ray inside, nearest first; ends may be infinite.
    template <class F>
    void each_span(const Ray& ray, F&& f) const
    {
        const Ray given = local_ray(frame, ray);
        const double length = std::sqrt(glm::dot(given.direction, given.direction));
        if (!(length > 0.0)) return;
        const glm::dvec3 d = given.direction / length;
        const double shift = -glm::dot(given.origin, d);  // start near the frame's origin
        const glm::dvec3 p = given.origin + shift * d;
        double lo = -kInfinity, hi = kInfinity;
        shape->clip(p, d, lo, hi);
        if (!(lo < hi)) return;
        PolynomialShape::Along c;
        shape->along(p, d, c);
        const int degree = shape->degree_along(p, d, c);
        double roots[PolynomialShape::kMostDegree];
        const int count = shape->changes(c, degree, lo, hi, roots);
        const double last = c[static_cast<std::size_t>(degree)];
        bool inside = degree % 2 == 0 ? last <= 0.0 : last > 0.0;  // where t goes to minus infinity
        double in = -kInfinity;
        for (int i = 0; i < count; ++i) {
            roots[i] = glm::max(shape->polished(p, d, roots[i]), i > 0 ? roots[i - 1] : -kInfinity);
            const double t = (shift + roots[i]) / length;
            if (inside) f(in, 0u, t, 0u);
            else in = t;
            inside = !inside;
        }
        if (inside) f(in, 0u, kInfinity, 0u);
    }

    bool contains(const glm::dvec3& p) const { return shape->value(frame.inverse_point(p)) <= 0.0; }
    bool contains_inverted(const glm::dvec3& p) const { return shape->value(frame.inverse_point(p)) >= 0.0; }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t) const
    {
        return unit_or_x(frame.normal(shape->gradient(frame.inverse_point(p))));
    }
    Aabb bounds() const
    {
        return shape->box().finite() ? padded(transformed_box(frame, shape->box())) : Aabb::everything();
    }

    static constexpr bool kClosed = true, kInverseClosed = true;
};

}  // namespace csg
