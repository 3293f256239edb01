#pragma once

#include "csg/base/points.h"
#include "csg/bvh/bvh.h"
#include "csg/freeform/shared/intersection_list.h"

#include <span>
#include <vector>

namespace csg {

struct Share;

/// Where the fields of spheres and capsules add up to the threshold (spec 5a, 5.11; manual: Blob). A component's field
/// is strength (1 - q)^2, q the squared distance from its centre or axis over the squared radius, and nothing from q =
/// 1 on.
class Blob {
public:
    struct Component {
        Transform frame;         ///< to the blob's space
        double length = 0.0;     ///< of the axis, along z from the frame's origin; 0: a sphere
        double radius = 1.0;     ///< its sign does not matter
        double strength = 1.0;   ///< negative: takes away
        std::uint32_t part = 0;  ///< which of the blob's textures it has
    };

    /// Components that cannot be seen (no strength, no radius, numbers that are not finite) are left out.
    Blob(double threshold, const std::vector<Component>& components);

    void intersect(const Ray& ray, IntersectionList& out) const;
    /// Rays lie in lanes until it is known which stretches they have in whose reach.
    bool intersects_many() const { return !box_.empty(); }
    void intersect_many(std::span<const Ray> rays, IntersectionList* out) const;
    bool contains(const glm::dvec3& p) const;
    /// What the components add up to.
    double field(const glm::dvec3& p) const;
    /// The same of many points; aligned, with room for whole vectors.
    void fields(const double* x, const double* y, const double* z, std::size_t count, double* out) const;
    glm::dvec3 gradient(const glm::dvec3& p, std::uint32_t) const;
    /// The parts' shares of |field| at p.
    void shares(const glm::dvec3& p, std::vector<Share>& out) const;
    double threshold() const { return threshold_; }
    Aabb bounds() const { return box_; }
    Aabb extent() const { return extent_; }

    static constexpr bool kRound = true;  ///< not asked for its own crossings beside a start (Freeform::round)
    static constexpr bool kSurface = false, kClosed = true, kInverseClosed = false;

private:
    /// q = x^2 + y^2 + (z - nearest of [0, length])^2 with (x, y, z) = rows * p + offset.
    struct Field {
        glm::dmat3 to_unit;
        glm::dvec3 offset;
        double length, strength;
        std::uint32_t part;
        glm::dvec3 middle;  ///< of a sphere around all that the field reaches,
        double reach2;      ///< and its radius squared: that of the field itself where it is a sphere
        bool is_sphere;

        template <class P>
        P unit(const P& p) const
        {
            const P u = lanes::times(to_unit, p);
            return {u.x + offset.x, u.y + offset.y, u.z + offset.z};
        }
        /// From the nearest point of centre or axis, in units of the radius.
        glm::dvec3 arm(const glm::dvec3& p) const
        {
            glm::dvec3 u = unit(p);
            u.z -= glm::clamp(u.z, 0.0, length);
            return u;
        }
    };
    /// Of a stretch of a ray, or of a ray a lane: the field there is strength w^2, w = w0 + w1 s + w2 s^2, s = t - ref.
    template <class V>
    struct Course {
        V enter, leave, ref, w0, w1, w2;

        V w(const V& t) const
        {
            const V s = t - ref;
            return w0 + s * (w1 + s * w2);
        }
        /// The field is nowhere above it in the range asked for, nor are sums above the sum of these. `top`: the
        /// vertex.
        V most(double strength, const V& top, const V& from, const V& to) const
        {
            V out(kRounding * std::abs(strength));
            if (!(strength > 0.0)) return out;
            const V at = w(lanes::smaller(lanes::larger(lanes::smaller(lanes::larger(top, enter), leave), from), to));
            return out + strength * at * at;
        }
    };
    struct Stretch : Course<double> {
        double strength, most;
    };
    struct Walk;
    template <std::size_t components>
    struct WalkRoom;
    class Follower;
    template <std::size_t components>
    class Lanes;
    template <class P>
    struct Chord;
    template <class P, class V>
    static lanes::Truth<V> in_unit_sphere(const P& o, const P& v, V low, V high, const V& from, const V& to, V& top,
                                          Course<V>& out);
    template <class P, class F>
    static void each_slice(const Field& field, const P& u, const P& d, F&& f);

    void add(const Component& component);
    void bound();
    void intersect(const Ray& ray, Walk& walk, IntersectionList& out) const;
    /// Tells the crossings from the stretches of a ray, whose parameter is less by `start` than what is told.
    void follow(const Walk& walk, double start, IntersectionList& out) const;
    /// Write the stretches that the ray has in a component, three at most, and move on behind them.
    void gather(const Field& field, const Ray& ray, double inverse, double from, double to, Stretch*& out) const;
    void gather_capsule(const Field& field, const Ray& ray, double from, double to, Stretch*& out) const;
    void gather_loose(const Ray& ray, double inverse, double from, double to, Stretch*& out) const;
    /// Numbers of the components whose boxes one of these rays meets between two of its parameters, as the hierarchy
    /// has them: a ray has its stretches in one order whatever others are asked with it.
    struct Part {
        Ray ray;
        double from, to;
    };
    static constexpr std::size_t kMostTogether = 8;
    void find_near(std::span<const Part> rays, std::vector<std::uint32_t>& out) const;
    template <std::size_t components>
    void intersect_in_lanes(std::span<const Ray> rays, IntersectionList* out) const;
    template <class F>
    void each_near(const glm::dvec3& p, F&& f) const;

    static constexpr std::size_t kMostLoose = 12;  ///< more components go through a hierarchy
    static constexpr std::size_t kMostNear = 96;   ///< of that, what rays in lanes have room for
    /// Of a strength: what sums of fields and the places where they cross the threshold are off by, and far more.
    static constexpr double kRounding = 1e-13;

    /// The spheres around the fields, side by side.
    struct Loose {
        std::array<double, kMostLoose> x{}, y{}, z{}, reach2{};  ///< reach2 0: none
    };

    double threshold_ = 0.0;
    std::vector<Field> fields_;
    Loose loose_;  ///< of the first fields
    std::vector<Aabb> boxes_;
    Bvh tree_;  ///< empty below that number
    Aabb box_, extent_;
    glm::dvec3 middle_{0.0};
};

}  // namespace csg
