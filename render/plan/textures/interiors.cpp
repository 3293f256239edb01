#include "render/plan/textures/interiors.h"

#include "render/scene/textures/texture.h"

#include <algorithm>

namespace plan {
namespace {

Interior converted(const scene::Interior& from)
{
    constexpr float kCausticsScale = 45.0f;  // keyword to exponent (spec 3, 9.3)
    Interior to;
    to.ior = from.ior;
    to.dispersion = from.dispersion;
    to.dispersion_samples = std::max(2, from.dispersion_samples);
    to.caustics_power = kCausticsScale * from.caustics;
    to.fade_distance = from.fade_distance;
    to.fade_power = from.fade_power;
    to.fade_color = from.fade_color;
    to.transmission = from.refraction;
    to.hollow = from.hollow;
    if (to.ior == 0.0f) {  // not given
        to.ior = 1.0f;
        to.dispersion = 1.0f;
    }
    return to;
}

/// Null: the texture is patterned, or has no layer.
const scene::Finish* top_finish(const scene::Texture* texture)
{
    const auto* layers = texture != nullptr ? std::get_if<std::vector<scene::Layer>>(&texture->kind) : nullptr;
    return layers != nullptr && !layers->empty() ? &*layers->back().finish : nullptr;
}

}  // namespace

bool has_old_finish(const scene::Texture* texture)
{
    const scene::Finish* finish = top_finish(texture);
    return finish != nullptr &&
           (finish->legacy_ior >= 0.0f || finish->legacy_caustics >= 0.0f || finish->legacy_refraction != 1.0f);
}

std::uint32_t InteriorCompiler::interior(const scene::Interior& description, std::uint32_t copy)
{
    if (copy >= known_.size()) known_.resize(copy + 1, kUnknown);
    std::uint32_t& index = known_[copy];
    if (index == kUnknown) {
        index = static_cast<std::uint32_t>(out_.size());
        out_.push_back(converted(description));
        out_[index].media = media_.list(description.media);
    }
    return index;
}

std::uint32_t InteriorCompiler::automatic()
{
    out_.emplace_back();
    return static_cast<std::uint32_t>(out_.size() - 1);
}

void InteriorCompiler::take_finish(std::uint32_t index, const scene::Texture* texture)
{
    const scene::Finish* finish = top_finish(texture);
    if (finish == nullptr) return;
    Interior& to = out_[index];
    to.transmission = finish->legacy_refraction;  // written or not
    if (finish->legacy_ior >= 0.0f) {
        to.ior = finish->legacy_ior == 0.0f ? 1.0f : finish->legacy_ior;
        to.dispersion = 1.0f;
    }
    if (finish->legacy_caustics >= 0.0f) to.caustics_power = finish->legacy_caustics;
}

}  // namespace plan
