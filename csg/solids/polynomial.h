#pragma once

#include "csg/solids/shared/polynomial_shape.h"
#include "csg/solids/shared/common.h"

#include <memory>

namespace csg {

namespace detail {

/// Rays in a polynomial's frame, of unit direction and from the place next to the frame's origin.
template <class V>
struct PolynomialCourse {
    Course<V> ray;
    V length, shift;
    V lo = V(-kInfinity), hi = V(kInfinity);  ///< roots lie between
    lanes::Truth<V> possible;                 ///< false: there are none, or no ray

    PolynomialCourse(const PolynomialShape& shape, const Course<V>& given)
    {
        const auto dot = [](const V(&a)[3], const V(&b)[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
        length = lanes::root_of(dot(given.d, given.d));
        for (int k = 0; k < 3; ++k) ray.d[k] = given.d[k] / length;
        shift = lanes::negated(dot(given.o, ray.d));
        for (int k = 0; k < 3; ++k) ray.o[k] = given.o[k] + shift * ray.d[k];
        shape.clip(ray, lo, hi);
        const lanes::Truth<V> some = length > V(0.0), between = lo < hi;
        possible = some & between;
    }
    V t(const V& root) const { return (shift + root) / length; }
    /// A place on the root's scale that is surely behind t, and one that is surely before it.
    V behind(const V& t) const { return root(t) + doubt(root(t)); }
    V before(const V& t) const { return root(t) - doubt(root(t)); }
    /// Leaves the roots between t_min and t_max, and a little more.
    void clip(const V& t_min, const V& t_max)
    {
        lo = lanes::larger(lo, before(t_min));
        hi = lanes::smaller(hi, behind(t_max));
        possible = possible & (lo < hi);
    }

private:
    V root(const V& t) const { return t * length - shift; }
    /// More than PolynomialShape::polished() moves one by.
    static V doubt(const V& root) { return V(2e-6) * (V(1.0) + lanes::size_of(root)); }
};

}  // namespace detail

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
        double in = -kInfinity;
        const bool inside = each_crossing(ray, -kInfinity, kInfinity, false, [&](double t, bool leaves) {
            if (leaves) f(in, 0u, t, 0u);
            else in = t;
        });
        if (inside) f(in, 0u, kInfinity, 0u);
    }

    /// f(t, leaves) where the ray crosses the surface, nearest first. Crossings beyond t_min and t_max may be left out,
    /// with `nearest_only` also those behind the first between them; `leaves` is right only if none is.
    /// \return whether the ray is inside beyond the last crossing, with the same proviso
    template <class F>
    bool each_crossing(const Ray& ray, double t_min, double t_max, bool nearest_only, F&& f) const
    {
        const Ray given = local_ray(frame, ray);
        const detail::Course<double> local{{given.origin.x, given.origin.y, given.origin.z},
                                           {given.direction.x, given.direction.y, given.direction.z}};
        detail::PolynomialCourse<double> course(*shape, local);
        course.clip(t_min, t_max);
        if (!course.possible) return false;
        const auto& [o, way] = course.ray;
        const glm::dvec3 p(o[0], o[1], o[2]), d(way[0], way[1], way[2]);
        PolynomialShape::Along c;
        shape->along(p, d, c);
        const int degree = shape->degree_along(p, d, c);
        double roots[PolynomialShape::kMostDegree];
        const double enough = nearest_only ? course.behind(t_min) : kInfinity;
        const int count = shape->changes(c, degree, course.lo, course.hi, enough, roots);
        const double last = c[static_cast<std::size_t>(degree)];
        bool inside = degree % 2 == 0 ? last <= 0.0 : last > 0.0;  // where t goes to minus infinity
        for (int i = 0; i < count; ++i) {
            roots[i] = glm::max(shape->polished(p, d, roots[i]), i > 0 ? roots[i - 1] : -kInfinity);
            f(course.t(roots[i]), inside);
            inside = !inside;
        }
        return inside;
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
