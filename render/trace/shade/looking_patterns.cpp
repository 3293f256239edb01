#include "render/trace/shade/looking_patterns.h"

#include <algorithm>

namespace trace {
namespace {

using texture::Normal;
using texture::PatternKind;
using texture::Pigment;
using texture::Texture;
using texture::TextureSet;

/// Follows what textures are made of. Functions see no surface, so that what they ask does not look.
struct Looks {
    const TextureSet& set;

    bool pattern(std::uint32_t index) const
    {
        const texture::Pattern& of = set.patterns[index];
        return of.kind == PatternKind::Slope || of.kind == PatternKind::Aoi ||
               (of.kind == PatternKind::PigmentPattern && pigment(of.pigment));
    }
    template <class F>
    bool any(std::uint32_t first, std::uint32_t count, F&& f) const
    {
        return std::any_of(set.children.begin() + first, set.children.begin() + first + count, f);
    }
    bool pigment(std::uint32_t index) const
    {
        using Kind = Pigment::Kind;
        const Pigment& of = set.pigments[index];
        if (of.kind == Kind::Solid || of.kind == Kind::Image) return false;
        if (of.kind != Kind::Uv && of.kind != Kind::Average && pattern(of.pattern)) return true;
        if (of.kind == Kind::ColorMap) return false;
        return any(of.first, of.kind == Kind::Uv ? 1 : of.count, [&](std::uint32_t i) { return pigment(i); });
    }
    bool normal(std::uint32_t index) const
    {
        using Map = Normal::Map;
        const Normal& of = set.normals[index];
        if (of.map == Map::Image) return false;
        if (of.map != Map::Uv && of.map != Map::Average && pattern(of.pattern)) return true;
        if (of.map == Map::None || of.map == Map::Slopes) return false;
        return any(of.first, of.map == Map::Uv ? 1 : of.count, [&](std::uint32_t i) { return normal(i); });
    }
    bool layers(const Texture& of) const
    {
        return std::any_of(
            set.layers.begin() + of.first, set.layers.begin() + of.first + of.count, [&](const texture::Layer& layer) {
                return pigment(layer.pigment) || (layer.normal != texture::kNone && normal(layer.normal));
            });
    }
    /// root: its own pattern comes before all layers.
    bool texture(std::uint32_t index, bool root) const
    {
        using Kind = Texture::Kind;
        const Texture& of = set.textures[index];
        if (of.kind == Kind::Layers) return layers(of);
        if (of.kind == Kind::Map && !root && pattern(of.pattern)) return true;
        return any(of.first, of.kind == Kind::Uv ? 1 : of.count, [&](std::uint32_t i) { return texture(i, false); });
    }
};

}  // namespace

bool any_looks(const TextureSet& set)
{
    return std::any_of(set.patterns.begin(), set.patterns.end(), [](const texture::Pattern& p) {
        return p.kind == PatternKind::Slope || p.kind == PatternKind::Aoi;
    });
}

bool looks_at_bent(const TextureSet& set, std::uint32_t texture) { return Looks{set}.texture(texture, true); }

}  // namespace trace
