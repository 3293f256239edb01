#pragma once

#include "function/program.h"

/// The library behind `function { internal(n) }` (spec 5b, 16): formulas of functions.inc.
namespace function {

inline constexpr std::uint32_t kInternals = 79;

/// Parameters besides x, y, z; n < kInternals.
std::uint32_t internal_parameters(std::uint32_t n);
/// Whether it needs Host::noise.
bool internal_asks_noise(std::uint32_t n);
/// a: x, y, z, then its parameters.
double internal(std::uint32_t n, const double* a, const Host& host);

}  // namespace function
