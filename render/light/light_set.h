#pragma once

#include "csg/base/types.h"
#include "render/light/projector.h"

#include <cstdint>
#include <memory>
#include <vector>

/// Lights as the tracer uses them: built once by plan/, read by every thread. Formulas: spec 3, section 12.
namespace light {

struct Light {
    enum class Kind : std::uint8_t { Point, Spot, Cylinder } kind = Kind::Point;
    bool parallel = false, shadowless = false;
    bool area = false, circular = false, orient = false, jitter = false, area_illumination = false;
    /// media_attenuation and media_interaction: fog and media of the whole scene dim it where there are some.
    bool atmosphere = false;
    bool dimmed_twice = false;  ///< area lights: what fills the scene dims all of the way twice (spec 6, 2.8)
    bool in_media = true;       ///< media_interaction, and not shadowless: media scatter it
    std::uint32_t group = 0;    ///< of the light_group that it stands in; 0: none
    glm::dvec3 location{0}, point_at{0, 0, 1};
    glm::dvec3 axis{0, 0, 1};  ///< unit, from location to point_at
    glm::vec3 color{1};
    double cos_radius = 0, cos_falloff = 0;  ///< Spot
    double radius = 0, falloff = 0;          ///< Cylinder: lengths
    double tightness = 0;
    double fade_distance = 0, fade_power = 0;  ///< fade_power 0: no fading
    bool fades_from_start = false;  ///< POV-Ray 3.8, where fade_distance is 0: one over the distance to the power
    glm::dvec3 axis1{0}, axis2{0};  ///< area light: edges
    int size1 = 1, size2 = 1, adaptive = 100;
    std::shared_ptr<const Projector> projector;  ///< projected_through; null: nothing

    /// Whether all lit points see the light at one position, so that their shadow rays form a beam.
    bool from_one_point() const { return !parallel && kind != Kind::Cylinder && !area && projector == nullptr; }
};

struct LightSet {
    std::vector<Light> lights;  ///< in order of declaration
};

}  // namespace light
