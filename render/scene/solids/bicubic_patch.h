#pragma once

#include "render/scene/base/dump_writer.h"

#include <array>

namespace scene {

/// A surface of sixteen control points (reference manual: Bicubic Patch). Both types draw the same.
struct BicubicPatch {
    static constexpr std::string_view kKeywords[] = {"bicubic_patch"};

    int type = 1;
    double flatness = 0.0;         ///< scene units: a part that is flatter is not divided further; 0: never
    int u_steps = 0, v_steps = 0;  ///< halvings at most along each parameter
    double accuracy = 0.01;        ///< of POV-Ray's type 2 and 3, which are no more
    bool has_uv = false;
    std::array<glm::dvec2, 4> uv{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};  ///< of its corners, round the patch
    std::array<glm::dvec3, 16> points{};                             ///< row by row

    void dump(DumpWriter& out) const
    {
        out.words("type", type);
        out.words("flatness", flatness);
        out.words("u_steps", u_steps);
        out.words("v_steps", v_steps);
        out.changed("accuracy", accuracy, BicubicPatch().accuracy);
        if (has_uv) out.list("uv_vectors", uv);
        out.list("points", points);
    }
};

}  // namespace scene
