#pragma once

#include "render/texture/points/points.h"

#include <limits>

/// Noise of many points at once and sums of octaves of it. The bits are those of noise.h for each point.
namespace texture {

/// noise(p, generator) of each point. The points are padded.
void noise_points(const Points& p, int generator, Values& out);

/// The same of eight points, whose coordinates are aligned as those of Points; so is `out`.
void noise_eight(const double* x, const double* y, const double* z, int generator, double* out);

/// The components of vector_noise that `live` names (bit 0: x, 1: y, 2: z; not 0); the others are left as they were.
/// Padded.
void vector_noise_points(const Points& p, unsigned live, Points& out);

/// vector_turbulence of each point, live components. Padded; so is the result.
void vector_turbulence_points(const Points& p, int octaves, double lambda, double omega, unsigned live, Points& out);

/// scalar_turbulence of each point. Padded.
void scalar_turbulence_points(const Points& p, int octaves, double lambda, double omega, int generator, Values& out);

/// One term of a pattern that sums octaves: factor * p in the i-th octave, and what its noise n adds.
enum class OctaveSum { Granite, Wrinkles };

/// Ends of a map that are flat: values below `low` show its first entry, from `high` on its last one.
struct FlatEnds {
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
};

/// The values of granite or wrinkles (spec 4, 5.3). Padded. Of a value that lies in a flat end any other from this end
/// may be told.
void octave_points(const Points& p, OctaveSum kind, int generator, const FlatEnds& flat, Values& out);

/// The same of one point, its octaves side by side.
double octaves_at(const glm::dvec3& p, OctaveSum kind, int generator);

}  // namespace texture
