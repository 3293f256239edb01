#pragma once

#include "render/scene/description.h"

#include <initializer_list>

namespace plan {

/// What a quality (+Q) has of a picture (spec 3, 16). Everything after the plan asks these, never the number.
struct Quality {
    bool lights = true;        ///< from 2: lamps light surfaces; below, each shows the colour of its lowest layer
    bool shadows = true;       ///< from 4
    bool area_lights = true;   ///< from 5: below, they are points
    bool patterns = true;      ///< from 6: below, quick_color where there is one
    bool transmission = true;  ///< from 6: rays go on through surfaces
    bool reflection = true;    ///< from 8: and off them
    bool normals = true;       ///< from 8: bent ones
    bool effects = true;       ///< from 9: fog, rainbows, media, photons, radiosity, light below surfaces

    /// A number that no other set of them has.
    constexpr unsigned code() const
    {
        unsigned out = 0;
        for (const bool has : {lights, shadows, area_lights, patterns, transmission, reflection, normals, effects})
            out = 2 * out + (has ? 1u : 0u);
        return out;
    }
    /// \param level  0 to 11
    static constexpr Quality of(int level)
    {
        return {.lights = level >= 2,
                .shadows = level >= 4,
                .area_lights = level >= 5,
                .patterns = level >= 6,
                .transmission = level >= 6,
                .reflection = level >= 8,
                .normals = level >= 8,
                .effects = level >= 9};
    }
};

/// Whether surfaces light each other (spec 6, 1.5).
inline bool has_radiosity(const scene::GlobalSettings& global, const Quality& quality)
{
    return global.radiosity.has_value() && quality.effects;
}

}  // namespace plan
