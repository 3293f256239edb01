#pragma once

#include "render/kernel/gather/photon.h"

#include <cmath>
#include <random>
#include <vector>

/// Photons around the origin, `flat` as high as wide.
inline std::vector<trace::Photon> random_photons(std::mt19937& random, std::size_t count, float flat)
{
    std::normal_distribution<float> off(0.0f, 1.0f);
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    std::vector<trace::Photon> out;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 place(off(random), off(random) * flat, off(random));
        const glm::vec3 flux(share(random), share(random), share(random));
        out.push_back(trace::make_photon(place, flux, glm::normalize(glm::dvec3(off(random), 1.0, off(random)))));
    }
    return out;
}
