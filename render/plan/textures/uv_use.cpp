#include "render/plan/textures/uv_use.h"

#include <algorithm>

namespace plan {

template <class Part>
bool UvUse::inside(const std::shared_ptr<const Part>& part)
{
    if (!part) return false;
    if (const auto known = known_.find(part.get()); known != known_.end()) return known->second;
    return known_.emplace(part.get(), uses(*part)).first->second;
}

template <class Entries>
bool UvUse::any_inside(const Entries& entries)
{
    return std::any_of(entries.begin(), entries.end(), [this](const auto& entry) { return this->inside(entry.value); });
}

bool UvUse::uses(const scene::Pattern& pattern) { return pattern.name == "uv_mapping" || inside(pattern.pigment); }

bool UvUse::uses(const scene::Pigment& pigment)
{
    const auto* patterned = std::get_if<scene::Shared<scene::PatternedPigment>>(&pigment.kind);
    if (!patterned) return false;
    const auto* pigments = std::get_if<scene::PigmentMap>(&(**patterned).map);
    return uses((**patterned).pattern) || (pigments && any_inside(*pigments));
}

bool UvUse::uses(const scene::Normal& normal)
{
    const auto* normals = std::get_if<std::vector<scene::MapEntry<scene::NormalPtr>>>(&normal.map);
    return uses(normal.pattern) || (normals && any_inside(*normals));
}

bool UvUse::uses(const scene::Texture& texture)
{
    if (const auto* patterned = std::get_if<scene::Shared<scene::PatternedTexture>>(&texture.kind))
        return uses((**patterned).pattern) || any_inside((**patterned).map);
    const auto& layers = std::get<std::vector<scene::Layer>>(texture.kind);
    return std::any_of(layers.begin(), layers.end(), [this](const scene::Layer& layer) {
        return uses(layer.pigment) || (layer.normal && uses(*layer.normal));
    });
}

}  // namespace plan
