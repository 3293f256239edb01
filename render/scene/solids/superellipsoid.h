#pragma once

#include "render/scene/base/dump_writer.h"

namespace scene {

/// (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) <= 1 (reference manual: Superquadric Ellipsoid).
struct Superellipsoid {
    static constexpr std::string_view kKeywords[] = {"superellipsoid"};

    glm::dvec2 powers{1.0};  ///< e, east to west; n, north to south

    void dump(DumpWriter& out) const { out.words("-", powers); }
};

}  // namespace scene
