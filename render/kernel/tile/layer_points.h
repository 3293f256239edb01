#pragma once

#include "render/texture/evaluate_points.h"

namespace trace {

/// Normals as layers bend them, of unit length.
struct BentNormals {
    texture::Values x, y, z;

    glm::dvec3 at(std::size_t k) const { return {x[k], y[k], z[k]}; }
    void set(std::size_t k, const glm::dvec3& n)
    {
        x[k] = n.x;
        y[k] = n.y;
        z[k] = n.z;
    }
};

/// A layer of one texture at some hits: its pigment, and its normal as it bends it.
struct LayerPoints {
    texture::ColorPoints colors;
    BentNormals normals;
};

/// Pigments of the layers of one hit, and normals of those that bend them; what layers above hide is not there.
struct PrefetchedPigments {
    std::uint32_t texture, layers;
    const LayerPoints* top;  ///< those below behind it
    std::size_t hit;         ///< its place there
    bool bent = true;        ///< the normals are known

    scene::Color of(std::uint32_t layer) const { return top[layers - 1 - layer].colors.at(hit); }
    glm::dvec3 normal(std::uint32_t layer) const { return top[layers - 1 - layer].normals.at(hit); }
};

}  // namespace trace
