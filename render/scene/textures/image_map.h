#pragma once

#include "render/scene/textures/image_source.h"
#include "render/scene/base/source_ref.h"
#include "render/scene/textures/volume.h"

#include <cstdint>
#include <vector>

namespace scene {

/// image_map, image_pattern, bump_map, material_map: a picture over a plane or around a solid (reference manual: Image
/// Map).
struct ImageMap {
    enum class Projection : std::uint8_t { Planar, Spherical, Cylindrical, Torus, Angular };
    enum class Interpolation : std::uint8_t { None, Bilinear, Bicubic, NormalizedDistance };
    /// What a pattern or bump takes of a pixel. Usual: what its user takes if nothing is written.
    enum class Use : std::uint8_t { Usual, Index, Color, Alpha };
    /// `filter` or `transmit`: added to the pixels', or written over those of a palette (spec 4, 12.3).
    struct Clarity {
        bool filter = false;       ///< else transmit
        std::optional<int> place;  ///< in the palette; nothing: all
        float amount = 0.0f;
    };

    ImageSource source;
    Projection projection = Projection::Planar;
    Interpolation interpolation = Interpolation::None;
    Use use = Use::Usual;
    bool once = false;                  ///< else it is repeated without end
    std::optional<bool> premultiplied;  ///< colours are times alpha; nothing: as the kind of file says
    std::optional<double> bump_size;    ///< of a bump_map
    glm::dvec2 repeat{1.0, 1.0}, offset{0.0, 0.0};
    std::vector<Clarity> clarities;  ///< in order
    SourceRef at;

    /// `map_type` and `interpolate` as numbers of the language; what a number does not name is left as it was.
    static constexpr int kProjections[] = {0, 1, 2, 5, 7};
    static constexpr int kInterpolations[] = {0, 2, 3, 4};
    void dump(DumpWriter& out) const;
};

/// A file of densities as a pattern's values (reference manual: Density File).
struct DensityFile {
    std::string path;
    std::shared_ptr<const Volume> volume;
    int interpolation = 0;  ///< 0 none, 1 trilinear, 2 tricubic
    SourceRef at;

    void dump(DumpWriter& out) const;
};

}  // namespace scene
