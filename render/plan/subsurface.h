#pragma once

#include "numbers/functions/functions.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

/// Light that goes through what lies below a surface: numbers of the whole scene (spec 6, 5).
namespace plan {

/// The share of light that is scattered rather than lost, by the share that comes back from the surface in the end.
class AlbedoTable {
public:
    /// internal: A of spec 6, 5.2.
    explicit AlbedoTable(double internal);
    /// reflectance: 0 to 1; what lies beyond counts as the end.
    double operator()(double reflectance) const
    {
        const double at = std::clamp(reflectance, 0.0, 1.0) * kSteps;
        const auto below = std::min(static_cast<std::size_t>(at), kSteps - 1);
        const double share = at - static_cast<double>(below);
        return (1.0 - share) * static_cast<double>(albedo_[below]) + share * static_cast<double>(albedo_[below + 1]);
    }

private:
    static constexpr std::size_t kSteps = 100;
    std::array<float, kSteps + 1> albedo_;
};

/// How much more light is sent back within than comes in: A of spec 6, 5.2. eta: relative index.
inline double internal_reflection(double eta)
{
    const double f = eta < 1.0 ? eta * eta - numbers::pow(eta, 2.25)
                               : ((1.0 - 1.0 / eta) + 3.0 * numbers::pow(1.0 - 1.0 / eta, 4.5)) / 4.0;
    return (1.0 + f) / (1.0 - f);
}

/// The mean of 0.5 (1 + exp(-4/3 A q)) exp(-q) a at an albedo a, q = sqrt(3 (1 - a)).
double diffuse_reflectance(double albedo, double internal);

struct SubsurfacePlan {
    int diffuse_samples = 50, single_samples = 50;
    bool radiosity = false;
    double mm_per_unit = 10;
    std::vector<AlbedoTable> tables;      ///< one for each ior in use
    std::vector<std::uint32_t> table_of;  ///< by interior
    std::vector<glm::dvec3> directions;   ///< over the sphere, even; a sample's by its number
};

}  // namespace plan
