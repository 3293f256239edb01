#pragma once

#include <glm/glm.hpp>

namespace trace {

/// POV-Ray's two-dimensional jitter: a pure function of the position, each component in [-0.5, 0.5) (spec 2, 1.1).
glm::dvec2 jitter(double x, double y);

}  // namespace trace
