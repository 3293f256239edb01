#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace trace::radiosity {

/// The directions of a pool in an order in which neighbours point nearly the same way, whatever part of the pool a
/// sample takes: along Hilbert's curve over the half of the sphere about +y, on which the pool lies evenly.
struct DirectionOrder {
    struct Entry {
        glm::dvec3 way;
        std::uint32_t number;  ///< of the direction, in the pool
    };
    std::vector<Entry> entries;
    std::vector<std::uint32_t> place;  ///< by direction: its entry

    DirectionOrder() = default;
    explicit DirectionOrder(const std::vector<glm::dvec3>& pool);
};

}  // namespace trace::radiosity
