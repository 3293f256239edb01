#pragma once

#include <glm/glm.hpp>

#include <cstdint>

namespace trace {

/// POV-Ray's two-dimensional jitter: a pure function of the position, each component in [-0.5, 0.5) (spec 2, 1.1).
glm::dvec2 jitter(double x, double y);

/// The same for many positions; adds up to 7 of what lies behind them, so the arrays reach to a multiple of 8 (at most
/// 64) and hold numbers there.
void jitter(const double* x, const double* y, int count, double* jitter_x, double* jitter_y);

/// Pictures are far smaller than the range of an int; the cast truncates toward zero as the rules ask.
inline std::uint32_t truncated(double v) { return static_cast<std::uint32_t>(static_cast<std::int32_t>(v)); }

/// The permutation of 0 to 4095 behind it, at an index taken modulo 4096.
std::uint32_t permuted(std::uint32_t index);

}  // namespace trace
