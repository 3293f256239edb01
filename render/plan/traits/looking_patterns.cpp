#include "render/plan/traits/looking_patterns.h"

#include <algorithm>

namespace plan {
namespace {

using texture::Normal;
using texture::Pattern;
using texture::PatternKind;
using texture::Pigment;
using texture::Texture;
using texture::TextureSet;

bool any_uv(const TextureSet& set)
{
    const auto texture = [](const Texture& t) { return t.kind == Texture::Kind::Uv; };
    const auto pigment = [](const Pigment& p) { return p.kind == Pigment::Kind::Uv; };
    const auto normal = [](const Normal& n) { return n.map == Normal::Map::Uv; };
    const auto pattern = [](const Pattern& p) { return p.kind == PatternKind::Uv; };
    return std::any_of(set.textures.begin(), set.textures.end(), texture) ||
           std::any_of(set.pigments.begin(), set.pigments.end(), pigment) ||
           std::any_of(set.normals.begin(), set.normals.end(), normal) ||
           std::any_of(set.patterns.begin(), set.patterns.end(), pattern);
}

bool looks_at_normal(const Pattern& p) { return p.kind == PatternKind::Slope || p.kind == PatternKind::Aoi; }

}  // namespace

TextureInputs::TextureInputs(const TextureSet& set)
    : set_(set), any_{any_uv(set), std::any_of(set.patterns.begin(), set.patterns.end(), looks_at_normal), false},
      known_(set.textures.size()), seen_(set.textures.size())
{}

LookedAt TextureInputs::of_texture(std::uint32_t index)
{
    if (index == texture::kNone || !(any_.uv || any_.around)) return {};
    LookedAt out = of_part(index);
    const Texture& texture = set_.textures[index];
    if (texture.kind == Texture::Kind::Map) {
        out.bent = false;
        for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i)
            out.bent |= of_part(set_.children[i]).bent;
    }
    return out;
}

LookedAt TextureInputs::of_part(std::uint32_t index)
{
    if (seen_[index]) return known_[index];
    const Texture& texture = set_.textures[index];
    LookedAt out;
    if (texture.kind == Texture::Kind::Layers) {
        for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i) {
            out |= of_pigment(set_.layers[i].pigment);
            out |= of_normal(set_.layers[i].normal);
        }
    } else {
        const bool uv = texture.kind == Texture::Kind::Uv;
        if (texture.kind == Texture::Kind::Map) out = of_pattern(texture.pattern);
        out.uv |= uv;
        const std::uint32_t count = uv ? 1 : texture.count;
        for (std::uint32_t i = texture.first; i < texture.first + count; ++i) out |= of_part(set_.children[i]);
    }
    seen_[index] = true;
    return known_[index] = out;
}

LookedAt TextureInputs::of_pattern(std::uint32_t index) const
{
    if (index == texture::kNone) return {};
    const Pattern& pattern = set_.patterns[index];
    if (pattern.kind == PatternKind::Function) return any_;
    if (pattern.kind == PatternKind::PigmentPattern) return of_pigment(pattern.pigment);
    const bool looks = looks_at_normal(pattern);
    return {pattern.kind == PatternKind::Uv, looks, looks};
}

LookedAt TextureInputs::of_pigment(std::uint32_t index) const
{
    using Kind = Pigment::Kind;
    const Pigment& pigment = set_.pigments[index];
    const bool uv = pigment.kind == Kind::Uv;
    if (pigment.kind == Kind::Solid || pigment.kind == Kind::Image) return {};
    LookedAt out = uv || pigment.kind == Kind::Average ? LookedAt{} : of_pattern(pigment.pattern);
    out.uv |= uv;
    if (pigment.kind == Kind::ColorMap) return out;
    const std::uint32_t count = uv ? 1 : pigment.count;
    for (std::uint32_t i = pigment.first; i < pigment.first + count; ++i) out |= of_pigment(set_.children[i]);
    return out;
}

LookedAt TextureInputs::of_normal(std::uint32_t index) const
{
    using Map = Normal::Map;
    if (index == texture::kNone) return {};
    const Normal& normal = set_.normals[index];
    const bool uv = normal.map == Map::Uv;
    if (normal.map == Map::Image) return {};
    LookedAt out = uv || normal.map == Map::Average ? LookedAt{} : of_pattern(normal.pattern);
    out.uv |= uv;
    if (normal.map == Map::None || normal.map == Map::Slopes) return out;
    const std::uint32_t count = uv ? 1 : normal.count;
    for (std::uint32_t i = normal.first; i < normal.first + count; ++i) out |= of_normal(set_.children[i]);
    return out;
}

}  // namespace plan
