#pragma once

#include "render/explain/ray_tree.h"

/// What the two halves of RayTree share.
namespace explain {

/// A ray with what it inherits.
struct RayTree::Way {
    csg::Ray ray;
    double start = 0;
    const char* kind = "camera";
    plan::RayKind asks = plan::RayKind::Image;
    int level = 1;                  ///< levels in use with this ray
    float weight = 1;               ///< largest share of the pixel
    trace::InteriorList interiors;  ///< that it is inside of, in order of entry
};

/// A hit whose textures are gone through.
struct RayTree::Met {
    RayNode& node;
    const Way& way;
    const csg::Hit& hit;
    const plan::Surface& surface;
    texture::Surroundings around;
};

inline float most_of(const glm::vec3& c) { return glm::max(c.x, glm::max(c.y, c.z)); }

}  // namespace explain
