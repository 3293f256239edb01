#pragma once

#include "render/scene/textures/image_source.h"

namespace scene {

/// Terrain over the unit square (reference manual: Height Field).
struct HeightField {
    static constexpr std::string_view kKeywords[] = {"height_field"};
    static constexpr bool kTakesHierarchy = true;

    ImageSource source;
    double water_level = 0.0;    ///< below it nothing is drawn; share of the heights' range
    bool smooth = false;         ///< normals are blended
    bool premultiplied = false;  ///< colours are times alpha; heights have none

    void dump(DumpWriter& out) const
    {
        source.dump(out);
        out.changed("water_level", water_level, 0.0);
        if (smooth) out.words("smooth", 1.0);
    }
};

}  // namespace scene
