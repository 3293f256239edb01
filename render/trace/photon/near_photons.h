#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace trace {

/// The photons found around a point, by number in the map.
struct NearPhotons {
    struct Near {
        float distance2;  ///< squared, stretched off the tangent plane
        std::uint32_t photon;
    };
    std::vector<Near> found;
    double radius2 = 0;   ///< of the sphere that holds them
    double likely2 = 0;   ///< what to expect of that for a point nearby; 0: nothing
    glm::dvec3 asked{0};  ///< the point
    bool few = false;     ///< the point before had too few within the first radius
    /// What the search keeps: photons that may be among them, and room to put some in order.
    std::vector<float> distances2, parted;
    std::vector<std::uint32_t> numbers;
    std::vector<std::int32_t> bins;

    /// Before points that have nothing to do with those before.
    void forget()
    {
        likely2 = 0.0;
        few = false;
    }
    double density_per_area() const { return static_cast<double>(found.size()) / radius2; }
};

}  // namespace trace
