#pragma once

#include "render/scene/base/dump_writer.h"
#include "render/scene/solids/curve.h"

#include <vector>

namespace scene {

/// The region between loops of a plane, swept along y (reference manual: Prism).
struct Prism {
    static constexpr std::string_view kKeywords[] = {"prism"};
    static constexpr bool kTakesSturm = true;

    Curve curve = Curve::Linear;
    bool conic = false;            ///< it grows with the height from nothing at 0; else it is the same at each height
    double low = 0.0, high = 1.0;  ///< heights of its ends, in the order written
    std::vector<glm::dvec2>
        points;         ///< (x, z), control points among them; a loop ends where its first point comes again
    bool open = false;  ///< without caps

    void dump(DumpWriter& out) const
    {
        if (conic) out.word("conic_sweep");
        out.word(name_of(curve));
        out.words("height", low, high);
        out.list("points", points);
        if (open) out.word("open");
    }
};

}  // namespace scene
