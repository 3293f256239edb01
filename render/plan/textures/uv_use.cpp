#include "render/plan/textures/uv_use.h"

#include <algorithm>

namespace plan {
namespace {

bool uses(const scene::Pigment& pigment);
bool uses(const scene::Normal& normal);
bool uses(const scene::Texture& texture);

bool uses(const scene::Pattern& pattern)
{
    return pattern.name == "uv_mapping" || (pattern.pigment && uses(*pattern.pigment));
}

template <class Entries>
bool any_uses(const Entries& entries)
{
    return std::any_of(entries.begin(), entries.end(),
                       [](const auto& entry) { return entry.value && uses(*entry.value); });
}

bool uses(const scene::Pigment& pigment)
{
    const auto* patterned = std::get_if<scene::Shared<scene::PatternedPigment>>(&pigment.kind);
    if (!patterned) return false;
    const auto* pigments = std::get_if<scene::PigmentMap>(&(**patterned).map);
    return uses((**patterned).pattern) || (pigments && any_uses(*pigments));
}

bool uses(const scene::Normal& normal)
{
    const auto* normals = std::get_if<std::vector<scene::MapEntry<scene::NormalPtr>>>(&normal.map);
    return uses(normal.pattern) || (normals && any_uses(*normals));
}

bool uses(const scene::Texture& texture)
{
    if (const auto* patterned = std::get_if<scene::Shared<scene::PatternedTexture>>(&texture.kind))
        return uses((**patterned).pattern) || any_uses((**patterned).map);
    const auto& layers = std::get<std::vector<scene::Layer>>(texture.kind);
    return std::any_of(layers.begin(), layers.end(), [](const scene::Layer& layer) {
        return uses(layer.pigment) || (layer.normal && uses(*layer.normal));
    });
}

}  // namespace

bool uses_uv(const scene::TexturePtr& texture) { return texture && uses(*texture); }

}  // namespace plan
