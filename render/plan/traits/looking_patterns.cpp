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
    : set_(set), any_{any_uv(set), std::any_of(set.patterns.begin(), set.patterns.end(), looks_at_normal), false}
{
    if (!(any_.uv || any_.around)) return;
    for (const Pigment& pigment : set.pigments) pigments_.push_back(looks_of(pigment));
    for (const Normal& normal : set.normals) normals_.push_back(looks_of(normal));
    for (const Texture& texture : set.textures) parts_.push_back(looks_of(texture));
}

LookedAt TextureInputs::of_pigment(std::uint32_t index) const
{
    return pigments_.empty() ? LookedAt{} : pigments_[index];
}

LookedAt TextureInputs::of_texture(std::uint32_t index) const
{
    if (index == texture::kNone || parts_.empty()) return {};
    LookedAt out = parts_[index];
    const Texture& texture = set_.textures[index];
    if (texture.kind == Texture::Kind::Map) {
        out.bent = false;
        for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i)
            out.bent |= parts_[set_.children[i]].bent;
    }
    return out;
}

LookedAt TextureInputs::looks_of(const Texture& texture) const
{
    LookedAt out;
    if (texture.kind == Texture::Kind::Layers) {
        for (std::uint32_t i = texture.first; i < texture.first + texture.count; ++i) {
            const texture::Layer& layer = set_.layers[i];
            out |= pigments_[layer.pigment];
            if (layer.normal != texture::kNone) out |= normals_[layer.normal];
        }
    } else {
        const bool uv = texture.kind == Texture::Kind::Uv;
        if (texture.kind == Texture::Kind::Map) out = of_pattern(texture.pattern);
        out.uv |= uv;
        const std::uint32_t count = uv ? 1 : texture.count;
        for (std::uint32_t i = texture.first; i < texture.first + count; ++i) out |= parts_[set_.children[i]];
    }
    return out;
}

LookedAt TextureInputs::of_pattern(std::uint32_t index) const
{
    if (index == texture::kNone) return {};
    const Pattern& pattern = set_.patterns[index];
    if (pattern.kind == PatternKind::Function || pattern.kind == PatternKind::UserDefined) return any_;
    if (pattern.kind == PatternKind::PigmentPattern) return pigments_[pattern.pigment];
    const bool looks = looks_at_normal(pattern);
    return {pattern.kind == PatternKind::Uv, looks, looks};
}

LookedAt TextureInputs::looks_of(const Pigment& pigment) const
{
    using Kind = Pigment::Kind;
    const bool uv = pigment.kind == Kind::Uv;
    if (pigment.kind == Kind::Solid || pigment.kind == Kind::Image) return {};
    LookedAt out = uv || pigment.kind == Kind::Average ? LookedAt{} : of_pattern(pigment.pattern);
    out.uv |= uv;
    if (pigment.kind == Kind::ColorMap) return out;
    const std::uint32_t count = uv ? 1 : pigment.count;
    for (std::uint32_t i = pigment.first; i < pigment.first + count; ++i) out |= pigments_[set_.children[i]];
    return out;
}

LookedAt TextureInputs::looks_of(const Normal& normal) const
{
    using Map = Normal::Map;
    const bool uv = normal.map == Map::Uv;
    if (normal.map == Map::Image) return {};
    LookedAt out = uv || normal.map == Map::Average ? LookedAt{} : of_pattern(normal.pattern);
    out.uv |= uv;
    if (normal.map == Map::None || normal.map == Map::Slopes) return out;
    const std::uint32_t count = uv ? 1 : normal.count;
    for (std::uint32_t i = normal.first; i < normal.first + count; ++i) out |= normals_[set_.children[i]];
    return out;
}

}  // namespace plan
