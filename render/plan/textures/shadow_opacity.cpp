#include "render/plan/textures/pattern_kinds.h"
#include "render/plan/textures/textures.h"
#include "render/scene/textures/color_functions.h"

#include <algorithm>
#include <cmath>

/// Which pigments are opaque, and which POV-Ray takes to be that to rays of shadow (spec 3, 13.2). It asks when an
/// object is complete, before a picture in a map of pigments has been given its `filter` and `transmit all`, and
/// remembers what it found of each entry. Copies of a declared pigment share the entries of its map, so that the first
/// object that wears one has a black shadow and the others have not.
namespace plan {
namespace {

constexpr float kNearlyZero = 1e-10f;  // filter and transmit below it are none (spec 3, 13.2)

bool is_clear(const scene::Color& color)
{
    return std::abs(color.filter) > kNearlyZero || std::abs(color.transmit) > kNearlyZero;
}

}  // namespace

bool TextureCompiler::opaque(const texture::Pigment& pigment) const
{
    if (pigment.kind == texture::Pigment::Kind::Solid) return !is_clear(pigment.color);
    if (pigment.kind == texture::Pigment::Kind::Image) return out_.images[out_.patterns[pigment.pattern].data].opaque;
    if (pigment.kind == texture::Pigment::Kind::Functions) {
        const texture::ColorFunctions& parts = out_.color_functions[pigment.first];
        return parts[3] == texture::kNone && parts[4] == texture::kNone;
    }
    for (std::uint32_t i = pigment.first; i < pigment.first + pigment.count; ++i) {
        const bool opaque = pigment.kind == texture::Pigment::Kind::ColorMap ? !is_clear(out_.colors[i])
                                                                             : opaque_pigments_[out_.children[i]];
        if (!opaque) return false;
    }
    return true;
}

bool TextureCompiler::lets_light_through(const scene::Pigment& pigment)
{
    if (const auto* color = std::get_if<scene::Color>(&pigment.kind)) return is_clear(*color);
    const scene::PatternedPigment& patterned = *std::get<scene::Shared<scene::PatternedPigment>>(pigment.kind);
    if (const texture::Image* picture = picture_of(patterned)) return !picture->opaque;
    using Functions = std::shared_ptr<const scene::ColorFunctions>;
    if (const auto* functions = std::get_if<Functions>(&patterned.pattern.data)) return (*functions)->clear();
    if (const auto* colors = std::get_if<scene::ColorMap>(&patterned.map))
        return std::any_of(colors->begin(), colors->end(), [](const auto& entry) { return is_clear(entry.value); });
    bool clear = false;
    for (const auto& entry : std::get<scene::PigmentMap>(patterned.map))
        clear |= entry_lets_light_through(*entry.value);
    return clear;
}

bool TextureCompiler::entry_lets_light_through(const scene::Pigment& entry)
{
    if (const auto known = judged_.find(&entry); known != judged_.end()) return known->second;
    const bool clear = lets_light_through(entry);
    judged_.emplace(&entry, clear);
    const auto* patterned = std::get_if<scene::Shared<scene::PatternedPigment>>(&entry.kind);
    const texture::Image* picture = patterned ? picture_of(**patterned) : nullptr;
    return picture ? picture->clear_in_file : clear;
}

const texture::Image* TextureCompiler::picture_of(const scene::PatternedPigment& pigment)
{
    if (pigment.pattern.name != "image_map") return nullptr;
    const std::uint32_t picture = pattern_data(pigment.pattern, texture::PatternKind::Image);
    return picture == texture::kNone ? nullptr : &out_.images[picture];
}

}  // namespace plan
