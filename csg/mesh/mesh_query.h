#pragma once

#include "csg/base/fused_at.h"
#include "csg/mesh/mesh_shape.h"
#include "csg/bvh/traverse.h"

#include <bit>
#include <cmath>

/// One ray against a mesh.
namespace csg {

namespace detail {

#if defined(__AVX__)
using Quad = xsimd::make_sized_batch_t<double, 4>;
#else
using Quad = xsimd::make_sized_batch_t<double, 2>;
#endif
inline constexpr int kQuad = static_cast<int>(Quad::size);

inline Quad widened(const float* four)
{
    alignas(32) double wide[kQuad];
    for (int i = 0; i < kQuad; ++i) wide[i] = static_cast<double>(four[i]);
    return Quad::load_aligned(wide);
}

template <class Number>
struct Vector {
    Number x, y, z;
};
template <class Number>
inline Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b)
{
    return {a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
}
template <class Number>
inline Vector<Number> operator-(const Vector<Number>& a, const Vector<Number>& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class Number>
inline Number dot(const Vector<Number>& a, const Vector<Number>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Which side of the edge from `a` to `b` (relative to the ray's origin) the ray passes, when its line meets the edge's
/// line: as if its direction were turned a little towards x, less towards y, still less towards z. Both faces of an
/// edge get opposite answers, and the answers at a corner agree with each other.
inline bool left_of_edge(const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 n = glm::cross(a, b);
    return n.x != 0.0 ? n.x > 0.0 : n.y != 0.0 ? n.y > 0.0 : n.z > 0.0;
}

/// Decides for a face where some edge function is exactly 0.
inline bool edge_owner(const TriangleBlock& block, std::uint32_t place, const Ray& ray)
{
    const glm::dvec3 c[3] = {block.at(0, place) - ray.origin, block.at(1, place) - ray.origin,
                             block.at(2, place) - ray.origin};
    int left = 0;
    for (int k = 0; k < 3; ++k) {
        const glm::dvec3 &a = c[k], &b = c[(k + 1) % 3];
        const double side = glm::dot(ray.direction, glm::cross(a, b));
        left += side > 0.0 || (side == 0.0 && left_of_edge(a, b)) ? 1 : 0;
    }
    return left == 0 || left == 3;
}

}  // namespace detail

/// The triangles of a block that the line of the ray meets, a bit each; `t` (4 places) receives where. Three edge
/// functions of corners relative to the origin: two faces that share an edge compute the same number, one its negative,
/// so a ray meets exactly one of them.
inline std::uint32_t meet_triangles(const TriangleBlock& block, const Ray& ray, double* t)
{
    using detail::Quad;
    using V = detail::Vector<Quad>;
    const V d{Quad(ray.direction.x), Quad(ray.direction.y), Quad(ray.direction.z)};
    const V o{Quad(ray.origin.x), Quad(ray.origin.y), Quad(ray.origin.z)};
    const Quad zero(0.0);
    std::uint32_t met = 0;
    for (int at = 0; at < 4; at += detail::kQuad) {
        const auto corner = [&](int k) {
            const auto& c = block.corner[k];
            return V{detail::widened(c[0] + at), detail::widened(c[1] + at), detail::widened(c[2] + at)};
        };
        const V c0 = corner(0), c1 = corner(1), c2 = corner(2);
        const V a = c0 - o, b = c1 - o, c = c2 - o;
        const Quad u = dot(d, cross(a, b)), v = dot(d, cross(b, c)), w = dot(d, cross(c, a));
        const auto positive = (u >= zero) & (v >= zero) & (w >= zero),
                   negative = (u <= zero) & (v <= zero) & (w <= zero);
        const std::uint32_t some = lanes::mask(positive | negative);
        if (some == 0) continue;
        const V n = cross(c1 - c0, c2 - c0);
        const Quad closing = dot(d, n);
        (dot(a, n) / closing).store_aligned(t + at);
        const std::uint32_t crossing = some & ~lanes::mask(closing == zero);
        std::uint32_t edge = crossing & lanes::mask((u == zero) | (v == zero) | (w == zero));
        met |= crossing << at;
        for (; edge != 0; edge &= edge - 1) {
            const int place = std::countr_zero(edge) + at;
            if (!detail::edge_owner(block, static_cast<std::uint32_t>(place), ray)) met &= ~(1u << place);
        }
    }
    return met;
}

/// Far from a mesh, edge functions lose what its corners differ by, and rounded boxes all lie in the ray's way: such a
/// ray is taken from beside the mesh, to which fma() moves it with one rounding of where it then is. How far along it
/// that is.
inline double move_near(const Aabb& box, Ray& ray)
{
    // Of the mesh's size. Edges still have eleven digits there; from 100 on, one pixel in a hundred of a scene of
    // POV-Ray's (incdemo/shapes) came out other than POV-Ray has it.
    constexpr double kFar = 1e5;
    const glm::dvec3 size = box.upper - box.lower, away = ray.origin - 0.5 * (box.lower + box.upper);
    if (!(glm::dot(away, away) > kFar * kFar * glm::dot(size, size))) return 0.0;
    const double t = -glm::dot(away, ray.direction) / glm::dot(ray.direction, ray.direction);
    if (!(std::abs(t) < kInfinity)) return 0.0;
    ray.origin = fused_at(ray, t);
    return t;
}

/// Of two faces that a ray meets: at equal t the one in the first place, whatever the way there.
inline bool face_comes_first(double t, std::uint32_t face, double than_t, std::uint32_t than_face)
{
    return t < than_t || (t == than_t && face < than_face);
}

/// Calls f(t, face) for every face met with t_min <= t <= t_max; f returns the new t_max, a negative infinity ends it.
template <class F>
inline void mesh_crossings(const MeshShape& shape, const Ray& ray, double t_min, double t_max, F&& f)
{
    Ray near = ray;
    const double moved = move_near(shape.bounds(), near);
    double limit = t_max;
    traverse(shape.bvh(), RaySlabs(near), t_min - moved, t_max - moved, ~0u, [&](ChildWord leaf) {
        alignas(32) double t[4];
        for (std::uint32_t met = meet_triangles(shape.block(leaf.index()), near, t); met != 0; met &= met - 1) {
            const auto place = static_cast<std::uint32_t>(std::countr_zero(met));
            const double here = t[place] + moved;
            if (here >= t_min && here <= limit) limit = f(here, leaf.index() * 4 + place);
        }
        return limit - moved;
    });
}

}  // namespace csg
