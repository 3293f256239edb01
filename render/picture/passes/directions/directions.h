#pragma once

#include <glm/glm.hpp>

#include <vector>

namespace trace::radiosity {

/// The directions that samples take theirs from, about +y, spread by its cosine (spec 6, 4.4): of the Halton sequence
/// of bases 2 and 3, or POV-Ray's own set for pools below 1600.
std::vector<glm::dvec3> directions(int pool);

}  // namespace trace::radiosity
