#pragma once

#include "numbers/functions/functions.h"

/// What amounts written with `albedo` are multiplied by: they are shares of the light sent out over all directions
/// (spec 3, 7.5 and 7.7).
namespace scene {

inline float diffuse_of_albedo(float brilliance) { return (brilliance + 1.0f) / 2.0f; }
inline float phong_of_albedo(float phong_size) { return (phong_size + 1.0f) / 2.0f; }

/// A roughness of 0 makes a constant highlight in POV-Ray (spec 3, 7.7).
inline float specular_exponent(float roughness) { return roughness == 0.0f ? 0.0f : 1.0f / roughness; }
inline float specular_of_albedo(float roughness)
{
    const auto n = static_cast<double>(specular_exponent(roughness));
    return static_cast<float>((n + 2.0) / (4.0 * (2.0 - numbers::pow(2.0, -n / 2.0))));
}

}  // namespace scene
