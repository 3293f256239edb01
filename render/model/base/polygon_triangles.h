#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace model {

/// Triangles of places in the outline, counted from 0, that together are the polygon, in its sense of turning: a fan
/// where it is convex, else one ear after the other is cut off (Meisters). It should be flat and not cross itself; one
/// that does not keep to that becomes as many triangles all the same.
void triangulate(std::span<const glm::dvec3> outline, std::vector<std::array<std::uint32_t, 3>>& out);

}  // namespace model
