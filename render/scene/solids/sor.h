#pragma once

#include "render/scene/base/dump_writer.h"

#include <vector>

namespace scene {

/// A rising curve turned about y, its radius squared a cubic of the height between two points (reference manual:
/// Surface of Revolution).
struct Sor {
    static constexpr std::string_view kKeywords[] = {"sor"};
    static constexpr bool kTakesSturm = true;

    std::vector<glm::dvec2> points;  ///< (distance from the axis, height); the first and the last are control points
    bool open = false;               ///< without caps

    void dump(DumpWriter& out) const
    {
        out.list("points", points);
        if (open) out.word("open");
    }
};

}  // namespace scene
