#pragma once

#include <cstdint>
#include <vector>

namespace trace {

/// The photons found around a point, by number in the map.
struct NearPhotons {
    struct Near {
        double distance2;  ///< squared, stretched off the tangent plane
        std::uint32_t photon;
    };
    std::vector<Near> found;
    double radius2 = 0;  ///< of the sphere that holds them
    double likely2 = 0;  ///< what to expect of that for a point nearby; 0: nothing

    double density_per_area() const { return static_cast<double>(found.size()) / radius2; }
};

}  // namespace trace
