#pragma once

#include "render/texture/texture_set.h"

#include <vector>

namespace plan {

/// What a texture looks at besides the point.
struct LookedAt {
    bool uv = false;      ///< surface coordinates
    bool around = false;  ///< directions: `slope`, `aoi` (texture::Surroundings)
    bool bent = false;    ///< directions, the normal as layers have bent it: what comes before all layers does not

    LookedAt& operator|=(const LookedAt& other)
    {
        uv |= other.uv;
        around |= other.around;
        bent |= other.bent;
        return *this;
    }
};

/// What the textures of a scene look at, each gone through once: what is inside of a map stands before it in the set.
/// Functions see no surface, so that what they ask is not bent; of the rest they are taken to look at what anything of
/// the scene does.
class TextureInputs {
public:
    explicit TextureInputs(const texture::TextureSet& set);

    /// Of a surface's texture; texture::kNone: nothing.
    LookedAt of_texture(std::uint32_t index) const;
    LookedAt of_pigment(std::uint32_t index) const;

private:
    LookedAt looks_of(const texture::Texture& texture) const;  ///< as a part of another
    LookedAt looks_of(const texture::Pigment& pigment) const;
    LookedAt looks_of(const texture::Normal& normal) const;
    LookedAt of_pattern(std::uint32_t index) const;

    const texture::TextureSet& set_;
    LookedAt any_;                                      ///< of all patterns, never bent
    std::vector<LookedAt> pigments_, normals_, parts_;  ///< by index; empty where nothing looks at anything
};

}  // namespace plan
