#pragma once

#include "csg/solids/shared/slab.h"
#include "csg/solids/cylinder.h"

namespace csg {

/// x^2 + y^2 = z^2 between z = low and z = 1, in its own frame: apex at 0, the large end at 1. low < 0 is POV-Ray's
/// double cone of a negative radius, which is not convex (spec 5a, 5.4). Surface held as by a cylinder.
struct Cone {
    double low = 0.0;  ///< in (-1, 1)
    Transform frame;   ///< local to world
    bool open = false;

    bool convex() const { return low >= 0.0; }

    /// Only for convex().
    bool interval(const Ray& ray, Interval& out) const
    {
        Interval parts[2];
        const int n = pieces(ray, parts);
        if (n == 0) return false;
        out = parts[0];
        if (n == 2 && parts[1].exit - parts[1].entry > out.exit - out.entry) out = parts[1];
        return true;
    }
    void intersect(const Ray& ray, SpanList& out) const
    {
        Interval parts[2];
        const int n = convex() ? static_cast<int>(interval(ray, parts[0])) : pieces(ray, parts);
        for (int i = 0; i < n; ++i)
            out.push(
                {{.t = parts[i].entry, .face = parts[i].entry_face}, {.t = parts[i].exit, .face = parts[i].exit_face}});
    }
    bool contains(const glm::dvec3& p) const { return open ? grown(p, Cylinder::kSkin) : grown(p, -Cylinder::kSkin); }
    bool contains_inverted(const glm::dvec3& p) const { return !contains(p); }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t face) const
    {
        if (face == kLowEnd || face == kHighEnd)
            return unit_or_x(frame.normal({0.0, 0.0, face == kLowEnd ? -1.0 : 1.0}));
        const glm::dvec3 local = frame.inverse_point(p);
        return unit_or_x(frame.normal({local.x, local.y, -local.z}));
    }
    Aabb bounds() const;

    /// Up to two intervals, in order: what the quadric's inside and the slab low <= z <= 1 have in common.
    int pieces(const Ray& ray, Interval (&out)[2]) const
    {
        const Ray given = local_ray(frame, ray);
        const glm::dvec3& d = given.direction;
        const double length2 = glm::dot(d, d);
        if (!(length2 > 0.0)) return 0;
        // From the point nearest to the apex; the discriminant and both outer coefficients as products (Lagrange's
        // identity), so a thin cone or a ray past the apex loses nothing.
        const double shift = -glm::dot(given.origin, d) / length2;
        const glm::dvec3 o = given.origin + shift * d;
        Interval ends;
        if (!slab(o.z, d.z, low, 1.0, ends)) return 0;
        ends.entry_face = end_face(ends.entry_face);
        ends.exit_face = end_face(ends.exit_face);

        const double across = std::sqrt(d.x * d.x + d.y * d.y), radius = std::sqrt(o.x * o.x + o.y * o.y);
        const double a = (across - std::abs(d.z)) * (across + std::abs(d.z));
        const double b = o.x * d.x + o.y * d.y - o.z * d.z;
        const double c = (radius - std::abs(o.z)) * (radius + std::abs(o.z));
        const double wx = o.z * d.x - d.z * o.x, wy = o.z * d.y - d.z * o.y;
        const double w = std::sqrt(wx * wx + wy * wy), m = std::abs(o.x * d.y - o.y * d.x);
        const double discriminant = (w - m) * (w + m);
        if (!(discriminant >= 0.0)) return 0;
        Interval side[2];
        const int n = side_pieces(a, b, c, std::sqrt(discriminant), side);
        int kept = 0;
        for (int i = 0; i < n; ++i) {
            Interval piece = ends;
            if (!narrow(piece, side[i])) continue;
            piece.entry += shift;
            piece.exit += shift;
            if (piece.entry <= piece.exit) out[kept++] = piece;
        }
        return kept;
    }

    /// From two different radii; the points must differ. Returns false where POV-Ray makes it a cylinder, with the
    /// radius to use in `cylinder_radius`.
    static bool make(const glm::dvec3& first, double first_radius, const glm::dvec3& second, double second_radius,
                     bool open, const Transform& t, Cone& out, double& cylinder_radius);

private:
    std::uint32_t end_face(std::uint32_t slab_face) const { return open ? kUndrawnFace : kLowEnd + slab_face; }
    /// Where a t^2 + 2 b t + c <= 0, given the root of its discriminant.
    static int side_pieces(double a, double b, double c, double root, Interval (&side)[2])
    {
        const double q = -(b + std::copysign(root, b));
        const double r0 = q != 0.0 ? c / q : 0.0;
        if (a == 0.0) {
            if (q == 0.0) {
                side[0] = {-kInfinity, kInfinity, kSide, kSide};
                return c <= 0.0 ? 1 : 0;
            }
            side[0] = b > 0.0 ? Interval{-kInfinity, r0, kSide, kSide} : Interval{r0, kInfinity, kSide, kSide};
            return 1;
        }
        const double r1 = q / a;
        const double near = r0 < r1 ? r0 : r1, far = r0 < r1 ? r1 : r0;
        if (a > 0.0) {
            side[0] = {near, far, kSide, kSide};
            return 1;
        }
        side[0] = {-kInfinity, near, kSide, kSide};
        side[1] = {far, kInfinity, kSide, kSide};
        return 2;
    }
    bool grown(const glm::dvec3& p, double by) const
    {
        const glm::dvec3 l = frame.inverse_point(p);
        const double rim = std::abs(l.z) + by;
        return rim > 0.0 && l.x * l.x + l.y * l.y < rim * rim && l.z > low - by && l.z < 1.0 + by;
    }
};

}  // namespace csg
