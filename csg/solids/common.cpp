#include "csg/solids/common.h"

namespace csg {

Aabb padded(const Aabb& box)
{
    if (box.empty()) return box;
    const double largest = [&] {
        double m = 0.0;
        for (int i = 0; i < 3; ++i)
            for (const double v : {box.lower[i], box.upper[i]})
                if (std::isfinite(v)) m = std::max(m, std::abs(v));
        return m;
    }();
    const glm::dvec3 margin(8.0 * std::numeric_limits<double>::epsilon() * largest);
    return {box.lower - margin, box.upper + margin};
}

Aabb transformed_box(const Transform& frame, const Aabb& local)
{
    Aabb result;
    for (int corner = 0; corner < 8; ++corner)
        result.include(
            frame.point({corner & 1 ? local.upper.x : local.lower.x, corner & 2 ? local.upper.y : local.lower.y,
                         corner & 4 ? local.upper.z : local.lower.z}));
    return result;
}

Aabb ellipsoid_box(const glm::dmat3& linear, const glm::dvec3& center)
{
    glm::dvec3 half(0.0);
    for (int i = 0; i < 3; ++i) half[i] = std::hypot(linear[0][i], linear[1][i], linear[2][i]);
    return {center - half, center + half};
}

}  // namespace csg
