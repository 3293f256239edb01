#include "csg/base/types.h"
#include "numbers/functions/functions.h"

#include <cmath>

namespace csg {

bool Aabb::finite() const
{
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(lower[i]) || !std::isfinite(upper[i])) return false;
    return true;
}

bool Transform::identity() const { return linear == glm::dmat3(1.0) && offset == glm::dvec3(0.0); }

Transform Transform::translate(const glm::dvec3& by)
{
    Transform result;
    result.offset = by;
    result.inverse_offset = -by;
    return result;
}

Transform Transform::scale(const glm::dvec3& by)
{
    Transform result;
    for (int i = 0; i < 3; ++i) {
        result.linear[i][i] = by[i];
        result.inverse_linear[i][i] = 1.0 / by[i];
    }
    return result;
}

Transform Transform::rotate_degrees(const glm::dvec3& angles)
{
    const glm::dvec3 a = angles * (3.14159265358979323846 / 180.0);
    const glm::dvec3 c(numbers::cos(a.x), numbers::cos(a.y), numbers::cos(a.z)),
        s(numbers::sin(a.x), numbers::sin(a.y), numbers::sin(a.z));
    // Columns are the images of the axes; no snapping of multiples of 90 degrees, as in POV-Ray (spec 5a, 3.1).
    const glm::dmat3 rx({1, 0, 0}, {0, c.x, s.x}, {0, -s.x, c.x});
    const glm::dmat3 ry({c.y, 0, -s.y}, {0, 1, 0}, {s.y, 0, c.y});
    const glm::dmat3 rz({c.z, s.z, 0}, {-s.z, c.z, 0}, {0, 0, 1});
    Transform result;
    result.linear = rz * ry * rx;
    result.inverse_linear = glm::transpose(result.linear);
    return result;
}

Transform operator*(const Transform& outer, const Transform& inner)
{
    return {outer.linear * inner.linear, outer.linear * inner.offset + outer.offset,
            inner.inverse_linear * outer.inverse_linear,
            inner.inverse_linear * outer.inverse_offset + inner.inverse_offset};
}

}  // namespace csg
