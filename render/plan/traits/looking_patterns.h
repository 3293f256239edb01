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

/// What the textures of a scene look at, each gone through once. Functions see no surface, so that what they ask is not
/// bent; of the rest they are taken to look at what anything of the scene does.
class TextureInputs {
public:
    explicit TextureInputs(const texture::TextureSet& set);

    /// Of a surface's texture; texture::kNone: nothing.
    LookedAt of_texture(std::uint32_t index);
    LookedAt of_pigment(std::uint32_t index) const;

private:
    LookedAt of_part(std::uint32_t index);
    LookedAt of_pattern(std::uint32_t index) const;
    LookedAt of_normal(std::uint32_t index) const;

    const texture::TextureSet& set_;
    LookedAt any_;                 ///< of all patterns, never bent
    std::vector<LookedAt> known_;  ///< by texture, as a part of another, where seen_
    std::vector<bool> seen_;
};

}  // namespace plan
