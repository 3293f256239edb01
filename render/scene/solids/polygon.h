#pragma once

#include "render/scene/base/dump_writer.h"

#include <vector>

namespace scene {

/// A flat region between loops of straight lines (reference manual: Polygon).
struct Polygon {
    static constexpr std::string_view kKeywords[] = {"polygon"};

    std::vector<glm::dvec3> points;  ///< as written: a loop ends where its first point comes again

    void dump(DumpWriter& out) const { out.list("points", points); }
};

}  // namespace scene
