#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace solid {

/// The plane in which one coordinate has a value. Drawn as it is usually looked at in POV-Ray's left-handed space: x
/// from its positive side (z to the right, y up), y from above (x to the right, z up), z as a camera before it (x, y).
struct CuttingPlane {
    int axis = 1;
    double value = 0.0;

    int right() const { return axis == 0 ? 2 : 0; }
    int up() const { return axis == 1 ? 2 : 1; }
    glm::dvec3 direction(const glm::dvec2& d) const
    {
        glm::dvec3 out(0.0);
        out[right()] = d.x;
        out[up()] = d.y;
        return out;
    }
    glm::dvec3 point(const glm::dvec2& p) const
    {
        glm::dvec3 out = direction(p);
        out[axis] = value;
        return out;
    }
    glm::dvec2 flat(const glm::dvec3& p) const { return {p[right()], p[up()]}; }
};

/// A closed polyline, last point joined to the first. What it bounds is on its left.
using Loop = std::vector<glm::dvec2>;

}  // namespace solid
