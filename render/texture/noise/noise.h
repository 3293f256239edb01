#pragma once

#include <glm/glm.hpp>

#include <cstdint>

/// POV-Ray's noise functions, exactly (spec 4, sections 2 and 3).
namespace texture {

/// Scalar noise in [0, 1]; generator 1 (original), 2 (range corrected) or 3 (gradient noise).
double noise(const glm::dvec3& p, int generator);

/// Vector noise, about -1 to 1 per component; does not depend on a generator.
glm::dvec3 vector_noise(const glm::dvec3& p);

/// Sum of vector_noise(lambda^i p) omega^i over the octaves.
glm::dvec3 vector_turbulence(const glm::dvec3& p, int octaves, double lambda, double omega);

/// The scalar sum used inside agate, marble, the spirals, fog and iridescence.
double scalar_turbulence(const glm::dvec3& p, int octaves, double lambda, double omega, int generator);

/// Hash of an integer cell, 0 to 4095; arguments of any size (taken modulo 4096).
int cell_hash(long long x, long long y, long long z);

/// The i-th number in [0, 1) of the sequence behind cells, crackle, facets and black holes; i below 4100.
double pattern_random(int i);

/// One step of the linear congruential generator behind the tables; kept as 32 bits.
constexpr std::uint32_t next_lcg(std::uint32_t s) { return s * 1812433253u + 12345u; }

/// Source point and frequency i of `ripples` and `waves` (spec 4, 2.8); fills `count` of each.
void wave_sources(int count, glm::dvec3* points, double* frequencies);

}  // namespace texture
