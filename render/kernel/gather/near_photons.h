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
    double likely2 = 0;   ///< what to expect of that for a point nearby; 0: nothing
    glm::dvec3 asked{0};  ///< the point
    bool few = false;     ///< the point before had too few within the first radius
    NearLeaves leaves;    ///< looked at for the point before
    PhotonCell around;    ///< of the point before
    /// What the search keeps: photons that may be among them, and room to put some in order.
    std::vector<float> distances2, parted;
    std::vector<std::uint32_t> numbers;

    /// Before points that have nothing to do with those before.
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
