#pragma once

#include "render/scene/base/dump_writer.h"

namespace scene {

/// An arc turned about the line between two discs (POV-Ray 3.8; reference manual: Lemon).
struct Lemon {
    static constexpr std::string_view kKeywords[] = {"lemon"};
    static constexpr bool kTakesSturm = true;

    glm::dvec3 base{0, 0, 0}, cap{0, 1, 0};  ///< middles of the discs, not the same
    double base_radius = 0.0, cap_radius = 0.0;
    double arc_radius = 1.0;  ///< one that is too small was told and is the least that there is
    bool open = false;        ///< without the discs

    void dump(DumpWriter& out) const
    {
        out.words("-", base, base_radius, cap, cap_radius, arc_radius);
        if (open) out.word("open");
    }
};

}  // namespace scene
