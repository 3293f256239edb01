#pragma once

#include "numbers/functions/unit_again.h"
#include "render/texture/evaluate.h"

#include <array>

/// How a texture is read at a point, whoever asks: camera, shadow ray, photon, path or explanation.
namespace texture {

/// Textures with patterns that hold the one at hand, the outermost first: normals go through their spaces.
struct Enclosing {
    std::array<std::uint32_t, 16> textures;  ///< those past it are left out
    std::size_t count = 0;

    void enter(std::uint32_t texture)
    {
        if (count < textures.size()) textures[count++] = texture;
    }
    void leave_all() { count = through_ = 0; }

    /// A normal of the surface in the innermost space. Textures are entered and not left, and a hit has one normal, so
    /// it is carried on from where the last one was.
    glm::dvec3 into(const TextureSet& set, const glm::dvec3& n)
    {
        if (count == 0) return n;
        if (through_ == 0 || n != surface_) {
            surface_ = within_ = n;
            through_ = 0;
        }
        for (; through_ < count; ++through_) {
            const Texture& map = set.textures[textures[through_]];
            within_ = normal_into(set, set.patterns[map.pattern], within_, map.no_bump_scale);
        }
        return within_;
    }

private:
    glm::dvec3 surface_, within_;  ///< a normal, and what it is within so many textures: nothing while they are none
    std::size_t through_ = 0;
};

/// What a texture shows at a point: layers, or entries of a map or of an average.
struct Shown {
    const Texture& texture;  ///< of one of these kinds
    glm::dvec3 p;            ///< in the space of its layers or entries
    Blend blend{};           ///< of a map

    /// f(entry, its share of `share`) for the entries that are seen.
    template <class F>
    void each_entry(const TextureSet& set, float share, F&& f) const
    {
        if (texture.kind == Texture::Kind::Average) {
            float weights = 0;
            for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i) weights += set.keys[i];
            for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i)
                f(i, share * set.keys[i] / weights);
            return;
        }
        const auto upper = blend.lower == blend.upper ? 1.0f : static_cast<float>(blend.share);
        if (upper < 1.0f) f(blend.lower, share * (1.0f - upper));
        if (upper > 0.0f) f(blend.upper, share * upper);
    }
};

/// Goes through mappings and pictures of textures to where there is more than one way on.
inline Shown shown_at(const TextureSet& set, std::uint32_t index, glm::dvec3 p, const Surroundings& around,
                      Enclosing& enclosing)
{
    using Kind = Texture::Kind;
    while (true) {
        const Texture& texture = set.textures[index];
        if (texture.kind == Kind::Layers) return {texture, p};
        enclosing.enter(index);
        if (texture.kind == Kind::Uv) {
            // Transformations around a uv_mapping item move its normals, not its points (spec 4, 13).
            p = {around.uv.x, around.uv.y, 0.0};
            index = set.children[texture.first];
            continue;
        }
        const Pattern& pattern = set.patterns[texture.pattern];
        p = warp_point(set, pattern, p);
        if (texture.kind == Kind::Average) return {texture, p};
        if (texture.kind != Kind::Material)
            return {texture, p, blend_at(set, texture.first, texture.count, pattern_value(set, pattern, p, around))};
        index = material_at(set, texture, p);
    }
}

/// f(layers, p, share) for all layers that a texture shows at p; share: times how much of it is seen.
template <class F>
void each_layers(const TextureSet& set, std::uint32_t index, const glm::dvec3& p, const Surroundings& around,
                 Enclosing& enclosing, float share, F&& f)
{
    const Shown shown = shown_at(set, index, p, around, enclosing);
    if (shown.texture.kind == Texture::Kind::Layers) return f(shown.texture, shown.p, share);
    shown.each_entry(set, share, [&](std::uint32_t entry, float part) {
        each_layers(set, set.children[entry], shown.p, around, enclosing, part, f);
    });
}

/// The surface's normal as a layer bends it, carried through the patterns around it (spec 3, section 4). Of unit
/// length, but within texture maps with no_bump_scale: there it is as long as their transformations make it, and lit
/// so.
[[gnu::always_inline]] inline glm::dvec3 bent_normal(const TextureSet& set, std::uint32_t normal, glm::dvec3 n,
                                                     const glm::dvec3& p, Surroundings& around, Enclosing& enclosing)
{
    if (normal == kNone) return n;
    const auto map = [&](std::size_t i) -> const Texture& { return set.textures[enclosing.textures[i]]; };
    n = numbers::unit_again(perturb(set, normal, enclosing.into(set, n), p, around));
    for (std::size_t i = enclosing.count; i-- > 0;)
        n = normal_out_of(set, set.patterns[map(i).pattern], n, map(i).no_bump_scale);
    return n;
}

}  // namespace texture
