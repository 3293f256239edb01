#pragma once

#include "csg/solids/shared/common.h"

#include <array>

namespace csg {

/// A flat or smooth triangle in world space: drawn, but bounds nothing, so no point is ever inside, inverted or not.
struct Triangle {
    glm::dvec3 corner{0.0}, edge1{1.0, 0.0, 0.0}, edge2{0.0, 1.0, 0.0};
    std::array<glm::dvec3, 3> normals{};  ///< at corner, corner + edge1, corner + edge2; used when smooth
    bool smooth = false;

    /// Barycentric weights of edge1 and edge2 and the parameter, by Cramer's rule after Moeller and Trumbore (1997).
    bool crossing(const Ray& ray, double& t) const
    {
        const glm::dvec3 n = glm::cross(edge1, edge2);
        const double determinant = -glm::dot(ray.direction, n);
        const glm::dvec3 from = ray.origin - corner;
        const glm::dvec3 q = glm::cross(from, ray.direction);
        const double u = glm::dot(edge2, q), v = -glm::dot(edge1, q);
        if (determinant > 0.0 ? !(u >= 0.0 && v >= 0.0 && u + v <= determinant)
                              : !(determinant < 0.0 && u <= 0.0 && v <= 0.0 && u + v >= determinant))
            return false;
        t = glm::dot(from, n) / determinant;
        return t > -kInfinity && t < kInfinity;
    }
    bool contains(const glm::dvec3&) const { return false; }
    bool contains_inverted(const glm::dvec3&) const { return false; }
    glm::dvec3 normal(const glm::dvec3& p, std::uint32_t) const;
    bool blends_normals() const { return smooth; }  ///< normal() may be another than the surface's
    Aabb bounds() const;

    static Triangle make(const std::array<glm::dvec3, 3>& vertices);
    static Triangle make(const std::array<glm::dvec3, 3>& vertices, const std::array<glm::dvec3, 3>& normals);

    static constexpr bool kClosed = false, kInverseClosed = false;
};

}  // namespace csg
