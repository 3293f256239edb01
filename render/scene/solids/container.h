#pragma once

#include "render/scene/base/dump_writer.h"

namespace scene {

/// contained_by { box { corners } } or { sphere { center, radius } }.
struct Container {
    enum class Kind { Unwritten, Box, Sphere } kind = Kind::Unwritten;  ///< Unwritten: the box
    glm::dvec3 corner[2] = {glm::dvec3(-1.0), glm::dvec3(1.0)};         ///< in the order written
    glm::dvec3 center{0.0};
    double radius = 1.0;

    void dump(DumpWriter& out) const
    {
        if (kind == Kind::Sphere) out.words("contained_by sphere", center, radius);
        if (kind == Kind::Box) out.words("contained_by box", corner[0], corner[1]);
    }
};

}  // namespace scene
