#pragma once

#include "bench/numerics/quad_polynomial.h"

#include <optional>

namespace numerics {

/// What `sign_changes` finds, without the turns: Descartes' rule in Bernstein's basis (Collins and Akritas, 1976)
/// proves in double precision (in 113 bits where that leaves a doubt), with bounds of its rounding, that a piece of
/// [low, high] holds no root or exactly one; that one is closed in on in 113 bits and the change of sign about it
/// confirmed. Knows nothing of what is judged. Empty where rounding leaves a doubt (roots that nearly touch): then
/// `sign_changes` has to be asked.
std::optional<std::vector<Quad>> isolated_sign_changes(const QuadPolynomial& p, Quad low, Quad high);

}  // namespace numerics
