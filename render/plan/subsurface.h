#pragma once

#include <glm/glm.hpp>

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
    double operator()(double reflectance) const;

private:
    static constexpr std::size_t kSteps = 100;
    std::array<float, kSteps + 1> albedo_;
};

/// How much more light is sent back within than comes in: A of spec 6, 5.2. eta: relative index.
double internal_reflection(double eta);

/// The mean of 0.5 (1 + exp(-4/3 A q)) exp(-q) a at an albedo a, q = sqrt(3 (1 - a)).
double diffuse_reflectance(double albedo, double internal);

struct SubsurfacePlan {
    int diffuse_samples = 50, single_samples = 50;
    bool radiosity = false;
    double mm_per_unit = 10;
    std::vector<AlbedoTable> tables;        ///< one for each ior in use
    std::vector<std::uint32_t> table_of;    ///< by interior
    std::vector<glm::dvec3> directions;     ///< over the sphere, even; a sample's by its number
};

}  // namespace plan
