#pragma once

#include "render/scene/base/dump_writer.h"

#include <cstdint>
#include <vector>

namespace scene {

/// What a sphere covers whose centre and radius follow a spline (reference manual: Sphere Sweep).
struct SphereSweep {
    static constexpr std::string_view kKeywords[] = {"sphere_sweep"};

    enum class Spline : std::uint8_t { Linear, Cubic, B };
    struct SweptSphere {
        glm::dvec3 center{0.0};
        double radius = 1.0;
    };

    Spline spline = Spline::Linear;
    std::vector<SweptSphere> spheres;
    double tolerance = 1e-6;  ///< of POV-Ray's root finder; ours needs none

    void dump(DumpWriter& out) const
    {
        static constexpr std::string_view kNames[] = {"linear_spline", "cubic_spline", "b_spline"};
        out.word(kNames[static_cast<std::size_t>(spline)]);
        for (const SweptSphere& sphere : spheres) out.words("sphere", sphere.center, sphere.radius);
        out.changed("tolerance", tolerance, SphereSweep().tolerance);
    }
};

}  // namespace scene
