#pragma once

#include "render/scene/base/dump_writer.h"
#include "render/scene/textures/texture.h"

#include <numbers>
#include <optional>

namespace scene {

/// reference manual: Rainbow; spec 2, 17.
struct Rainbow {
    glm::dvec3 direction{0.0}, up{0, 1, 0};      ///< as written: not zero, not parallel
    double angle_deg = 0.0, width_deg = 0.0;     ///< of the bow's middle from `direction`; width 0: no bow
    double distance = 1e7;                       ///< scene units; 0: no bow
    double jitter = 0.0;                         ///< of the place in `colors`
    std::optional<double> arc_deg, falloff_deg;  ///< as written, whole angles about `direction`
    ColorMap colors;                             ///< from the inner edge, 0, to the outer, 1; empty: no bow
    SourceRef source;

    /// Half of the visible part and half of its unfaded part, radians from `up`. What is left out is more than all of
    /// it, and where only the arc is written nothing fades.
    double arc() const { return arc_deg ? *arc_deg * kHalf : kAll; }
    double falloff() const { return falloff_deg ? *falloff_deg * kHalf : arc(); }
    void dump(DumpWriter& out) const;

private:
    static constexpr double kHalf = std::numbers::pi / 360.0, kAll = 180.0;
};

}  // namespace scene
