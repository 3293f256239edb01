#pragma once

#include "render/scene/base/dump_writer.h"
#include "render/scene/solids/curve.h"

#include <vector>

namespace scene {

/// A curve turned about y (reference manual: Lathe).
struct Lathe {
    static constexpr std::string_view kKeywords[] = {"lathe"};
    static constexpr bool kTakesSturm = true;

    Curve curve = Curve::Linear;
    std::vector<glm::dvec2> points;  ///< (distance from the axis, height), control points among them

    void dump(DumpWriter& out) const
    {
        out.word(name_of(curve));
        out.list("points", points);
    }
};

}  // namespace scene
