#pragma once

#include "render/scene/base/dump_writer.h"

#include <optional>

namespace scene {

/// The hull of two spheres, an egg along y (reference manual: Ovus).
struct Ovus {
    static constexpr std::string_view kKeywords[] = {"ovus"};
    static constexpr bool kTakesSturm = true;

    double bottom = 1.0, top = 0.5;  ///< radii of the spheres at the origin and at the height of `bottom`; not negative

    /// POV-Ray 3.8: of the arc between the spheres, and how far their middles are apart; none: as usual.
    std::optional<double> radius, distance;
    double precision = 1e-4;  ///< of POV-Ray's root solver: ours has no use for it

    /// No room for an arc between the spheres: the upper one alone (spec 5a, 5.12).
    bool is_sphere() const { return top >= 2.0 * bottom; }
    double used_distance() const { return distance.value_or(bottom); }
    double used_radius() const { return radius.value_or(2.0 * (bottom > top ? bottom : top)); }
    void dump(DumpWriter& out) const
    {
        out.words("-", bottom, top);
        if (radius) out.words("radius", *radius);
        if (distance) out.words("distance", *distance);
    }
};

}  // namespace scene
