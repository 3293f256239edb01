#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace trace {

/// All photons in a sphere, side by side: points near its centre look at them alone. Places are from the centre.
struct PhotonVicinity {
    glm::dvec3 center{0};
    double reach = 0;  ///< its radius; 0: there is none
    std::vector<float> x, y, z;
    std::vector<std::uint32_t> photon;
};

/// The photons found around a point, by number in the map.
struct NearPhotons {
    struct Near {
        float distance2;  ///< squared, stretched off the tangent plane
        std::uint32_t photon;
    };
    std::vector<Near> found;
    double radius2 = 0;  ///< of the sphere that holds them
    double likely2 = 0;  ///< what to expect of that for a point nearby; 0: nothing
    PhotonVicinity vicinity;

    /// Before points that have nothing to do with those before.
    void forget() { likely2 = vicinity.reach = 0.0; }
    double density_per_area() const { return static_cast<double>(found.size()) / radius2; }
};

}  // namespace trace
