#pragma once

#include "render/kernel/gather/near_leaves.h"
#include "render/kernel/gather/photon_places.h"

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
    double likely2 = 0;   ///< estimate of radius2 for a point nearby; 0: none
    glm::dvec3 asked{0};  ///< the point
    bool few = false;     ///< the point before had too few within the first radius
    NearLeaves leaves;    ///< those searched for the point before
    PhotonCell around;    ///< of the point before
    /// Scratch of the search: candidates, and room to partition them.
    std::vector<float> distances2, parted;
    std::vector<std::uint32_t> numbers;

    /// Drops what was kept from the point before; call before points that lie elsewhere.
    void forget()
    {
        likely2 = 0.0;
        few = false;
        leaves.forget();
        around = {};
    }
    double density_per_area() const { return static_cast<double>(found.size()) / radius2; }
};

}  // namespace trace
