#pragma once

#include "render/scene/base/dump_writer.h"

namespace scene {

/// The hull of two spheres, an egg along y (reference manual: Ovus).
struct Ovus {
    static constexpr std::string_view kKeywords[] = {"ovus"};
    static constexpr bool kTakesSturm = true;

    double bottom = 1.0, top = 0.5;  ///< radii of the spheres at the origin and at the height of `bottom`; not negative

    /// No room for an arc between the spheres: the upper one alone (spec 5a, 5.12).
    bool is_sphere() const { return top >= 2.0 * bottom; }
    void dump(DumpWriter& out) const { out.words("-", bottom, top); }
};

}  // namespace scene
