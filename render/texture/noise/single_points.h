#pragma once

#include "render/texture/points/points.h"

/// Lattice noise of many points in single precision, within 5e-7 of noise.h; for what is kept in single precision
/// anyway. The same bits for every instruction set, wherever a point lies among the others.
namespace texture {

/// The sums over the corners of the points' cells: of the component (0 to 2) of vector noise, or of noise before its
/// range is fitted (0). The points are padded.
void single_sums(const Points& p, std::size_t component, Values& out);

/// The components whose bits are set in `live` (1, 2, 4), others perhaps. Padded.
void single_vector_sums(const Points& p, unsigned live, Points& out);

}  // namespace texture
