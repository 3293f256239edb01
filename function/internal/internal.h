#pragma once

#include "function/program.h"

#include <vector>

/// The library behind `function { internal(n) }` (spec 5b, 16): formulas of functions.inc.
namespace function {

inline constexpr std::uint32_t kInternals = 80;
/// So many have a number that a scene may name; the others stand for one of them as POV-Ray 3.8 evaluates it.
inline constexpr std::uint32_t kNumbered = 79, kEnneper = 18, kWholeEnneper = 79;

/// Parameters besides x, y, z; n < kInternals.
std::uint32_t internal_parameters(std::uint32_t n);
/// Whether it needs Host::noise.
bool internal_asks_noise(std::uint32_t n);
/// a: x, y, z, then its parameters. `weights` of f_ridged_mf's octaves, if they are known (ridged_weights()).
double internal(std::uint32_t n, const double* a, const Host& host, const double* weights = nullptr);
/// What f_ridged_mf multiplies its octaves by, from the second one on: a number each, some tens of nanoseconds for
/// each.
std::vector<double> ridged_weights(double h, double lacunarity, double octaves);
inline constexpr std::uint32_t kRoundedBox = 60;
/// The numbers of functions that sum noise.
inline constexpr std::uint32_t kHeteroMultifractal = 29, kRidgedMultifractal = 59, kNoise = 76, kNoiseOfGenerator = 78;

}  // namespace function
