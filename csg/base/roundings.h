#pragma once

#include "csg/base/types.h"

#include <cstdint>

namespace csg {

/// Whose last bits a number has where several formulas agree but for them: ours, which lose nothing however far away a
/// ray begins, or those of a POV-Ray (spec 5a, 11.3; 7d, 9).
enum class Roundings : std::uint8_t { Own, V37, V38 };

/// A vector at length 1: 3.7 multiplies by the reciprocal of its length, 3.8 divides (spec 7d, 6).
inline glm::dvec3 unit(const glm::dvec3& v, Roundings by)
{
    return by == Roundings::V37 ? glm::normalize(v) : v / glm::length(v);
}

}  // namespace csg
