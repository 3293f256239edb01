#pragma once

#include "csg/solids/solid_crossings.h"
#include "csg/items/world_data.h"

#include <cmath>

/// The way into an instance's world and back.
namespace csg {

/// A ray in an instance's space; directions there have unit length.
struct LocalRay {
    Ray ray;
    double length;  ///< of what a length of 1 here is there

    LocalRay(const Instance& one, const Ray& given)
        : ray(local_ray(one.frame, given)), length(std::sqrt(glm::dot(ray.direction, ray.direction)))
    {
        ray.direction /= length;
    }
};

/// A hit of an instance's world as one of ours. length: LocalRay's.
inline Hit here(const WorldData& world, const WorldItem& item, double length, Hit hit, double t_min, double t_max)
{
    hit.t = glm::clamp(hit.t / length, t_min, t_max);
    hit.surface = world.instance_surfaces[world.instances[item.instance].first_surface + hit.surface];
    hit.instance = item.instance & Hit::kNoInstance;
    return hit;
}

}  // namespace csg
