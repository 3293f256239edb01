#pragma once

#include "render/trace/subsurface/scattering.h"

#include <cstdint>
#include <vector>

namespace trace {

/// A row that waits for light from below.
struct SubsurfaceSite {
    std::size_t lane, row;
    std::uint32_t interior;
    glm::dvec3 point, normal, viewer;  ///< unit; the normal faces the viewer
    Scattering matter;
    std::uint64_t seed;
    glm::dvec3 base;  ///< rays are sent from there
    glm::dvec3 diffuse{0}, single{0}, unscattered{0};
    int met = 0;  ///< rays that met something

    double cosine() const { return glm::dot(normal, viewer); }
};

/// The viewer's ray below the surface.
struct WayBelow {
    glm::dvec3 direction, end, normal;
    double length;    ///< mm
    bool open, same;  ///< it goes in; it ends at the same object
};

/// What light below surfaces keeps per thread; grows to what the scene needs and stays.
struct SubsurfaceScratch {
    std::vector<SubsurfaceSite> sites;
    std::vector<WayBelow> ways;  ///< by site
};

}  // namespace trace
