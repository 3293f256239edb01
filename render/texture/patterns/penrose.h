#pragma once

#include <glm/vec2.hpp>

namespace texture {

/// The tilings 25 (pentagons, star, boat, diamond), 26 (kite and dart) and 27 (rhombs) at a point of the x-z plane:
/// 0 to 1, a range of its own for every shape, greatest at its edges (spec 4, 6.2).
double penrose(int kind, glm::dvec2 p);

}  // namespace texture
